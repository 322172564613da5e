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
