#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""For maintainers: print surfmesh/_options.pyi, whose keywords are those of the option table.

PYTHONPATH=build/release/python python3 -P tools/python/make_option_stub.py; with -P, the sources
beside this file are not taken for the module.
"""

import surfmesh

_TYPES = {
    "length": "Union[float, str]",
    "number": "Union[float, str]",
    "whole number": "Union[int, str]",
    "switch": "Union[bool, str]",
    "choice": "str",
}

_HEAD = '''# SPDX-License-Identifier: BSD-3-Clause
# Made by tools/python/make_option_stub.py from the option table.
from typing import Any, Callable, Dict, List, NamedTuple, Tuple, TypedDict, TypeVar, Union

Settings = List[Tuple[str, str]]
Function = TypeVar("Function", bound=Callable[..., Any])

class Option(NamedTuple):
    name: str
    group: str
    kind: str
    unit: str
    text: str
    range: str
    words: List[str]
    default: str

def options() -> List[Option]: ...
def settings_of(keywords: Dict[str, Any]) -> Settings: ...
def documented(*groups: str) -> Callable[[Function], Function]: ...

class Options(TypedDict, total=False):
'''


def stub() -> str:
    """The text of the stub."""
    lines = [f"    {option.name}: {_TYPES[option.kind]}\n" for option in surfmesh.options()]
    return _HEAD + "".join(lines)


if __name__ == "__main__":
    print(stub(), end="")
