# SPDX-License-Identifier: BSD-3-Clause
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
    curvature: Union[float, str]
    segments_per_circle: Union[float, str]
    size: Union[float, str]
    sag: Union[float, str]
    hmin: Union[float, str]
    hmax: Union[float, str]
    shares_of: str
    stretch: Union[float, str]
    isotropic: Union[bool, str]
    grade: Union[float, str]
    contour_curvature: Union[bool, str]
    proximity: Union[float, str]
    features: Union[bool, str]
    curvature_from: str
    nodes: Union[int, str]
    precision: Union[float, str]
    control: str
    interpolation: str
    epsilon: Union[float, str]
    blend: str
    lookup: str
    inner_nodes: Union[bool, str]
    reuse: Union[float, str]
    placement: str
    kernel: str
    conformity: Union[float, str]
    smoothing: Union[int, str]
    sweeps: Union[int, str]
    repairs: Union[int, str]
    patches: str
    weld: Union[float, str]
    joining: Union[float, str]
    sew: Union[float, str]
    orient: Union[bool, str]
    crease_angle: Union[float, str]
    surface: str
    fit: Union[float, str]
    quads: Union[bool, str]
    quad_method: str
    quad_front: str
    across: Union[bool, str]
    normals: Union[bool, str]
    uv: Union[bool, str]
    texture: Union[bool, str]
    msh: str
    tile: Union[int, str]
    threads: Union[int, str]
    max_elements: Union[int, str]
