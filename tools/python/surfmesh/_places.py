# SPDX-License-Identifier: BSD-3-Clause
"""Patches of a model by names of groups and patches, or by indices."""

from __future__ import annotations

from typing import List, Optional, Union

import numpy as np

from . import _surfmesh
from ._errors import InvalidInput
from ._types import Where

Places = Optional[List[Union[int, str]]]


def places(where: Where) -> Places:
    """A copy of what names patches and groups; None stands for all patches."""
    if where is None:
        return None
    return [where] if isinstance(where, (str, int, np.integer)) else list(where)


def patch_index(held: _surfmesh.HeldInput, patch: Union[int, str]) -> int:
    """The index of a patch that is given by name or index."""
    if isinstance(patch, str):
        return held.find_patch(patch)
    count = len(held.patch_names())
    if isinstance(patch, bool) or not isinstance(patch, (int, np.integer)):
        raise InvalidInput(f"{patch!r} is no name and no index of a patch")
    if not 0 <= patch < count:
        raise InvalidInput(f"there is no patch {patch}; the model has {count}, from 0")
    return int(patch)


def patch_indices(held: _surfmesh.HeldInput, wanted: Places) -> List[int]:
    """Indices of patches from names of groups and patches; all for None."""
    names = held.patch_names()
    if wanted is None:
        return list(range(len(names)))
    groups = dict(held.groups())
    found: List[int] = []
    for entry in wanted:
        if isinstance(entry, str) and entry in groups:
            found += groups[entry]
        elif isinstance(entry, str) and entry not in names:
            found += held.find_group(entry)  # tells what was probably meant
        else:
            found.append(patch_index(held, entry))
    return sorted(set(found))


def some_patches(held: _surfmesh.HeldInput, wanted: Places) -> List[int]:
    """As patch_indices, but none stands for all."""
    return [] if wanted is None else patch_indices(held, wanted)
