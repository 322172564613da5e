#!/usr/bin/env bash
# Installs the Debian packages RGIMP is built, tested and drawn with. Returns at once, without apt,
# where they are all there. Packages named as arguments, of stages outside the gate, come on top.
# shellcheck source-path=SCRIPTDIR source=lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/lib.sh"

packages=(
  # build
  g++ cmake ninja-build pkg-config
  # libraries
  libeigen3-dev libtbb-dev libxsimd-dev libhdf5-dev libtomlplusplus-dev libcli11-dev libfmt-dev
  nlohmann-json3-dev libxxhash-dev pybind11-dev python3-dev
  # tests and benchmarks
  catch2 libbenchmark-dev python3-vtk9 groff-base chromium chromium-driver python3-selenium
  python3-pandas # of a recipe in engine/docs/data.md
  zsh fish # completion
  # pictures and reports
  python3 python3-numpy python3-h5py python3-matplotlib python3-jinja2
  "$@"
)

rgimp_step="Look up the installed packages"
for tool in dpkg-query apt-get; do
  command -v "$tool" >/dev/null ||
    fail "$tool not found: this script needs Debian 12. Elsewhere, install by hand what Debian" \
      "calls: ${packages[*]}"
done

# dpkg-query fails for names it never heard of; those are missing like the others.
installed=$(dpkg-query --show --showformat='${Package} ${db:Status-Status}\n' "${packages[@]}" \
  2>/dev/null || true)
missing=()
for package in "${packages[@]}"; do
  grep --quiet --line-regexp --fixed-strings "$package installed" <<<"$installed" ||
    missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  echo "All ${#packages[@]} Debian packages are installed."
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null ||
    fail "these packages are missing: ${missing[*]}. Installing them needs root, or sudo."
  as_root=(sudo)
fi
as_root+=(env DEBIAN_FRONTEND=noninteractive) # no questions

# Without --error-on=any, apt-get update passes over servers it cannot reach.
step "Update the package lists (apt-get update, as root)"
"${as_root[@]}" apt-get update --quiet --quiet --error-on=any ||
  fail "apt-get update failed. Is the network up? Are the sources in /etc/apt right?"
step "Install (apt-get install, as root): ${missing[*]}"
"${as_root[@]}" apt-get install --quiet --yes --no-install-recommends "${missing[@]}" ||
  fail "apt-get install failed for: ${missing[*]}. The package names are those of Debian 12."
