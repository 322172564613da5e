"""The case as tables; units come from the comments that rgimp writes into case.toml."""

import re

from rgimp_plot import output

# `key = value   # unit, meaning`, the comments of the resolved case.
UNIT = re.compile(r"^(?:# )?(\w+) =[^#]*# (kg/m3|m/s2|m/s|J/m2|m|Pa|s|degrees|steps|rows)\b", re.M)
LISTS = (("body", "Bodies"), ("flaw", "Flaws"), ("platen", "Platens"))
NUMERICS = ("grid", "damping", "viscosity", "body_force", "numerics", "tuning", "output")


def of(case, directory):
    """Tables of a title, column names and rows. A case that cannot be laid out is damaged."""
    units = dict(UNIT.findall(output.read_text(directory / "case.toml", str)))
    try:
        tables = [materials(case, units)]
        tables += [table_of(title, case.get(key, []), units) for key, title in LISTS]
        tables.append(values("Time", [("", case.get("time", {}))], units))
        tables.append(values("Grid, numerics and output",
                             [(f"{name}.", case.get(name, {})) for name in NUMERICS], units))
    except (AttributeError, TypeError, ValueError) as error:
        raise output.OutputError(f"{directory / 'case.toml'} is damaged: "
                                 f"{type(error).__name__} {error}") from None
    return [table for table in tables if table["rows"]]


def materials(case, units):
    flat = []
    for name, material in case.get("material", {}).items():
        failure = material.get("failure", {})
        flat.append({"name": name}
                    | {key: value for key, value in material.items() if key != "failure"}
                    | dict(failure.items()))
    return table_of("Materials", flat, units)


def table_of(title, entries, units):
    """A row of the table for each key, as entries are few and keys are many."""
    keys = list(dict.fromkeys(key for entry in entries for key in entry))
    rows = [[with_unit(key, units), *(format_value(entry.get(key)) for entry in entries)]
            for key in keys]
    return {"title": title, "rows": rows}


def values(title, groups, units):
    rows = [[with_unit(prefix + key, units), format_value(value)]
            for prefix, group in groups for key, value in group.items()]
    return {"title": title, "rows": rows}


def with_unit(key, units):
    unit = units.get(key.split(".")[-1])
    return f"{key} ({unit})" if unit else key


def format_value(value):
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int):
        return f"{value:,}"
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, list):
        return ", ".join(map(format_value, value))
    return str(value)
