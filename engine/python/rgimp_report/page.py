"""The page: what is on it, filled into page.html.jinja."""

import base64
import io
import os
from pathlib import Path

import jinja2
from rgimp_plot import output, pictures

from . import case_tables, commands, curve_data, growth_data, remarks

FOLDER = Path(__file__).resolve().parent
DPI = 110  # example 1's pictures take 0.15 MB at it, and 0.4 MB at the 200 of rgimp-plot
ALTERNATIVE_TEXTS = {
    "crack.png": "Failed particles at the end of the run",
    "stress.png": "Maximum principal stress before the first failure",
    "slices.png": "Failed particles on three slices through the specimen",
    "growth.png": "Failed particles at several steps",
}


def render(result, directory, command):
    """`command` is rgimp, which measures the cracks."""
    # Everything from a case or a file is escaped: titles may hold anything.
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(FOLDER), autoescape=True,
                                     undefined=jinja2.StrictUndefined, trim_blocks=True,
                                     lstrip_blocks=True)
    environment.filters["number"] = case_tables.format_value
    cracks = commands.measure_cracks(command, directory)
    growth = growth_data.of(result)
    last = result.snapshot(result.steps()[-1])
    values = {
        "title": result.title(), "summary": result.summary, "first": result.first_failure_step(),
        "dimension": result.dimension(), "particles": last.count(),
        "tables": case_tables.of(result.case, directory),
        "case_text": output.read_text(directory / "case.toml", str), "pictures": draw(result),
        "growth": growth, "curves": curve_data.of(result), "cracks": cracks,
        "machine": commands.describe_machine(command),
        "remarks": remarks.of(result, growth, cracks), "style": asset("page.css"),
        "scripts": [asset(name) for name in ("growth.js", "curves.js", "page.js")]}
    try:
        return environment.get_template("page.html.jinja").render(values)
    except (jinja2.UndefinedError, TypeError, ValueError) as error:
        raise output.OutputError(f"{directory / 'summary.json'} is damaged: {error}") from None


def asset(name):
    """Our own text: the one thing on the page that is not escaped."""
    return jinja2.utils.markupsafe.Markup((FOLDER / name).read_text(encoding="utf-8"))


def draw(result):
    """The pictures of rgimp-plot as data URLs, but for the curves, which the page draws itself."""
    drawn = []
    for name, figure in pictures.of(result, None, None).items():
        if name in ALTERNATIVE_TEXTS:
            image = io.BytesIO()
            figure().savefig(image, dpi=DPI, metadata={"Software": None})
            url = "data:image/png;base64," + base64.b64encode(image.getvalue()).decode()
            drawn.append({"name": name, "url": url, "text": ALTERNATIVE_TEXTS[name]})
    return drawn


def write(path, text):
    """All of it or nothing."""
    unfinished = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        if path.is_dir():
            raise IsADirectoryError(0, "it is a directory")
        path.parent.mkdir(parents=True, exist_ok=True)
        unfinished.write_text(text, encoding="utf-8")
        unfinished.replace(path)
    except (OSError, ValueError) as error:
        unfinished.unlink(missing_ok=True)
        reason = getattr(error, "strerror", None) or error
        raise output.OutputError(f"cannot write {path}: {reason}") from None
