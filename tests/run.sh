#!/usr/bin/env bash
# Checks RGIMP in stages: tests/run.sh [--list] [--help] [--all] [STAGE...]
# Without a name: the stages of the gate, minutes on two cores; --all: every stage, of which some
# take half an hour. Installs what is missing. --list: the stages.
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

# A new stage is a line here and a function stage_NAME below, with "-" of the name as "_". What it
# needs beyond the gate's Debian packages it installs itself: install_packages NAME...
stages=( # NAME | gate or nightly | what it does
  "tests|gate|every test of the release build"
  "sanitized|gate|case files, output, cracks, the command and a small run under ASan and UBSan"
  "fuzz|nightly|each fuzzer on its corpus and on for 10 s, under ASan and UBSan"
  "asan-ubsan|nightly|every test under AddressSanitizer and UndefinedBehaviorSanitizer"
  "tsan|nightly|every test under ThreadSanitizer; tests/tsan.supp lists what is let pass"
  "debug|nightly|every test of the debug build, whose warnings are errors"
  "valgrind|nightly|memcheck over the unit tests and a small run, its cracks included"
  "package|nightly|outside programs that build RGIMP by add_subdirectory and FetchContent"
  "clean-root|nightly|the Debian packages in a new root: install, run, link, remove (as root)"
  "paraview|nightly|snapshots and grids of a run in ParaView, in a new root (as root)"
  "docs|nightly|the site of engine/docs, whose warnings are errors, and its formulas in a browser"
  "tidy|nightly|clang-tidy over every source file"
)

install_packages() {
  step "Packages (tests/install_dependencies.sh $*)"
  bash "$rgimp_root/tests/install_dependencies.sh" "$@"
}

stage_tests() {
  build_release
  step "Test (ctest --preset release)"
  ctest --preset release --no-tests=error
}

# test_preset PRESET [CTEST_OPTION...]: builds all of a preset and runs its tests.
test_preset() {
  step "Configure and build ($1)"
  cmake --preset "$1"
  cmake --build --preset "$1"
  step "Test (ctest --preset $*)"
  ctest --preset "$@" --no-tests=error
}

# What reads and writes files, and a small run; none of the tests that take minutes when checked.
stage_sanitized() {
  local programs=(test_case_file test_output test_cracks)
  step "Configure and build (asan-ubsan: rgimp ${programs[*]})"
  cmake --preset asan-ubsan
  cmake --build --preset asan-ubsan --target rgimp "${programs[@]}"
  step "Test under AddressSanitizer and UndefinedBehaviorSanitizer"
  local program
  for program in "${programs[@]}"; do
    build/asan-ubsan/tests/"$program"
  done
  for program in requests cracks run; do
    step "The command's tests ($program)"
    /usr/bin/python3 -B tests/cli/test_"$program".py build/asan-ubsan/bin/rgimp
  done
  small_run build/asan-ubsan/bin/rgimp
}

stage_fuzz() {
  install_packages clang libclang-rt-dev
  bash "$rgimp_root/tests/fuzz/run.sh" case 10
  bash "$rgimp_root/tests/fuzz/run.sh" checkpoint 10
}

stage_asan_ubsan() { test_preset asan-ubsan; }
stage_tsan() { test_preset tsan; }
stage_debug() { test_preset dev; }

# small_run COMMAND...: a block that breaks, run to disk, its cracks, and a case that is refused.
small_run() {
  local place
  place=$(mktemp --directory)
  step "A small run and its cracks ($*)"
  "$@" run tests/support/breaking_block.toml -o "$place/run" --threads 2 --quiet
  "$@" cracks "$place/run" --json "$place/cracks.json" | tee "$place/cracks"
  grep --quiet "first failure at B" "$place/cracks" || fail "the cracks were not found"
  local code=0
  "$@" check tests/support/breaking_block.toml --set time.stepz=1 2>"$place/error" || code=$?
  cat "$place/error"
  ((code == 2)) || fail "exit code $code for a case with an unknown key; expected 2"
  grep --quiet stepz "$place/error" || fail "the unknown key was not named"
  rm -r "$place"
}

# The baseline kernels: valgrind 3.19 knows no AVX-512, and the machine it shows has none.
stage_valgrind() {
  install_packages valgrind
  build_release
  local memcheck=(valgrind --quiet --error-exitcode=9 --leak-check=full
    --show-leak-kinds=definite --errors-for-leak-kinds=definite)
  local program
  for program in test_case_file test_output test_cracks test_geometry test_binning test_command_text; do
    step "Memcheck of $program"
    RGIMP_ISA=baseline "${memcheck[@]}" build/release/tests/"$program"
  done
  RGIMP_ISA=baseline small_run "${memcheck[@]}" build/release/bin/rgimp
}

stage_package() {
  step "Outside programs that bring RGIMP's sources"
  /usr/bin/python3 -B tests/package/test_from_source.py cmake
}

stage_clean_root() {
  install_packages mmdebstrap
  build_release
  bash "$rgimp_root/tests/package/clean_root.sh" build/release
}

stage_paraview() {
  install_packages mmdebstrap
  build_release
  bash "$rgimp_root/tests/package/in_paraview.sh" build/release
}

# MathJax puts a merror where it does not know what a formula asks for.
stage_docs() {
  bash "$rgimp_root/engine/docs/build.sh"
  step "Formulas in a browser"
  local theory="file://$rgimp_root/out/docs/md_engine_docs_theory.html" dom
  dom=$(chromium --headless --no-sandbox --disable-gpu --virtual-time-budget=20000 \
    --dump-dom "$theory" 2>/dev/null)
  grep --quiet 'class="MathJax"' <<<"$dom" || fail "no formula was set"
  ! grep --quiet --extended-regexp 'class="(merror|noError)"' <<<"$dom" || fail "MathJax did not understand a formula of $theory"
}

# With the flags of the release build, file by file, but for those that clang does not know.
stage_tidy() {
  install_packages clang-tidy
  cmake --preset release -B build/tidy -DCMAKE_UNITY_BUILD=OFF
  sed --in-place 's/ --param=sra[^ "]*//; s/ -fno-tree-loop-distribution//' \
    build/tidy/compile_commands.json
  step "clang-tidy"
  git ls-files 'engine/*.cpp' 'kernels/*.cpp' 'bench/*.cpp' 'tests/*.cpp' 'examples/*.cpp' |
    grep --invert-match '^tests/package/\|^tests/fuzz/fuzz_' |
    xargs --max-procs="$(nproc)" --max-args=1 clang-tidy -p build/tidy --quiet \
      --warnings-as-errors='*' --extra-arg=-Wno-unknown-warning-option
}

list_stages() {
  local stage name when what
  for stage in "${stages[@]}"; do
    IFS='|' read -r name when what <<<"$stage"
    printf '%-14s %-8s %s\n' "$name" "$when" "$what"
  done
}

# The names of a part ("gate", "nightly"), or of all stages without one.
stages_of() {
  list_stages | awk -v part="${1:-}" 'part == "" || $2 == part { print $1 }'
}

chosen=()
for argument in "$@"; do
  case $argument in
    -h | --help) sed -n '2,4s/^# //p' "${BASH_SOURCE[0]}" && list_stages && exit 0 ;;
    --list) list_stages && exit 0 ;;
    --all) mapfile -t chosen < <(stages_of) ;;
    *)
      stages_of | grep --quiet --line-regexp --fixed-strings -e "$argument" ||
        fail "no stage \"$argument\"; there are: $(stages_of | paste --serial --delimiters=' ')"
      chosen+=("$argument")
      ;;
  esac
done
((${#chosen[@]})) || mapfile -t chosen < <(stages_of gate)

install_packages
cd "$rgimp_root"
for name in "${chosen[@]}"; do
  SECONDS=0
  "stage_${name//-/_}"
  echo "== Stage $name passed in $SECONDS s"
done
echo "All tests passed."
