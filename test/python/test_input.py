# SPDX-License-Identifier: BSD-3-Clause
"""Any layout of numbers gives the same path; what is no scan is refused with the remedy."""

import pathlib

import numpy as np
import pytest
from conftest import cap, saddle, write_points

import pcl_spiral

SETTINGS = {"tool_radius": 6, "scallop": 0.5}
POINTS = cap(1500).astype(np.float32).astype(float)
EXPECTED = pcl_spiral.spiral(POINTS, **SETTINGS)


def structured(order="<", kind="f8"):
    points = np.zeros(len(POINTS), [("intensity", "u1"), ("x", order + kind), ("y", order + kind), ("z", order + kind)])
    for name, column in zip("xyz", POINTS.T):
        points[name] = column
    return points


def read_only(points):
    points = points.copy()
    points.setflags(write=False)
    return points


LAYOUTS = {
    "float32": lambda: POINTS.astype(np.float32),
    "big-endian": lambda: POINTS.astype(">f8"),
    "big-endian float32": lambda: POINTS.astype(">f4"),
    "fortran": lambda: np.asfortranarray(POINTS),
    "every second row": lambda: np.repeat(POINTS, 2, axis=0)[::2],
    "columns of a wider array": lambda: np.column_stack([POINTS, POINTS])[:, 3:],
    "backwards twice": lambda: POINTS[::-1].copy()[::-1],
    "read only": lambda: read_only(POINTS),
    "lists": lambda: POINTS.tolist(),
    "structured": structured,
    "structured, unaligned": lambda: structured(kind="f4"),
    "structured, big-endian": lambda: structured(">"),
    "structured, organised": lambda: structured().reshape(30, -1),
    "with its buffer": lambda: memoryview(POINTS),
}


@pytest.mark.parametrize("layout", LAYOUTS)
def test_layouts_give_the_same_path(layout):
    points = LAYOUTS[layout]()
    path = pcl_spiral.spiral(points, **SETTINGS)
    assert path.contact.tobytes() == EXPECTED.contact.tobytes() and path.axis.tobytes() == EXPECTED.axis.tobytes()


def test_files(folder):
    write_points("scan.xyz", POINTS)
    for file in ("scan.xyz", pathlib.Path("scan.xyz")):
        assert pcl_spiral.spiral(file, **SETTINGS).contact.tobytes() == EXPECTED.contact.tobytes()
    with pytest.raises(pcl_spiral.Error, match="none.pcd") as error:
        pcl_spiral.spiral("none.pcd", **SETTINGS)
    assert error.value.code == "file"
    with pytest.raises(pcl_spiral.Error, match="part.e57.*"):
        pcl_spiral.spiral("part.e57", **SETTINGS)


def test_whole_numbers():
    grid = np.mgrid[0:60, 0:60, 0:1].reshape(3, -1).T
    path = pcl_spiral.spiral(grid.astype(np.int16), **SETTINGS)
    assert path.contact.tobytes() == pcl_spiral.spiral(grid.astype(float), **SETTINGS).contact.tobytes()


def test_normals_and_view_points_give_the_side():
    down = np.tile([0.0, 0.0, -2.0], (len(POINTS), 1))
    path = pcl_spiral.spiral(POINTS, normals=down, **SETTINGS)
    assert path.normal[:, 2].max() < 0 < EXPECTED.normal[:, 2].min()
    with_fields = np.zeros(len(POINTS), [(n, "f4") for n in ("x", "y", "z", "normal_x", "normal_y", "normal_z")])
    for name, column in zip("xyz", POINTS.T):
        with_fields[name] = column
    with_fields["normal_z"] = -1
    assert pcl_spiral.spiral(with_fields, **SETTINGS).contact.tobytes() == path.contact.tobytes()
    assert pcl_spiral.spiral(POINTS, view_point=[0, 0, -500], **SETTINGS).normal[:, 2].max() < 0
    assert pcl_spiral.spiral(POINTS, normals=down, view_point=[0, 0, 500], **SETTINGS).normal[:, 2].min() > 0
    with pytest.raises(pcl_spiral.Error, match="normals= has 3 rows"):
        pcl_spiral.spiral(POINTS, normals=down[:3], **SETTINGS)


def test_points_that_are_not_finite_are_left_out():
    bad = np.insert(POINTS, [5, 500], [np.nan, np.inf, 0], axis=0)
    path = pcl_spiral.spiral(bad, **SETTINGS)
    assert path.report["surface"]["nonfinite_points"] == 2
    with pytest.raises(pcl_spiral.Error):
        pcl_spiral.spiral(np.full((100, 3), np.nan), **SETTINGS)


BAD = {
    "a row": POINTS[0],
    "two columns": POINTS[:, :2],
    "four columns": np.column_stack([POINTS, POINTS[:, 0]]),
    "three dimensions": POINTS.reshape(-1, 10, 3),
    "transposed": POINTS.T.copy(),
    "empty": np.zeros((0, 3)),
    "nothing": [],
    "one point": POINTS[:1],
    "three points": POINTS[:3],
    "all the same": np.tile(POINTS[0], (500, 1)),
    "on a line": np.outer(np.arange(500.0), [1, 2, 3]),
    "huge numbers": POINTS * 1e300,
    "past float32": POINTS * 1e60,
}


@pytest.mark.parametrize("kind", BAD)
@pytest.mark.parametrize("call", [pcl_spiral.spiral, pcl_spiral.drive])
def test_what_is_no_scan_is_refused(kind, call):
    settings = SETTINGS if call is pcl_spiral.spiral else {"tool_radius": 6, "step_over": 5}
    with pytest.raises(pcl_spiral.Error) as error:
        call(BAD[kind], **settings)
    assert len(str(error.value)) > 30 and any(mark in str(error.value) for mark in ":;"), error.value


@pytest.mark.parametrize("points", [np.array([[1, "a", 2]], object), POINTS.astype(object), POINTS.astype(complex), [["a", "b", "c"]], None, 3, {}, lambda: 0, np.zeros(5, "U3"), np.zeros(9, [("x", "f8"), ("y", "f8")])])
def test_what_is_no_array_of_numbers_is_refused(points):
    with pytest.raises((TypeError, pcl_spiral.Error), match="points"):
        pcl_spiral.spiral(points, **SETTINGS)


def test_faces():
    vertices, faces = saddle(12)
    settings = SETTINGS | {"sample_spacing": 1}
    path = pcl_spiral.spiral(vertices, faces=faces, **settings)
    for other in (faces.astype(np.uint32), faces.astype(">i4"), np.asfortranarray(faces), faces.tolist()):
        assert pcl_spiral.spiral(vertices, faces=other, **settings).contact.tobytes() == path.contact.tobytes()
    for wrong in (faces - 1, faces + 1, faces.astype(np.int64) + 2**40):
        with pytest.raises(pcl_spiral.Error, match="faces= names the point"):
            pcl_spiral.spiral(vertices, faces=wrong, **SETTINGS)
    for wrong in (faces[:, :2], faces.astype(float), True, 3, "part.stl"):
        with pytest.raises(TypeError, match="faces="):
            pcl_spiral.spiral(vertices, faces=wrong, **SETTINGS)
    with pytest.raises(pcl_spiral.Error):
        pcl_spiral.spiral(vertices, faces=faces[:0], **SETTINGS)
    with pytest.raises(pcl_spiral.Error, match="faces="):
        pcl_spiral.spiral(vertices, faces=faces, normals=vertices, **SETTINGS)


def test_too_large_is_not_called_infinite():
    for factor in (1e300, 1e60, 1e14):
        with pytest.raises(pcl_spiral.Error, match="all coordinates are too large.*unit=") as error:
            pcl_spiral.spiral(POINTS * factor, **SETTINGS)
        assert error.value.code == "invalid-input"
    with pytest.raises(pcl_spiral.Error, match="finite"):
        pcl_spiral.spiral(POINTS * np.nan, **SETTINGS)


def test_one_polygon_is_a_list_of_one(folder):
    square = [[-3.0, -3], [3, -3], [3, 3], [-3, 3]]
    (folder / "square.txt").write_text("-3 -3\n3 -3\n3 3\n-3 3\n")
    expected = pcl_spiral.spiral(POINTS, keep_outs=[square], **SETTINGS).contact.tobytes()
    for one in (square, np.array(square), "square.txt", ["square.txt"], (square,)):
        assert pcl_spiral.spiral(POINTS, keep_outs=one, **SETTINGS).contact.tobytes() == expected
    whole = pcl_spiral.spiral(POINTS, regions=[(0, 0, 5)], **SETTINGS).contact.tobytes()
    assert pcl_spiral.spiral(POINTS, regions=(0, 0, 5), **SETTINGS).contact.tobytes() == whole
    for wrong in (5, (1, 2), lambda: 0):
        with pytest.raises((TypeError, pcl_spiral.Error), match="keep_outs="):
            pcl_spiral.spiral(POINTS, keep_outs=wrong, **SETTINGS)


@pytest.mark.parametrize("unit, factor", [("mm", 1.0), ("m", 1000.0), ("inch", 25.4)])
@pytest.mark.parametrize("origin", [None, (300.0, 200.0, 10.0)])
def test_places_and_polygons_are_in_the_coordinates_of_the_points(unit, factor, origin):
    """The same job in another unit and about another origin: the same path, to the rounding of the numbers."""
    off = np.zeros(3) if origin is None else np.array(origin)
    two = np.concatenate([POINTS, POINTS + [200, 0, 0]])
    box = np.array([[150.0, -40], [250, -40], [250, 40], [150, 40]])

    def made(points, place, polygon, keep, start, view, **settings):
        common = {"part_at": place, "start": start, "view_point": view, "crop": polygon, "keep_outs": [keep], **settings}
        return pcl_spiral.spiral(points, **SETTINGS, **common)

    keep = np.array([[190.0, -3], [196, -3], [196, 3], [190, 3]])
    values = [two, (200, 0, 5), box, keep, (200, 24, 0), (200, 0, 900)]
    expected = made(*values, origin=(0, 0, 0))
    moved = [np.array(value) / factor + off[: np.shape(value)[-1]] for value in values]
    path = made(*moved, unit=unit, origin=tuple(off))
    assert len(path) == len(expected) and np.abs(path.contact - expected.contact).max() < 2e-3
    with pytest.raises(pcl_spiral.Error) as error:
        pcl_spiral.spiral(moved[0], unit=unit, origin=tuple(off), **SETTINGS)
    place = max(error.value.places)  # of the second part, as the message has it: it can be given back
    again = pcl_spiral.spiral(moved[0], unit=unit, origin=tuple(off), part_at=place, **SETTINGS)
    assert np.abs(again.contact.mean(axis=0) - [200, 0, 1]).max() < 5
    by_place = pcl_spiral.spiral(moved[0], unit=unit, origin=tuple(off), regions=[moved[1]], **SETTINGS)
    by_polygon = pcl_spiral.spiral(moved[0], unit=unit, origin=tuple(off), regions=[moved[2]], **SETTINGS)
    assert by_place.contact.tobytes() == by_polygon.contact.tobytes() == again.contact.tobytes()


def test_polygons_and_holders():
    for wrong in ([[0, 0], [1, 1]], [[0, 0], [1, 1], [1, 0], [0, 1]], np.zeros((4, 4)), [[0, 0], [np.nan, 0], [1, 1]]):
        with pytest.raises(pcl_spiral.Error, match="keep_outs="):
            pcl_spiral.spiral(POINTS, keep_outs=[wrong], **SETTINGS)
    with pytest.raises(pcl_spiral.Error, match="crop="):
        pcl_spiral.spiral(POINTS, crop=(5, -5, 0, 3), **SETTINGS)
    for wrong in ([6, 40], [(6,)], [("a", 40)], 5):
        with pytest.raises(TypeError):
            pcl_spiral.spiral(POINTS, holder=wrong, flank_length=20, **SETTINGS)
    with pytest.raises(pcl_spiral.Error):
        pcl_spiral.spiral(POINTS, holder=[(6, -40)], flank_length=20, **SETTINGS)


def test_the_input_stays_as_it_is():
    points = POINTS.copy()
    pcl_spiral.spiral(points, **SETTINGS)
    assert points.tobytes() == POINTS.tobytes()


def test_normals_are_used_or_refused(folder):
    write_points("cap.xyz", POINTS)
    down = np.tile([0.0, 0.0, -1.0], (len(POINTS), 1))
    assert np.mean(pcl_spiral.spiral(POINTS, normals=down, **SETTINGS).normal[:, 2]) < -0.8
    with pytest.raises(pcl_spiral.Error, match="normals= goes with an array"):
        pcl_spiral.spiral("cap.xyz", normals=down, **SETTINGS)
    for nothing in (0.0 * down, np.nan * down):
        with pytest.raises(pcl_spiral.Error, match="holds no direction"):
            pcl_spiral.spiral(POINTS, normals=nothing, **SETTINGS)


def test_masked_points_are_left_out():
    masked = np.ma.array(np.concatenate([POINTS, [[0.0, 0.0, 30.0]]]), mask=False)
    masked[-1] = np.ma.masked
    path = pcl_spiral.spiral(masked, **SETTINGS)
    assert np.array_equal(path.contact, EXPECTED.contact)


def test_odd_containers_are_refused(folder):
    wide = np.zeros(3, [("x", "f8", (200,)), ("y", "f8"), ("z", "f8")])
    with pytest.raises(TypeError, match="several values in the field x"):
        pcl_spiral.spiral(wide, **SETTINGS)
    write_points("cap.xyz", POINTS)

    class Name:
        def __fspath__(self):
            return b"cap.xyz"

    assert len(pcl_spiral.spiral(Name(), **SETTINGS)) > 0
    for name in ("cap\0.xyz", "cap\udc80.xyz", b"cap.xyz"):
        with pytest.raises((TypeError, pcl_spiral.Error), match="points="):
            pcl_spiral.spiral(name, **SETTINGS)
    for name in ("a\0b.csv", "x\udc80.csv", 5, ""):
        with pytest.raises((TypeError, pcl_spiral.Error), match="file="):
            EXPECTED.save(name)
    for wrong in (True, 10**400):
        with pytest.raises(TypeError, match="tool_radius="):
            pcl_spiral.spiral(POINTS, tool_radius=wrong, scallop=0.5)
    assert len(pcl_spiral.spiral(POINTS, outlier_neighbours=2**31 - 1, **SETTINGS)) > 0
