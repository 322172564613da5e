#!/usr/bin/env bash
# What a stranger does, in a new Debian root with nothing but the packages of `cpack`:
# clean_root.sh BUILD. Needs root and the machine's own package sources; says how long each part took.
# shellcheck source-path=SCRIPTDIR source=new_root.sh
source "$(dirname "${BASH_SOURCE[0]}")/new_root.sh"

build=$(cd "$1" && pwd)

timed() { # WHAT COMMAND...
  local start=$EPOCHREALTIME
  step "$1"
  "${@:2}"
  awk -v what="$1" -v from="$start" -v to="$EPOCHREALTIME" \
    'BEGIN { printf "   %s took %.1f s\n", what, to - from }'
}

step "Packages (cpack)"
cpack --config "$build/CPackConfig.cmake" -B "$place/packages" >"$place/cpack.log" ||
  { cat "$place/cpack.log" && fail "cpack failed"; }
ls -l "$place"/packages/*.deb

make_root
mkdir --parents "$root/packages"
cp "$place"/packages/*.deb "$root/packages"
cp "$rgimp_root/tests/package/find_package/"* "$root/packages"

timed "Installing rgimp" quietly apt-get install --yes --no-install-recommends \
  /packages/"$(basename "$place"/packages/rgimp_*.deb)"
timed "rgimp info" inside rgimp info
timed "A case to start from" inside rgimp new single-flaw -o case.toml
timed "Its picture" inside rgimp check case.toml --picture specimen.png
timed "A run of 2,000 steps" inside rgimp run case.toml -o run --steps 2000 --quiet
timed "Pictures of it" inside rgimp-plot run
timed "A report" inside rgimp report run
timed "Another angle" inside rgimp run case.toml -o steep --set 'flaw[0].angle=60' --steps 200 --quiet
timed "A sweep" inside rgimp sweep case.toml -o angles --set 'flaw[0].angle=30:60:15' --steps 100
timed "A sweep from Python" inside python3 -c '
import rgimp
for angle in (30, 60):
    simulation = rgimp.Simulation(rgimp.read_case("case.toml", [f"flaw[0].angle={angle}"]))
    simulation.run_until(100)
    print(angle, simulation.history().axial_stress, "Pa")'
for file in specimen.png run/pictures run/report.html angles/sweep.csv; do
  [[ -s $root/tmp/$file ]] || fail "no $file"
done

timed "Installing librgimp-dev, compiler and CMake" quietly apt-get install --yes \
  --no-install-recommends /packages/"$(basename "$place"/packages/librgimp-dev_*.deb)" \
  g++ cmake make pkg-config
timed "A program by find_package" inside sh -c \
  'cmake -S /packages -B find >/tmp/cmake.log && cmake --build find >/tmp/cmake.log && find/outside run/case.toml'
timed "A program by pkg-config" inside sh -c \
  'g++ -std=c++20 /packages/main.cpp -o by_pkg_config $(pkg-config --cflags --libs rgimp) && ./by_pkg_config run/case.toml'
hash=$(grep --only-matching '"state_hash": "[0-9a-f]*"' "$root/tmp/run/summary.json" | cut --delimiter='"' --fields=4)
for program in find/outside ./by_pkg_config; do
  [[ $(inside "$program" run/case.toml) == "$hash" ]] || fail "$program computes something else"
done

timed "Removing both" quietly apt-get purge --yes rgimp librgimp-dev
left=$(find "$root/usr" -iname '*rgimp*' -not -path '*/__pycache__*')
[[ -z $left ]] || fail "left behind: $left"
echo "The packages install, work and go."
