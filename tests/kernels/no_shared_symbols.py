#!/usr/bin/python3
"""Kernels compiled for different ISAs must share no weak symbols.

The linker keeps one copy of a weak symbol (an inline function, a template): were it the one
compiled for AVX-512, the program would crash on a machine without it. Usage:
no_shared_symbols.py NM LIBRARY
"""

import collections
import itertools
import subprocess
import sys

WEAK = "vVwWuiI"  # of nm's letters


def weak_symbols_by_member(nm, library):
    """Defined weak symbols of each object of a static library."""
    listing = subprocess.run(
        [nm, "--defined-only", "--format=posix", library], check=True, capture_output=True, text=True
    ).stdout
    members = collections.defaultdict(set)
    member = None
    for line in listing.splitlines():
        if line.endswith("]:"):
            member = line[line.rindex("[") + 1 : -2]
            members[member]  # a member without symbols counts too
        elif line:
            name, kind = line.split()[:2]
            if kind in WEAK:
                members[member].add(name)
    return members


def main():
    members = weak_symbols_by_member(*sys.argv[1:3])
    isas = {name: symbols for name, symbols in members.items() if name.startswith("isa_")}
    if len(isas) < 3:
        sys.exit(f"expected the objects of at least three ISAs, found {sorted(members)}")
    shared = False
    others = {name: symbols for name, symbols in members.items() if name not in isas}
    for (one, ours), (other, theirs) in itertools.chain(
        itertools.combinations(isas.items(), 2), itertools.product(isas.items(), others.items())
    ):
        for symbol in sorted(ours & theirs):
            print(f"{one} and {other} share the weak symbol {symbol}")
            shared = True
    sys.exit(1 if shared else 0)


if __name__ == "__main__":
    main()
