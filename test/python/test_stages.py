# SPDX-License-Identifier: BSD-3-Clause
"""Stages, composed by hand, give the bytes of the one call."""

import numpy as np
import pytest
from conftest import cap

import pcl_spiral

SETTINGS = {"tool_radius": 6, "scallop": 0.1}


def dome(shift=(0, 0, 0)):
    """A cap with a hole and a gap in the data."""
    points = cap(9000, rim=50.0, sphere=90.0)
    hole = np.hypot(points[:, 0] - 15, points[:, 1]) < 7
    gap = np.hypot(points[:, 0] + 25, points[:, 1] - 5) < 2.5
    return points[~hole & ~gap] + shift


@pytest.mark.parametrize("shift", [(0, 0, 0), (4e8, 3e8, 0)])
def test_by_stages_as_in_one_call(shift):
    scan = dome(shift)
    settings = {"boundaries": "two", "method": "radial"}
    expected = pcl_spiral.spiral(scan, **SETTINGS, **settings)
    surface = pcl_spiral.surface(scan)
    loops = pcl_spiral.boundary_loops(surface)
    assert sorted(loop.type for loop in loops)[-1] == "outer" and len(loops) >= 2
    bridged, kept = pcl_spiral.bridge_gaps(surface, loops, boundaries="two")
    lines = pcl_spiral.radial_lines(bridged, kept, boundaries="two", **SETTINGS)
    for path in (
        pcl_spiral.spiral_over(surface, **SETTINGS, **settings),
        pcl_spiral.spiral_over(bridged, kept, lines, **SETTINGS, **settings),
    ):
        for name in ("contact", "normal", "axis", "arc_length"):
            assert getattr(path, name).tobytes() == getattr(expected, name).tobytes(), name
    assert len(bridged) >= len(surface) and len(lines.lines) == len(lines) > 4
    filled, rest = pcl_spiral.bridge_gaps(surface, loops, boundaries="one")
    assert len(filled) > len(surface) and [loop.type for loop in rest] == ["outer"]
    with pytest.raises(pcl_spiral.Error, match="made of stages"):
        path.program("part.ngc")


def test_arrays_of_stages():
    scan = dome()
    surface = pcl_spiral.surface(scan)
    assert surface.points.shape == surface.normals.shape == (len(surface), 3)
    assert np.abs(np.linalg.norm(surface.normals, axis=1) - 1).max() < 1e-6 and surface.normals[:, 2].min() > 0
    assert 0.5 < surface.spacing < 1.5 and surface.noise < 0.01 and 7000 < surface.area < 9000
    rim = next(loop for loop in pcl_spiral.boundary_loops(surface) if loop.type == "outer")
    assert abs(rim.length - 2 * np.pi * 50) < 5 and np.abs(np.hypot(*rim.curve[:, :2].T) - 50).max() < 2
    ends = np.array([[-30.0, -20.0, 0.0], [0.0, 30.0, 0.0]])
    ends[:, 2] = np.sqrt(90.0**2 - (ends**2).sum(axis=1)) - np.sqrt(90.0**2 - 50.0**2)
    for path, end in zip(pcl_spiral.geodesic_path(surface, scan[0], ends), ends):
        length = np.linalg.norm(np.diff(path, axis=0), axis=1).sum()
        centre = [0, 0, -np.sqrt(90.0**2 - 50.0**2)]
        a, b = path[0] - centre, path[-1] - centre
        arc = 90 * np.arccos(a @ b / np.linalg.norm(a) / np.linalg.norm(b))
        assert abs(length - arc) < 0.01 * arc + 0.05 and np.abs(path[-1] - end).max() < 1


def test_what_does_not_fit_is_refused():
    surface = pcl_spiral.surface(dome())
    with pytest.raises(pcl_spiral.Error, match="tool_radius="):
        pcl_spiral.spiral_over(surface, scallop=0.1)
    with pytest.raises(TypeError, match="did you mean 'hole_size'"):
        pcl_spiral.boundary_loops(surface, holesize=3)
    with pytest.raises(TypeError):
        pcl_spiral.boundary_loops(dome())
    with pytest.raises(TypeError, match="source="):
        pcl_spiral.geodesic_path(surface, "here", [[0, 0, 0]])
    with pytest.raises(pcl_spiral.Error):
        pcl_spiral.geodesic_path(surface, (0, 0, 0), np.zeros((0, 3)))
    with pytest.raises(pcl_spiral.Error):
        pcl_spiral.surface(np.zeros((0, 3)))
