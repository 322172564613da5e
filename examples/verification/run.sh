#!/usr/bin/env bash
# Verifies the method against numbers it did not produce:
#   examples/verification/run.sh [--list] [--short] [--threads N] [CHECK...]
# Installs what is missing, builds, runs the checks named (all of them without a name) and writes
# examples/verification/RESULTS.md with its pictures. All checks take under an hour on two cores;
# --short runs the parts that tests run, in under a minute. Runs already there, of the same case by
# the same program, are read again.
source "$(dirname "${BASH_SOURCE[0]}")/../../tests/lib.sh"

verify=$rgimp_root/examples/verification/verify.py
for argument in "$@"; do
  case $argument in -h | --help | --list) exec "$verify" "$@" ;; esac
done

step "Packages (tests/install_dependencies.sh)"
bash "$rgimp_root/tests/install_dependencies.sh"
build_release
step "Verify (examples/verification/verify.py)"
"$verify" "$@"
