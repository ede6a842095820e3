# SPDX-License-Identifier: BSD-3-Clause
"""A scan as other packages hold it: points and normals as arrays, of Open3D by numpy.asarray(cloud.points), of laspy and pye57 by columns."""
import sys

import numpy as np
from numpy.typing import NDArray

import pcl_spiral


def dome(side: float = 1.0) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Points of a sphere of 80 mm, and its normals; side -1: a bowl, seen from inside."""
    x, y = np.meshgrid(np.arange(-40, 40, 1.0), np.arange(-40, 40, 1.0))
    inside = np.hypot(x, y) < 40
    points = np.column_stack([x[inside], y[inside], side * np.sqrt(80.0**2 - x[inside] ** 2 - y[inside] ** 2)])
    return points, points / 80 * side


def main(file: str) -> None:
    points, normals = dome()
    path = pcl_spiral.spiral(points, normals=normals, tool_radius=5, scallop=0.1)  # normals tell the side, and nothing else
    columns = np.zeros(len(points), [("x", "f4"), ("y", "f4"), ("z", "f4"), ("intensity", "u2")])  # one array with named fields
    columns["x"], columns["y"], columns["z"] = points.T
    same = pcl_spiral.spiral(columns, view_point=(0, 0, 500), tool_radius=5, scallop=0.1)
    print(len(path), len(same), "points; centre of the ball", np.linalg.norm(path.tip + 5 * path.axis, axis=1).mean(), "mm from the middle")
    found = pcl_spiral.verify(points, path, tool_radius=5, scallop=0.1, max_gouge=0.05)
    stock = found.stock[0]  # what is left, one a point of the scan
    print(f"at most {np.nanmax(stock):.3f} mm are left;", "ok" if found.ok else found.broken[0])
    path.save(file)


main(sys.argv[1] if len(sys.argv) > 1 else "dome.csv")
