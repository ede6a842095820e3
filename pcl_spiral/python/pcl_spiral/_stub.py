# SPDX-License-Identifier: BSD-3-Clause
"""Types of the package, made from the tables of settings. Usage: python3 -m pcl_spiral._stub FILE"""

import inspect
import re
import sys

import pcl_spiral

from . import _core
from ._keywords import table_of

HEAD = '''\
# SPDX-License-Identifier: BSD-3-Clause
# Made by pcl_spiral._stub from the tables of settings.
from os import PathLike
from types import SimpleNamespace
from typing import Any, Callable, Iterable, Literal, NamedTuple, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

File = str | PathLike[str]
Float = float | np.floating[Any] | np.integer[Any]
Int = int | np.integer[Any]
Bool = bool | np.bool_
Place = Sequence[Float] | NDArray[Any]
Doubles = NDArray[np.float64]
Loops = Sequence["BoundaryLoop"]
Points = ArrayLike | File
Progress = Callable[[float, str], object]

__version__: str
'''
TEXTS, ARRAY = "tuple[str, ...]", "Doubles"
CLASSES = {  # their members that can be read
    "Surface": {"points, normals": ARRAY, "spacing, noise, area": "float"},
    "BoundaryLoop": {"points, curve": ARRAY, "length": "float", "type": "Literal['outer', 'inner', 'gap']"},
    "RadialLines": {"lines": "list[Doubles]"},
    "StepOverField": {"points, distance": ARRAY, "largest, least_length": "float"},
    "ScallopLoops": {"loops": "list[Doubles]", "levels": "list[int]"},
    "LinkedPath": {"points": ARRAY, "chain_loops, bridges": "int"},
    "Error(ValueError)": {"id, code": "str", "places": "tuple[tuple[float, float, float], ...]", "settings": TEXTS},
    "Program": {"file": "str", "warnings": "list[str]", "blocks": "int", "minutes": "float"},
    "Verification": {"ok": "bool", "broken, warnings": TEXTS, "report": "dict[str, Any]"}
    | {"deviation, stock": "tuple[NDArray[np.float32], ...]"},
    "Path": {"contact, normal, tip, axis, arc_length": ARRAY, "turn, lift": "NDArray[np.float32]", "over_gap": "NDArray[np.bool_]"}
    | {"passes": "tuple[slice, ...]", "tool_radius, feed": "float", "report": "dict[str, Any]", "warnings": TEXTS},
}
OWN = """
class Pass(NamedTuple):
    position: ArrayLike
    axis: ArrayLike
    normal: ArrayLike | None

class Feet(NamedTuple):
    position: Doubles
    normal: Doubles
    larger_curvature: Doubles
    smaller_curvature: Doubles

class Planner:
    def plan(self, surface: Surface, boundaries: list[BoundaryLoop], settings: SimpleNamespace) -> ArrayLike | Sequence[ArrayLike]: ...

class Modifier:
    def modify(self, surface: Surface, settings: SimpleNamespace, path: SimpleNamespace) -> None: ...
"""
SIZED = "    def __len__(self) -> int: ...\n"
METHODS = "    def __len__(self) -> int: ...\n    def save(self, file: File) -> None: ...\n    def to_vtk(self) -> Any: ...\n"

def _class(name, members):
    """A class whose members can be read."""
    readable = [(m, kind) for ms, kind in members.items() for m in ms.split(", ")]
    sized = SIZED if name in ("Surface", "RadialLines", "ScallopLoops") else ""
    return f"\nclass {name}:\n" + "".join(f"    @property\n    def {m}(self) -> {kind}: ...\n" for m, kind in readable) + sized


def _type(row):
    """The type of a keyword: numbers and switches are of Python or of numpy."""
    return re.sub(r"\b(float|int|bool)\b", lambda kind: kind[0].title(), row["type"]) if "text" in row else row["type"]


def _function(function, indent=""):
    """A call with all its keywords; a required one has no default."""
    signature, name = inspect.signature(function), function.__name__
    own = [str(p).replace("'", "") for p in signature.parameters.values() if p.kind is not p.KEYWORD_ONLY]
    keywords = "".join(
        f"{indent}    {row['name']}: {_type(row)}" + ("" if row["default"] is ... else f" = {row['default']!r}") + ",\n"
        for row in (table_of(name) if name in _core.tables else ())
    )
    first = ", ".join(own) if not indent else "self, " + ", ".join(own[1:])  # a method
    stars = f"{indent}    *,\n{keywords}" if keywords else ""
    return f"{indent}def {name}(\n{indent}    {first},\n{stars}{indent}) -> {signature.return_annotation}: ...\n"


def stub():
    """The text of __init__.pyi."""
    functions = [value for value in vars(pcl_spiral).values() if inspect.isfunction(value) and not value.__name__.startswith("_")]
    text = HEAD + "".join(_class(*one) for one in CLASSES.items()) + METHODS + _function(pcl_spiral.program, "    ")
    return text + "".join("\n" + _function(function) for function in functions if function.__name__ in pcl_spiral.__all__) + OWN


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(stub())
