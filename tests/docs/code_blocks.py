"""The fenced code blocks of a Markdown file, and what comments before them ask for.

`<!-- steps=20 -->` shortens the runs of a block, `<!-- skip: why -->` leaves it out.
"""

import re
from dataclasses import dataclass

BLOCK = re.compile(r"(?ms)^(?:<!-- (?P<mark>[^\n]*?) -->\n+)?```(?P<language>\w*)\n"
                   r"(?P<text>.*?)^```$")
MARKS = re.compile(r"steps=(\d+)|skip: (.+)")


@dataclass
class CodeBlock:
    place: str  # file:line
    language: str  # empty: what a command prints
    text: str
    steps: str  # empty: as they are
    skipped: str  # why; empty: run


def read(path, root):
    page = path.read_text(encoding="utf-8")
    return [make(found, f"{path.relative_to(root)}:{page.count(chr(10), 0, found.start('text'))}")
            for found in BLOCK.finditer(page)]


def make(found, place):
    marks = MARKS.fullmatch(found["mark"]) if found["mark"] else None
    if found["mark"] and not marks:
        raise ValueError(f"{place}: a mark is \"steps=N\" or \"skip: why\", not {found['mark']}")
    steps, skipped = marks.groups(default="") if marks else ("", "")
    return CodeBlock(place, found["language"], found["text"], steps, skipped)
