#!/usr/bin/env bash
# Installs what is missing, builds the release preset and runs every test.
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

step "Packages (tests/install_dependencies.sh)"
bash "$rgimp_root/tests/install_dependencies.sh"
build_release
step "Test (ctest --preset release)"
ctest --preset release --no-tests=error
echo "All tests passed."
