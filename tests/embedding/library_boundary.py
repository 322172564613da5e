#!/usr/bin/python3
"""The library must not end, print to or change the process that it is part of, nor keep a state.

Reads what the objects of static libraries call and keep. Usage: library_boundary.py OBJDUMP
LIBRARY...
"""

import re
import subprocess
import sys

# What a library leaves to its application, as the linker sees it.
FORBIDDEN = {
    "ends the process": "exit _exit _Exit quick_exit abort __assert_fail raise kill",
    "prints": "stdout stderr printf vprintf puts putchar perror __printf_chk "
              "std::cout std::cerr std::clog std::wcout std::wcerr",
    "changes the process": "setlocale std::locale::global chdir fchdir umask signal sigaction "
                           "setenv putenv unsetenv fesetround feenableexcept fesetenv setrlimit "
                           "srand srandom atexit std::set_terminate std::set_new_handler",
    "reads a state of the process": "rand random environ",
}
# Objects with a state, and why they are there.
STATES = {
    "rgimp::(anonymous namespace)::hdf5_mutex": "HDF5 is one library for the whole process",
}
READS_ENVIRONMENT = {"simulation.cpp.o"}  # RGIMP_ISA, and nothing else
MAY_CHANGE = re.compile(r"^\.(data|bss|tbss|tdata)(?!\.rel\.ro)")
CONSTANT = re.compile(r"::k[A-Z]\w*$")  # as this project names them
ENTRY = re.compile(
    r"^[0-9a-f]+ (?P<flags>.{7}) (?P<section>\S+)\t[0-9a-f]+ +(\.hidden )?(?P<name>.*)$")


def symbols(objdump, library):
    """(object, flags, section, name) of every symbol."""
    listing = subprocess.run([objdump, "--syms", "--demangle", library], check=True,
                             capture_output=True, text=True).stdout
    member = None
    for line in listing.splitlines():
        if ":     file format" in line:
            member = line.split(":")[0]
        elif entry := ENTRY.match(line):
            yield member, entry["flags"], entry["section"], entry["name"]


def complaint(member, flags, section, name):
    called = name.split("(")[0].split("@")[0]
    if section == "*UND*":
        for what, names in FORBIDDEN.items():
            if called in names.split():
                return f"{member} {what}: {name}"
        if called == "getenv" and member not in READS_ENVIRONMENT:
            return f"{member} reads the environment"
    is_object = "O" in flags or section.startswith((".tdata", ".tbss"))
    if is_object and "rgimp::" in name and MAY_CHANGE.match(section):
        if not CONSTANT.search(name) and name not in STATES:
            return f"{member} keeps a state of the whole process: {name}"
    return None


def main():
    objdump, *libraries = sys.argv[1:]
    found = [symbol for library in libraries for symbol in symbols(objdump, library)]
    if not any("rgimp::Simulation" in name for *_, name in found):
        sys.exit("these libraries hold no rgimp::Simulation: nothing was checked")
    missing = STATES.keys() - {name for *_, name in found}
    complaints = [text for symbol in found if (text := complaint(*symbol))]
    complaints += [f"no longer there: {name}" for name in sorted(missing)]
    sys.exit("\n".join(complaints) or None)


if __name__ == "__main__":
    main()
