#!/usr/bin/python3
"""Writes rgimp's man page from the help of its verbs: make_page.py RGIMP > rgimp.1

The page is kept beside this script, so that a build needs no Python; a test compares the two.
"""

import re
import subprocess
import sys

HEAD = r""".\" Made by make_page.py from rgimp --help; do not edit.
.TH RGIMP 1 "" "{version}" "User Commands"
.\" Names of keys and files stay whole.
.nh
.ad l
.SH NAME
rgimp \- simulate how rock breaks
.SH SYNOPSIS
.B rgimp
.I VERB
[\fIOPTION\fR]...
.SH DESCRIPTION
{description}
Cases are TOML files in SI units; every verb has
.BR \-\-help .
"""
TAIL = r""".SH ENVIRONMENT
.TP
.B RGIMP_ISA
The instruction set: reference, baseline, avx2 or avx512; by default the widest of the machine.
.TP
.B NO_COLOR
If it is set and not empty, nothing is coloured; without it, messages on terminals are.
.TP
.B TMPDIR
Where
.B rgimp check \-\-picture
keeps the specimen while it is drawn; by default /tmp.
.SH FILES
In the output directory of a run:
.TP
.I case.toml
The case with every default filled in; it runs again as it is.
.TP
.I history.csv
Closure, axial stress, energies and failed particles over the steps.
.TP
.I snapshots/
The particles, as VTKHDF files that ParaView opens.
.TP
.IR checkpoint_a.rgimp ", " checkpoint_b.rgimp
The whole state, written in turn;
.B rgimp run \-\-resume
goes on from the newer one.
.TP
.I summary.json
First failure, peak stress, energy error, speed, and a hash of the final state.
.PP
A sweep's directory has such a directory for each case, and a table of them all,
.IR sweep.csv .
.SH SEE ALSO
.BR rgimp\-plot ,
which draws the pictures of an output directory, and
.BR rgimp\-report ,
which
.B rgimp report
runs.
"""


def help_of(*command):
    return subprocess.run([*command, "--help"], capture_output=True, text=True, check=True).stdout


def escape(text):
    text = text.replace("\\", r"\e").replace("-", r"\-")
    return re.sub(r"(?m)^(?=[.'])", r"\\&", text)


def items(text, section):
    """Pairs of name and description of a section of a help text."""
    found = re.search(rf"(?m)^{section}:\n((?:  .*\n)+)", text)
    entries = []
    for line in found[1].splitlines() if found else ():
        if line.startswith("   "):  # the description of a name that fills its column
            entries[-1][1] += " " + line.strip()
        else:
            entries.append(re.split(r"  +", line.strip(), maxsplit=1))
            entries[-1] += [""] * (2 - len(entries[-1]))
    return [(name, description.strip()) for name, description in entries]


def paragraphs(text):
    """Of what comes after a help text's sections."""
    last = list(re.finditer(r"(?m)^(Options|Subcommands):\n(?:  .*\n)+", text))[-1]
    return text[last.end():].strip().split("\n\n")


def formatted(footer):
    page = []
    for paragraph in footer:
        before, examples, after = paragraph.partition("Examples:\n")
        if before:
            page += [".PP", escape(before.strip())]
        if examples:
            page += [".PP", "Examples:", ".PP", ".EX", escape(after.rstrip()), ".EE"]
    return page


def section_of(command, verb, description):
    text = help_of(command, verb)
    usage = re.search(r"(?m)^Usage: (.*)$", text)[1]
    page = [f".SS {escape(usage)}", escape(description) + "."]
    for name, meaning in items(text, "Positionals") + items(text, "Options"):
        page += [".TP", f".B {escape(name)}", escape(meaning)]
    return page + formatted(paragraphs(text))


def page_of(command):
    text = help_of(command)
    version = subprocess.run([command, "--version"], capture_output=True, text=True,
                             check=True).stdout.strip()
    page = [HEAD.format(version=version, description=escape(text.splitlines()[0])).rstrip()]
    page.append(".SH VERBS")
    for verb, description in items(text, "Subcommands"):
        page += section_of(command, verb, description)
    examples, *exit_codes = paragraphs(text)
    page += [".SH EXAMPLES", ".EX", escape(examples.removeprefix("Examples:\n")), ".EE",
             ".SH EXIT STATUS", *formatted(exit_codes)[1:]]
    return "\n".join(page) + "\n" + TAIL


if __name__ == "__main__":
    sys.stdout.write(page_of(sys.argv[1]))
