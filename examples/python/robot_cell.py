# SPDX-License-Identifier: BSD-3-Clause
"""A cell that cuts part after part: each scan becomes robot frames, or the place that an operator has to look at."""
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import pcl_spiral

stop = threading.Event()  # set by the emergency stop of the cell
FIXTURE = (0.0, 0.0, 80.0)  # where the part lies
SEVERAL_PARTS = "the {cloud} has {number} separate parts"  # how the id of this fault begins


def scans() -> Iterator[NDArray[np.float64]]:
    """What the sensor gives, one after another: a dome; beside it another part; on it a clamp; nothing at all."""
    x, y = np.meshgrid(np.arange(-40, 40, 1.0), np.arange(-40, 40, 1.0))
    inside = np.hypot(x, y) < 40
    dome = np.column_stack([x[inside], y[inside], np.sqrt(80.0**2 - x[inside] ** 2 - y[inside] ** 2)])
    clamp = dome[np.hypot(dome[:, 0], dome[:, 1]) < 3] + [0, 0, 2]
    yield from (dome, np.concatenate([dome, dome + [150, 0, 0]]), np.concatenate([dome, clamp]), dome[:0])


def plan(points: NDArray[np.float64]) -> pcl_spiral.Path:
    """A path over the part in the fixture. What is known to happen is known by its id, whatever the numbers and the places are."""
    settings: dict[str, Any] = {"tool_radius": 5, "scallop": 0.1, "progress": lambda share, stage: not stop.is_set()}
    try:
        return pcl_spiral.spiral(points, **settings)
    except pcl_spiral.Error as error:
        if not error.id.startswith(SEVERAL_PARTS):
            raise
        place = min(error.places, key=lambda p: float(np.linalg.norm(np.subtract(p, FIXTURE))))
        return pcl_spiral.spiral(points, part_at=place, **settings)


def main(folder: Path) -> None:
    for number, points in enumerate(scans()):
        try:
            path = plan(points)
            program = path.program(folder / f"part_{number}.yaml")
            print(f"{program.file}: {len(path)} waypoints, highest tip at {path.tip[:, 2].max():.1f} mm")
        except pcl_spiral.Error as error:
            if error.code == "cancelled":
                return
            print(f"part {number}: {error.code}: {error}; look at {error.places[:1]}")


main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
