# SPDX-License-Identifier: BSD-3-Clause
"""Types of the package, made from the tables of settings. Usage: python3 -m pcl_spiral._stub FILE"""

import re
import sys

from . import _core
from ._keywords import default_of

HEAD = '''\
# SPDX-License-Identifier: BSD-3-Clause
# Made by pcl_spiral._stub from the tables of settings.
from dataclasses import dataclass
from os import PathLike
from typing import Any, Callable, Literal, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

Place = Sequence[float] | NDArray[Any]
Progress = Callable[[float, str], object]
Points = ArrayLike | str | PathLike[str]

__version__: str

class Error(ValueError):
    id: str
    code: str
    places: tuple[tuple[float, float, float], ...]
    settings: tuple[str, ...]

@dataclass(frozen=True)
class Program:
    file: str
    warnings: list[str]
    blocks: int = 0
    minutes: float = 0.0

@dataclass(frozen=True)
class Verification:
    report_text: str
    broken: tuple[str, ...]
    warnings: tuple[str, ...]
    deviation: tuple[NDArray[np.float32], ...]
    stock: tuple[NDArray[np.float32], ...]
    @property
    def ok(self) -> bool: ...
    @property
    def report(self) -> dict[str, Any]: ...

class Path:
    @property
    def contact(self) -> NDArray[np.float64]: ...
    @property
    def normal(self) -> NDArray[np.float64]: ...
    @property
    def tip(self) -> NDArray[np.float64]: ...
    @property
    def axis(self) -> NDArray[np.float64]: ...
    @property
    def turn(self) -> NDArray[np.float32]: ...
    @property
    def arc_length(self) -> NDArray[np.float64]: ...
    @property
    def lift(self) -> NDArray[np.float32]: ...
    @property
    def over_gap(self) -> NDArray[np.bool_]: ...
    @property
    def passes(self) -> tuple[slice, ...]: ...
    @property
    def tool_radius(self) -> float: ...
    @property
    def feed(self) -> float: ...
    @property
    def report(self) -> dict[str, Any]: ...
    @property
    def report_text(self) -> str: ...
    @property
    def warnings(self) -> tuple[str, ...]: ...
    def __len__(self) -> int: ...
    def save(self, file: str | PathLike[str]) -> None: ...
    def to_vtk(self) -> Any: ...
'''

FUNCTIONS = {  # and what they have before their keywords
    "spiral": ("points: Points", "Path"),
    "drive": ("points: Points", "Path"),
    "ridge": ("points: Points | None = None", "Path"),
    "program": ("path: Path, file: str | PathLike[str]", "Program"),
    "verify": ("points: Points, path: Path | str | PathLike[str]", "Verification"),
}


def keyword(row, indent):
    """One keyword; a required one has no default."""
    default = default_of(row)
    kind = re.sub(r"\bint\b", "int", row["type"])
    return f"{indent}{row['name']}: {kind}" + ("" if default == "..." else f" = {default}") + ",\n"


def declaration(name, first, result, table, indent=""):
    """One function."""
    keywords = "".join(keyword(row, indent + "    ") for row in table)
    return f"{indent}def {name}(\n{indent}    {first},\n{indent}    *,\n{keywords}{indent}) -> {result}: ...\n"


def stub():
    """The text of __init__.pyi."""
    tables = {name: _core.keywords(name) for name in FUNCTIONS}
    text = HEAD + declaration("program", "self, file: str | PathLike[str]", "Program", tables["program"], "    ")
    for name, (first, result) in FUNCTIONS.items():
        text += "\n" + declaration(name, first, result, tables[name])
    return text


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(stub())
