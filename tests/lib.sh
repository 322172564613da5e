# shellcheck shell=bash
# Shared by the shell scripts; source it, do not run it.
# An error stops the script and names the step that failed.
set -Eeuo pipefail

rgimp_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
rgimp_step="start"

step() {
  rgimp_step=$1
  echo "== $1"
}

fail() {
  echo "error: $*" >&2
  exit 1
}

report_error() {
  if ((BASH_SUBSHELL == 0)); then
    echo "error: \"$rgimp_step\" failed with exit code $1 (see the lines above)" >&2
  fi
  exit "$1"
}
trap 'report_error $?' ERR

# Configures and builds the release preset; cheap where nothing changed.
build_release() {
  cd "$rgimp_root"
  step "Configure (cmake --preset release)"
  cmake --preset release
  step "Build (cmake --build --preset release)"
  cmake --build --preset release
}
