# SPDX-License-Identifier: BSD-3-Clause
"""Options by keyword, with their names and texts from the library's table."""

from __future__ import annotations

import textwrap
from typing import Any, Callable, Dict, Iterable, List, NamedTuple, Tuple, TypeVar

import numpy as np

from . import _surfmesh
from ._errors import InvalidOption

Settings = List[Tuple[str, str]]


class Option(NamedTuple):
    """An option of a run, as `surfmesh.options()` lists it."""

    name: str
    group: str
    kind: str
    unit: str
    text: str
    range: str
    words: List[str]
    default: str


def options() -> List[Option]:
    """All options of a run, those of sizes first, with texts, ranges and defaults."""
    return [Option(**entry) for entry in _surfmesh.options()]


def settings_of(keywords: Dict[str, Any]) -> Settings:
    """Keywords as the library takes options: None leaves the default."""
    settings = []
    for name, value in keywords.items():
        text = "" if value is None else _text(name, value)
        if value is None:
            _surfmesh.check_option(name, _default(name))
            continue
        _surfmesh.check_option(name, text)
        settings.append((name, text))
    return settings


def _default(name: str) -> str:
    for option in _surfmesh.options():
        if option["name"] == name:
            return option["default"]
    return ""


def _text(name: str, value: Any) -> str:
    if isinstance(value, (bool, np.bool_)):
        return "on" if value else "off"
    if isinstance(value, str):
        return value
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    raise InvalidOption(f"{name} = {value!r} is no number, text, True or False")


def describe(groups: Iterable[str]) -> str:
    """The part of a docstring that tells the options of some groups."""
    lines = []
    for group in groups:
        lines.append(f"Options of {'the ' if group != 'meshing' else ''}{group}:")
        for option in options():
            if option.group == group:
                text = f"{option.name}: {option.text} ({option.range}; {option.default})"
                lines += textwrap.wrap(text, 96, initial_indent="  ", subsequent_indent="      ")
    return "\n".join(lines)


Function = TypeVar("Function", bound=Callable[..., Any])


def documented(*groups: str) -> Callable[[Function], Function]:
    """Add the options of some groups to the docstring of a function."""

    def add(function: Function) -> Function:
        function.__doc__ = f"{function.__doc__}\n{describe(groups)}\n"
        return function

    return add
