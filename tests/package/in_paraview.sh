#!/usr/bin/env bash
# Opens a run's snapshots and grids in ParaView: in_paraview.sh BUILD. In a new root, as root: the
# packages of ParaView and those of VTK for the other tests exclude each other.
# shellcheck source-path=SCRIPTDIR source=new_root.sh
source "$(dirname "${BASH_SOURCE[0]}")/new_root.sh"

rgimp=$(cd "$1" && pwd)/bin/rgimp
make_root
step "ParaView"
quietly apt-get install --yes --no-install-recommends paraview python3-paraview xvfb xauth
step "A run and its grids"
"$rgimp" run "$rgimp_root/tests/support/breaking_block.toml" -o "$root/tmp/run" --quiet
"$rgimp" grid "$root/tmp/run" >"$place/grids"
cp "$rgimp_root/tests/package/open_in_paraview.py" "$root/tmp"
step "Open them (pvbatch open_in_paraview.py)"
# ParaView comes to the display, leaves and comes again: a server that resets between is not there.
inside xvfb-run --auto-servernum --server-args="-screen 0 800x800x24 -noreset" \
  pvbatch open_in_paraview.py run crack.png
[[ -s $root/tmp/crack.png ]] || fail "no picture"
