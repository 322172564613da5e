"""The checks there are. A module of `checks` registers its own with @check."""

import importlib
import pkgutil
from dataclasses import dataclass
from typing import Callable

from . import checks

_checks = {}


@dataclass(frozen=True)
class Check:
    """`function(study, short)` yields rows; with `short` only those that take seconds."""
    name: str
    title: str
    minutes: float  # of two cores
    short: bool     # has a part that the tests run
    function: Callable
    text: str       # its docstring: what is checked, and how

    def run(self, study, short):
        return list(self.function(study, short))


def check(name, title, minutes, short=False):
    def register(function):
        if name in _checks:
            raise ValueError(f"two checks are called {name}")
        _checks[name] = Check(name, title, minutes, short, function, function.__doc__ or "")
        return function
    return register


def load():
    """All checks by name, in the order of their modules' `ORDER`, then of their names."""
    modules = [importlib.import_module(f"{checks.__name__}.{module.name}")
               for module in pkgutil.iter_modules(checks.__path__)]
    order = {module.__name__: getattr(module, "ORDER", 100) for module in modules}
    return dict(sorted(_checks.items(), key=lambda item: (
        order.get(item[1].function.__module__, 100), item[0])))


def listing(found):
    width = max(map(len, found), default=0)
    return "\n".join(f"{check.name:{width}}  {check.minutes:4.1f} min"
                     f"{'  short' if check.short else '       '}  {check.title}"
                     for check in found.values())
