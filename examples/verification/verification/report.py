"""Rows kept as JSON, one file a check, and the page made of all of them."""

import dataclasses
import inspect
import json
import platform
from datetime import date

from .table import ABSOLUTE, AT_LEAST, AT_MOST, INSIDE, RELATIVE, REPORT, Row

HEADER = """# Results of the verification

`bash examples/verification/run.sh` makes this page and its pictures; `--list` names the checks, and
`run.sh NAME...` runs some of them. Verdicts are computed from result, reference and tolerance
(`verification/table.py`). *Reported* rows have no reference to be held against.

"""


def save(folder, check, rows, place):
    results = folder / "results"
    results.mkdir(parents=True, exist_ok=True)
    kept = {"check": check.name, "date": date.today().isoformat(),
            "version": sorted({run["version"] for run in place.used}),
            "isa": sorted({run["isa"] for run in place.used}), "processor": processor(),
            "rows": [dataclasses.asdict(row) for row in rows]}
    text = json.dumps(kept, indent=1, ensure_ascii=False, default=float)
    (results / f"{check.name}.json").write_text(text + "\n", encoding="utf-8")


def processor():
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as lines:
            return next(line.split(":")[1].strip() for line in lines
                        if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.machine()


def write_page(folder, checks):
    """RESULTS.md, of all checks whose rows are kept."""
    kept = {}
    for name, check in checks.items():
        path = folder / "results" / f"{name}.json"
        if path.exists():
            record = json.loads(path.read_text(encoding="utf-8"))
            kept[name] = (check, record, [Row(**row) for row in record["rows"]])
    overview = ["| check | met | missed | reported |", "|---|---:|---:|---:|"]
    for check, _, rows in kept.values():
        overview.append(f"| [{check.title}](#{check.name}) | {count(rows)} |")
    everything = [row for _, _, rows in kept.values() for row in rows]
    overview.append(f"| **all** | {count(everything)} |")
    sections = [section(folder, *entry) for entry in kept.values()]
    (folder / "RESULTS.md").write_text(HEADER + "\n".join(overview) + "\n\n" + "\n".join(sections),
                                       encoding="utf-8")


def count(rows):
    verdicts = [row.verdict for row in rows]
    return " | ".join(str(verdicts.count(verdict)) for verdict in ("met", "missed", "reported"))


def section(folder, check, kept, rows):
    lines = [f'<a id="{check.name}"></a>', "", f"## {check.title}", "",
             inspect.cleandoc(check.text), "",
             "| case | quantity | reference | source | result | error | allowed | verdict |",
             "|---|---|---:|---|---:|---:|---:|---|"]
    lines += [markdown_row(row) for row in rows]
    notes = list(dict.fromkeys(f"- {row.case}, {row.quantity}: {row.note}"
                               for row in rows if row.note))
    lines += ["", *notes] if notes else []
    for picture in sorted((folder / "pictures").glob(f"{check.name}*.png")):
        lines += ["", f"![{check.title}](pictures/{picture.name})"]
    lines += ["", f"Check `{check.name}`, {kept['date']}, {kept['processor']}, "
              f"{', '.join(kept['isa'])}.", ""]
    return "\n".join(lines)


def markdown_row(row):
    unit = f", {row.unit}" if row.unit not in ("", "1") else ""
    verdict = f"**{row.verdict}**" if row.verdict == "missed" else row.verdict
    cells = [row.case, row.quantity + unit, reference_of(row), row.source, number(row.result),
             error_of(row), allowed(row), verdict]
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def text_table(rows):
    cells = [[row.case, row.quantity, number(row.result), row.unit, "reference " + reference_of(row),
              error_of(row), row.verdict] for row in rows]
    widths = [max(map(len, column)) for column in zip(*cells)] if cells else []
    return "\n".join("   " + "  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip()
                     for line in cells)


def number(value):
    if isinstance(value, str) or value is None:
        return value or "–"
    if isinstance(value, (list, tuple)):
        return " to ".join(map(number, value))
    if isinstance(value, bool) or float(value).is_integer() and abs(value) < 1e9:
        return f"{int(value):,}"
    return f"{value:.4g}"


def reference_of(row):
    sign = {AT_MOST: "≤ ", AT_LEAST: "≥ "}.get(row.kind, "")
    return sign + number(row.reference)


def error_of(row):
    if row.kind == RELATIVE:
        return "" if row.error is None else f"{100 * row.error:+.2f} %"
    return f"{row.error:+.3g}" if row.kind == ABSOLUTE and row.error is not None else ""


def allowed(row):
    if row.kind == RELATIVE:
        return f"{100 * row.tolerance:g} %"
    if row.kind == ABSOLUTE:
        return f"{row.tolerance:g}"
    return "" if row.kind == REPORT else {INSIDE: "inside"}.get(row.kind, "")
