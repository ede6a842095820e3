# SPDX-License-Identifier: BSD-3-Clause
"""A cell that cuts part after part: each scan becomes robot frames, or the place that an operator has to look at."""
import sys
import threading
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import pcl_spiral

stop = threading.Event()  # set by the emergency stop of the cell


def scans() -> list[NDArray[np.float32]]:
    """What the sensor of the cell gives: here two domes, of which one has a spike."""
    x, y = np.meshgrid(np.arange(-40, 40, 1.0), np.arange(-40, 40, 1.0))
    inside = np.hypot(x, y) < 40
    dome = np.column_stack([x[inside], y[inside], np.sqrt(80.0**2 - x[inside] ** 2 - y[inside] ** 2)]).astype(np.float32)
    spiked = dome.copy()
    spiked[2000:2004, 2] += 3
    return [dome, spiked]


def cut(points: NDArray[np.float32], file: Path) -> None:
    """Writes robot frames, checked against the scan."""
    path = pcl_spiral.spiral(points, tool_radius=5, scallop=0.1, progress=lambda share, stage: not stop.is_set())
    found = pcl_spiral.verify(points, path, tool_radius=5, scallop=0.1, max_gouge=0.05)
    if not found.ok:
        raise RuntimeError(found.broken[0])
    path.program(file)
    print(f"{file}: {len(path)} waypoints, highest tip at {path.tip[:, 2].max():.1f} mm")


for number, points in enumerate(scans()):
    try:
        cut(points, Path(sys.argv[1] if len(sys.argv) > 1 else ".") / f"part_{number}.yaml")
    except pcl_spiral.Error as error:
        print(f"part {number}: {error.code}: {error}; look at {error.places[:1]}")
