# SPDX-License-Identifier: BSD-3-Clause
# As _run.py, but with the options by name and type.
from typing import Any, Callable, Dict, Optional, Union

from typing_extensions import Unpack

from ._mesh import Mesh, Path
from ._model import Model
from ._options import Options

Progress = Callable[[str, int, int, int], Any]

def read(
    path: Path,
    *,
    scheme: str = "auto",
    progress: Optional[Progress] = None,
    **keywords: Unpack[Options],
) -> Model: ...
def mesh(
    model: Union[Model, Path],
    *,
    scheme: str = "auto",
    progress: Optional[Progress] = None,
    **keywords: Unpack[Options],
) -> Mesh: ...
def estimate(
    model: Union[Model, Path],
    *,
    scheme: str = "auto",
    progress: Optional[Progress] = None,
    **keywords: Unpack[Options],
) -> Dict[str, Any]: ...
def read_mesh(path: Path) -> Mesh: ...
def check(
    mesh: Union[Mesh, Path],
    model: Union[None, Model, Path] = None,
    *,
    scheme: str = "auto",
    progress: Optional[Progress] = None,
    **keywords: Unpack[Options],
) -> Dict[str, Any]: ...
