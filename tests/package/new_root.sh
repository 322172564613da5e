# shellcheck shell=bash
# A new Debian root, from the sources this machine installs from, whatever they are; source it, do not
# run it. Needs root. What is in $place goes when the script ends.
# shellcheck source-path=SCRIPTDIR source=../lib.sh
source "$(dirname "${BASH_SOURCE[0]}")/../lib.sh"

((EUID == 0)) || fail "a new root can only be made as root"
place=$(mktemp --directory)
root=$place/root
trap 'rm --recursive --force --one-file-system "$place"' EXIT

make_root() {
  step "A new root"
  mmdebstrap --quiet --variant=apt --skip=cleanup/apt/lists bookworm "$root" \
    /etc/apt/sources.list.d/debian.sources
  cp /etc/resolv.conf /etc/hosts "$root/etc"
  cp /etc/apt/apt.conf.d/* "$root/etc/apt/apt.conf.d"
  mount --types proc proc "$root/proc"
  trap 'umount "$root/proc"; rm --recursive --force --one-file-system "$place"' EXIT
}

inside() { chroot "$root" env --chdir=/tmp LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }

# Shows what a command wrote only where it fails.
quietly() {
  local code=0
  inside "$@" >"$place/log" 2>&1 || code=$?
  ((code == 0)) || { tail --lines=20 "$place/log" && fail "$* exits $code"; }
}
