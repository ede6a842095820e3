# SPDX-License-Identifier: BSD-3-Clause
"""Types of the package, made from the tables of settings. Usage: python3 -m pcl_spiral._stub FILE"""

import sys

from ._keywords import table_of

HEAD = '''\
# SPDX-License-Identifier: BSD-3-Clause
# Made by pcl_spiral._stub from the tables of settings.
from os import PathLike
from typing import Any, Callable, Literal, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

File = str | PathLike[str]
Place = Sequence[float] | NDArray[Any]
Points = ArrayLike | File
Progress = Callable[[float, str], object]

__version__: str
'''
ARRAY, TEXTS = "NDArray[np.{}]", "tuple[str, ...]"
CLASSES = {
    "Error(ValueError)": {"id": "str", "code": "str", "places": "tuple[tuple[float, float, float], ...]", "settings": TEXTS},
    "Program": {"file": "str", "warnings": "list[str]", "blocks": "int", "minutes": "float"},
    "Verification": {"ok": "bool", "broken": TEXTS, "warnings": TEXTS, "report": "dict[str, Any]", "report_text": "str"}
    | dict.fromkeys(("deviation", "stock"), "tuple[NDArray[np.float32], ...]"),
    "Path": dict.fromkeys(("contact", "normal", "tip", "axis", "arc_length"), ARRAY.format("float64"))
    | {"turn": ARRAY.format("float32"), "lift": ARRAY.format("float32"), "over_gap": ARRAY.format("bool_")}
    | {"passes": "tuple[slice, ...]", "tool_radius": "float", "feed": "float"}
    | {"report": "dict[str, Any]", "report_text": "str", "warnings": TEXTS},
}
STAGES = {
    "Surface": dict.fromkeys(("points", "normals"), ARRAY.format("float64")) | dict.fromkeys(("spacing", "noise", "area"), "float"),
    "BoundaryLoop": dict.fromkeys(("points", "curve"), ARRAY.format("float64"))
    | {"length": "float", "type": "Literal['outer', 'inner', 'gap']"},
    "RadialLines": {"lines": "list[NDArray[np.float64]]"},
}
METHODS = "    def __len__(self) -> int: ...\n    def save(self, file: File) -> None: ...\n    def to_vtk(self) -> Any: ...\n"
FUNCTIONS = {  # what they have before their keywords, and what they give
    "spiral": ("points: Points", "Path"),
    "drive": ("points: Points", "Path"),
    "ridge": ("points: Points | None = None", "Path"),
    "program": ("path: Path, file: File", "Program"),
    "verify": ("points: Points, path: Path | File", "Verification"),
    "surface": ("points: Points", "Surface"),
    "boundary_loops": ("surface: Surface", "list[BoundaryLoop]"),
    "bridge_gaps": ("surface: Surface, loops: Sequence[BoundaryLoop]", "tuple[Surface, list[BoundaryLoop]]"),
    "radial_lines": ("surface: Surface, loops: Sequence[BoundaryLoop]", "RadialLines"),
    "spiral_over": ("surface: Surface, loops: Sequence[BoundaryLoop] = (), radial: RadialLines | None = None", "Path"),
}
GEODESIC = "\ndef geodesic_path(surface: Surface, source: Place, targets: Points) -> list[NDArray[np.float64]]: ...\n"


def _class(name, members):
    """A class whose members can be read."""
    sized = "    def __len__(self) -> int: ...\n" if name in ("Surface", "RadialLines") else ""
    return f"\nclass {name}:\n" + "".join(f"    @property\n    def {m}(self) -> {t}: ...\n" for m, t in members.items()) + sized


def _function(name, first, result, indent=""):
    """A call with all its keywords; a required one has no default."""
    keywords = "".join(
        f"{indent}    {row['name']}: {row['type']}" + ("" if row["default"] is ... else f" = {row['default']!r}") + ",\n"
        for row in table_of(name)
    )
    return f"{indent}def {name}(\n{indent}    {first},\n{indent}    *,\n{keywords}{indent}) -> {result}: ...\n"


def stub():
    """The text of __init__.pyi."""
    text = HEAD + "".join(_class(*one) for one in (STAGES | CLASSES).items())
    text += METHODS + _function("program", "self, file: File", "Program", "    ")
    return text + "".join("\n" + _function(name, *rest) for name, rest in FUNCTIONS.items()) + GEODESIC


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(stub())
