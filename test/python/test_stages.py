# SPDX-License-Identifier: BSD-3-Clause
"""Stages, composed by hand, give the bytes of the one call."""

import numpy as np
import pytest
from conftest import cap, points_of, run, saddle

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


SAME = ("contact", "normal", "axis", "arc_length", "turn")


def assert_same(path, other):
    for name in SAME:
        assert getattr(path, name).tobytes() == getattr(other, name).tobytes(), name


@pytest.mark.parametrize("shift", [(0, 0, 0), (4e8, 3e8, 0)])
@pytest.mark.parametrize("more", [{}, {"one_way": True, "sense": "cw", "direction": "inward"}])
def test_constant_scallop_by_stages_as_in_one_call(shift, more):
    scan = dome(shift)
    settings = {"method": "constant-scallop", **more}
    expected = pcl_spiral.spiral(scan, **SETTINGS, **settings)
    surface = pcl_spiral.surface(scan)
    surface, loops = pcl_spiral.bridge_gaps(surface, pcl_spiral.boundary_loops(surface))
    field = pcl_spiral.step_over_field(surface, loops, **SETTINGS)
    rings = pcl_spiral.scallop_loops(field)
    linked = pcl_spiral.link_loops(rings, **more)
    for made in (field, rings, linked):
        assert_same(pcl_spiral.spiral_over(surface, loops, made, **SETTINGS, **settings), expected)
    assert len(rings) == len(rings.loops) == len(rings.levels) and rings.levels[0] == 0
    assert linked.chain_loops + linked.bridges <= len(rings)
    with pytest.raises(pcl_spiral.Error, match="scallop"):
        pcl_spiral.spiral_over(surface, loops, linked, tool_radius=6, scallop=0.2)
    with pytest.raises(TypeError, match="made="):
        pcl_spiral.spiral_over(surface, loops, 5, **SETTINGS)


def test_a_field_on_a_disc_counts_step_overs():
    random = np.random.default_rng(3)
    r, angle = 40 * np.sqrt(random.uniform(size=20000)), random.uniform(0, 2 * np.pi, 20000)
    disc = np.column_stack([r * np.cos(angle), r * np.sin(angle), 0 * r])
    field = pcl_spiral.step_over_field(pcl_spiral.surface(disc), **SETTINGS)
    step = 2 * np.sqrt(2 * 6 * 0.1 - 0.1**2)  # between turns on a plane
    off = field.distance - (40 - np.hypot(*field.points[:, :2].T)) / step
    assert np.abs(off).max() < 0.3 and abs(off.mean()) < 0.05 and abs(field.largest - 40 / step) < 0.3
    for loop, level in zip((rings := pcl_spiral.scallop_loops(field)).loops, rings.levels):
        if level <= 10:
            assert abs(np.hypot(*loop[:, :2].T).mean() - (40 - level * step)) < 0.15 * step


def test_projection_onto_a_sphere():
    surface = pcl_spiral.surface(dome())
    centre = np.array([0, 0, -np.sqrt(90.0**2 - 50.0**2)])
    places = dome()[:500:7] + [0, 0, 0.3]
    places = places[np.hypot(*places[:, :2].T) < 42]
    feet = pcl_spiral.project(surface, np.concatenate([places, [[0, 0, 900.0]]]))
    assert np.isnan(feet.position[-1]).all() and np.isnan(feet.larger_curvature[-1])
    out = (feet.position[:-1] - centre) / 90
    assert np.abs(np.linalg.norm(out, axis=1) - 1).max() < 2e-5 and np.abs(feet.normal[:-1] - out).max() < 5e-3
    assert np.abs(feet.larger_curvature[:-1] * 90 - 1).max() < 0.1 > np.abs(feet.smaller_curvature[:-1] * 90 - 1).max()


def test_boundary_points_of_a_dome():
    surface = pcl_spiral.surface(dome())
    marks = pcl_spiral.boundary_points(surface)
    assert marks.shape == (len(surface),) and marks.dtype == bool
    x, y = surface.points[:, :2].T
    depth = np.minimum(50 - np.hypot(x, y), np.minimum(np.hypot(x - 15, y) - 7, np.abs(np.hypot(x + 25, y - 5) - 2.5)))
    assert marks[depth < 0.3].mean() > 0.85 and marks[depth > 3].mean() < 0.02


@pytest.mark.parametrize("on_mesh", [False, True])
def test_sections_and_cutter_locations_as_in_one_call(on_mesh, folder):
    points, faces = saddle()
    points, mesh = (points, {"faces": faces}) if on_mesh else (dome(), {})
    tool, path = {"tool_radius": 4, "corner_radius": 1}, {"step_over": 3, "direction": 30}
    expected = pcl_spiral.drive(points, **mesh, **tool, **path)
    passes = pcl_spiral.sections(points, **mesh, **tool, **path)
    made = pcl_spiral.cutter_locations(points, passes, **mesh, **tool)
    assert_same(made, expected)
    assert made.tip.tobytes() == expected.tip.tobytes() and len(passes) >= len(made.passes)
    made.program("made.ngc")
    expected.program("expected.ngc")
    assert (folder / "made.ngc").read_bytes() == (folder / "expected.ngc").read_bytes()
    some = pcl_spiral.cutter_locations(points, [pass_[:2] for pass_ in passes[3:5]], **mesh, **tool)
    assert len(some.passes) >= 2 and len(some) < len(made)
    for wrong in ([(passes[0].position, passes[0].axis[:2])], [(passes[0].position[:, :2], passes[0].axis)]):
        with pytest.raises(pcl_spiral.Error, match="passes="):
            pcl_spiral.cutter_locations(points, wrong, **mesh, **tool)
    with pytest.raises((pcl_spiral.Error, TypeError)):
        pcl_spiral.cutter_locations(points, [], **mesh, **tool)


def test_ridge_lines_as_in_one_call(folder):
    run("simulate_scan", "--part", "ridge", "-o", "ridge.pcd", "--line-spacing", 1, "--point-spacing", 1)
    rail = points_of("ridge_rail.pcd")
    through = rail[np.argsort(rail[:, 0])][[20, 100, 200, 280]].astype(float)
    beam = {"spot": 4, "overlap": 0.25, "stand_off": 10}
    expected = pcl_spiral.ridge("ridge.pcd", through=through, half_width=9, **beam)
    lines = pcl_spiral.ridge_lines("ridge.pcd", through=through, half_width=9)
    made = pcl_spiral.ridge(rail=lines[0], generator=lines[1], **beam)
    named = np.zeros(len(scan := points_of("ridge.pcd")), [(field, "f4") for field in ("x", "y", "z", "nx", "ny", "nz")])
    named["x"], named["y"], named["z"] = scan.T
    assert pcl_spiral.ridge_lines(named, through=through, half_width=9)[0].tobytes() == lines[0].tobytes()
    assert abs(len(made) - len(expected)) <= 2 and abs(made.arc_length[-1] / expected.arc_length[-1] - 1) < 1e-3
    assert np.abs(made.tip[0] - expected.tip[0]).max() < 0.01 or np.abs(made.tip[-1] - expected.tip[-1]).max() < 0.01


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
