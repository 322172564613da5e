#!/usr/bin/env bash
# Runs a case of the paper from nothing to pictures: examples/run.sh [CASE.toml]
# Installs what is missing, builds, runs the case into out/NAME and draws out/NAME/pictures.
# A run that is already there, of the same case by the same program, is only drawn again.
source "$(dirname "${BASH_SOURCE[0]}")/../tests/lib.sh"

(($# <= 1)) || fail "usage: examples/run.sh [CASE.toml]"
case_file=$(realpath --canonicalize-missing -- "${1:-$rgimp_root/examples/single_flaw.toml}")
[[ -f $case_file ]] || fail "no case file at $case_file"

step "Packages (tests/install_dependencies.sh)"
bash "$rgimp_root/tests/install_dependencies.sh"
build_release

program=$rgimp_root/build/release/bin/rgimp
[[ -x $program ]] || fail "the build made no $program"
name=$(basename "$case_file" .toml)
output=$rgimp_root/out/$name
stamp=$rgimp_root/out/$name.sha256 # of a finished run: what went in and what came out
if sha256sum --check --status "$stamp" 2>/dev/null; then
  echo "== $output is complete for this case and program: not run again"
else
  step "Run $case_file (example 1 takes a few minutes)"
  mkdir -p "$rgimp_root/out"
  rm -f "$stamp"
  "$program" run "$case_file" -o "$output" --force
  sha256sum "$case_file" "$program" "$output"/{case.toml,history.csv,summary.json} >"$stamp.new"
  mv "$stamp.new" "$stamp"
fi

step "Draw (rgimp-plot)"
"$rgimp_root/engine/python/rgimp-plot" "$output"
echo "The pictures are in $output/pictures"
