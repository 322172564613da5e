"""Parts of a case, as documentation shows them, put into a whole case."""

import json


def merge(base, part):
    """Tables are merged key by key; anything else, lists of tables too, is replaced."""
    merged = dict(base)
    for key, value in part.items():
        both = isinstance(value, dict) and isinstance(base.get(key), dict)
        merged[key] = merge(base[key], value) if both else value
    return merged


def to_toml(value):
    """As one inline value."""
    if isinstance(value, dict):
        entries = (f"{json.dumps(key)} = {to_toml(entry)}" for key, entry in value.items())
        return "{" + ", ".join(entries) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(to_toml, value)) + "]"
    return json.dumps(value)


def case_text(case):
    return "".join(f"{json.dumps(key)} = {to_toml(value)}\n" for key, value in case.items())
