# SPDX-License-Identifier: BSD-3-Clause
"""What the programs write, the package writes: the same bytes, from a file and from an array."""

import json

import numpy as np
import pytest
from conftest import cap, points_of, run, saddle, scene, source, write_points

import pcl_spiral

BALL = ("--tool-radius", 4, "--scallop", 0.05)
SCAN = "scan.xyz"


@pytest.fixture
def scan(folder):
    write_points(SCAN, scene())
    (folder / "keep.txt").write_text("-60 -4\n-52 -4\n-52 4\n-60 4\n")
    (folder / "west.txt").write_text("-105 -40\n-78 -40\n-78 40\n-105 40\n")
    (folder / "east.txt").write_text("-72 -40\n-40 -40\n-40 40\n-72 40\n")
    return np.loadtxt(SCAN)


def same(one, other):
    with open(one, "rb") as a, open(other, "rb") as b:
        assert a.read() == b.read()


def spirals_alike(points, options, **settings):
    """By the program, from the file, and from the array."""
    run("toolpath", SCAN, "-o", "program.csv", *BALL, *options)
    for given in (SCAN, points):
        pcl_spiral.spiral(given, tool_radius=4, scallop=0.05, **settings).save("python.csv")
        same("program.csv", "python.csv")


def test_part_and_keep_out(scan):
    corners = np.array([[-60, -4], [-52, -4], [-52, 4], [-60, 4]])
    spirals_alike(scan, ["--part-at", "-75,0,4", "--keep-out", "keep.txt"], part_at=(-75, 0, 4), keep_outs=[corners])


def test_regions_in_polygons_of_a_crop_and_a_holder(scan):
    options = ["--region", "east.txt", "--region", "west.txt", "--crop", "-130,-20,-50,50,-2,50"]
    spirals_alike(
        scan,
        options + ["--flank-length", "20", "--holder", "6,40/20,25,60"],
        regions=["east.txt", "west.txt"],
        crop=(-130, -20, -50, 50, -2, 50),
        flank_length=20,
        holder=[(6, 40), (20, 25, 60)],
    )


def test_regions_by_place_and_robot_frames(scan):
    run("toolpath", SCAN, "-o", "program.yaml", "-o", "program.csv", *BALL, "--part-at", "-75,0,4", "--part-at", "85,10,7")
    path = pcl_spiral.spiral(SCAN, tool_radius=4, scallop=0.05, regions=[(-75, 0, 4), (85, 10, 7)])
    path.program("python.yaml")
    path.save("python.csv")
    same("program.yaml", "python.yaml")
    same("program.csv", "python.csv")
    assert len(path.passes) == 2


def test_settings_of_every_kind(scan):
    options = "--crop -100,-50,-25,25,-2,50 --method constant-scallop --sense cw --one-way --rim inside,1 --feed 2500 --axis 0,0.2,1"
    spirals_alike(
        scan,
        options.split(),
        crop=(-100, -50, -25, 25, -2, 50),
        method="constant-scallop",
        sense="cw",
        one_way=True,
        rim_overhang=-1,
        feed=2500,
        axis=(0, 0.2, 1),
    )


def test_a_mesh(folder):
    vertices, faces = saddle()
    lines = ["v {} {} {}".format(*v) for v in vertices] + ["f {} {} {}".format(*(f + 1)) for f in faces]
    (folder / "part.obj").write_text("\n".join(lines) + "\n")
    run("toolpath", "part.obj", "--mesh", "-o", "program.csv", *BALL)
    run("drive", "part.obj", "--mesh", "-o", "rows.csv", "--tool-radius", 4, "--step-over", 1)
    for points, faces in (("part.obj", True), (vertices, faces)):
        pcl_spiral.spiral(points, faces=faces, tool_radius=4, scallop=0.05).save("python.csv")
        same("program.csv", "python.csv")
        pcl_spiral.drive(points, faces=faces, tool_radius=4, step_over=1).save("python_rows.csv")
        same("rows.csv", "python_rows.csv")


def test_drive_beside_a_keep_out_with_a_holder(scan):
    options = "--tool-radius 4 --scallop 0.1 --part-at -75,0,4 --keep-out keep.txt --flank-length 30 --holder 6,40/20,25,60"
    run("drive", SCAN, "-o", "program.csv", "-o", "program.vtp", *options.split(), "--tolerance", "0.02")
    path = pcl_spiral.drive(
        scan,
        tool_radius=4,
        scallop=0.1,
        part_at=(-75, 0, 4),
        keep_outs=["keep.txt"],
        flank_length=30,
        holder=[(6, 40), (20, 25, 60)],
        tolerance=0.02,
    )
    for kind in ("csv", "vtp"):
        path.save("python." + kind)
        same("program." + kind, "python." + kind)


def test_drive_of_a_bull_nose_with_an_apt(scan):
    options = "--crop -100,-50,-25,25,-2,50 --tool-radius 4 --corner-radius 1 --step-over 4 --direction 30 --one-way --feed 800 --tolerance 0.05"
    run("drive", SCAN, "-o", "program.csv", "-o", "program.apt", *options.split())
    box = (-100, -50, -25, 25, -2, 50)
    path = pcl_spiral.drive(SCAN, crop=box, tool_radius=4, corner_radius=1, step_over=4, direction=30, zigzag=False, feed=800, tolerance=0.05)
    path.save("python.csv")
    path.program("python.apt")
    same("program.csv", "python.csv")
    same("program.apt", "python.apt")


@pytest.fixture
def ridge(folder):
    run("simulate_scan", "--part", "ridge", "-o", "ridge.pcd", "--line-spacing", 1, "--point-spacing", 1)
    return points_of("ridge_rail.pcd")


def test_ridge_of_a_beam(ridge):
    options = "--spot 4 --overlap 0.25 --stand-off 10 --lead 3"
    run("ridge", "ridge_rail.pcd", "ridge_generator.pcd", "-o", "program.6d", "-o", "program.csv", *options.split())
    path = pcl_spiral.ridge(rail=ridge, generator="ridge_generator.pcd", spot=4, overlap=0.25, stand_off=10, lead=3)
    for kind in ("6d", "csv"):
        path.save("python." + kind)
        same("program." + kind, "python." + kind)


def test_ridge_of_a_ball_found_in_a_scan(ridge):
    places = ridge[np.argsort(ridge[:, 0])][[20, 100, 200, 280]].astype(float)
    through = "/".join(",".join(map(repr, map(float, p))) for p in places)
    options = ["--scan", "ridge.pcd", "--through", through, "--half-width", 9, "--tool-radius", 3, "--scallop", 0.2, "--tolerance", 0.05]
    run("ridge", *options, "-o", "program.csv")
    path = pcl_spiral.ridge("ridge.pcd", through=places, half_width=9, tool_radius=3, scallop=0.2, tolerance=0.05)
    path.save("python.csv")
    same("program.csv", "python.csv")


@pytest.mark.parametrize("machine, name, options", [(None, "part.ngc", []), ("xyzac.yaml", "part.mpf", ["--tool", 3])])
def test_programs(scan, machine, name, options):
    given = [] if machine is None else ["--machine", source("examples", "machines", machine)]
    crop = ["--crop", "-100,-50,-25,25,-2,50"]
    lead = ["--lead-in", "arc", "--lead-length", 1, "--spindle", 8000, "--thin-blocks", "0.002,0.05"]
    run("toolpath", SCAN, "-o", name, *BALL, *crop, *lead, *given, *options)
    path = pcl_spiral.spiral(SCAN, tool_radius=4, scallop=0.05, crop=(-100, -50, -25, 25, -2, 50))
    settings = {"lead_in": "arc", "lead_length": 1, "spindle": 8000, "thin_blocks": (0.002, 0.05)}
    if machine:
        settings |= {"machine": source("examples", "machines", machine), "tool": 3}
    made = pcl_spiral.program(path, "python_" + name, **settings)
    same(name, "python_" + name)
    assert made.blocks > 1000 and made.minutes > 1


def test_metres_and_map_coordinates(folder):
    place = np.array([393775.0, 3689071.0, 100.0])
    write_points(SCAN, cap() / 1000 + place)
    points = np.loadtxt(SCAN)
    run("toolpath", SCAN, "-o", "program.csv", "--units", "m", *BALL)
    for given in (SCAN, points):
        path = pcl_spiral.spiral(given, unit="m", tool_radius=4, scallop=0.05)
        path.save("python.csv")
        same("program.csv", "python.csv")
        assert np.abs(path.contact - 1000 * place).max() < 40
    two = np.concatenate([points, points + [0.1, 0, 0]])
    with pytest.raises(pcl_spiral.Error, match="at \\(393775.1, 3689071, 100") as error:
        pcl_spiral.spiral(two, unit="m", tool_radius=4, scallop=0.05)
    right = pcl_spiral.spiral(two, unit="m", tool_radius=4, scallop=0.05, part_at=error.value.places[1])
    assert np.abs(right.contact - 1000 * place - [100, 0, 0]).max() < 40


def test_reports_have_the_same_figures(scan):
    run("toolpath", SCAN, "-o", "program.json", *BALL, "--part-at", "-75,0,4")
    report = pcl_spiral.spiral(SCAN, tool_radius=4, scallop=0.05, part_at=(-75, 0, 4)).report
    with open("program.json", encoding="utf-8") as file:
        other = json.load(file)
    for part in ("units", "input", "surface", "loops", "holes", "path", "not_reached"):
        assert report[part] == other[part], part


def test_verification_has_the_same_figures(scan):
    box = (-100, -50, -25, 25, -2, 50)
    path = pcl_spiral.spiral(SCAN, tool_radius=4, scallop=0.05, crop=box)
    path.save("part.csv")
    options = "--crop -100,-50,-25,25,-2,50 --tool-radius 4 --max-gouge 0.03 -o program.json"
    run("verify", SCAN, "part.csv", *options.split())
    with open("program.json", encoding="utf-8") as file:
        other = json.load(file)
    for judged in (path, "part.csv"):
        found = pcl_spiral.verify(SCAN, judged, crop=box, tool_radius=4, max_gouge=0.03)
        assert found.ok
        for part in ("deviation", "material"):
            ours, theirs = found.report["paths"][0][part], other["paths"][0][part]
            ours["seconds"] = theirs["seconds"] = 0
            assert ours == theirs or judged is path  # a file rounds
    found = pcl_spiral.verify(SCAN, path, crop=box, tool_radius=4, max_gouge=0.0001)
    assert not found.ok and "0.0001" in found.broken[0]


def test_by_stages_as_the_programs(folder):
    write_points("dome.xyz", cap(6000, rim=50.0, sphere=90.0))
    ball = {"tool_radius": 4, "scallop": 0.1}
    surface = pcl_spiral.surface("dome.xyz")
    surface, loops = pcl_spiral.bridge_gaps(surface, pcl_spiral.boundary_loops(surface))
    linked = pcl_spiral.link_loops(pcl_spiral.scallop_loops(pcl_spiral.step_over_field(surface, loops, **ball)))
    for method, made in (("constant-scallop", linked), ("radial", pcl_spiral.radial_lines(surface, loops, **ball))):
        run("toolpath", "dome.xyz", "-o", "program.csv", "--tool-radius", 4, "--scallop", 0.1, "--method", method)
        pcl_spiral.spiral_over(surface, loops, made, method=method, **ball).save("python.csv")
        same("program.csv", "python.csv")
    cutter = {"tool_radius": 4, "corner_radius": 1}
    options = "--tool-radius 4 --corner-radius 1 --step-over 3 --direction 30"
    run("drive", "dome.xyz", *options.split(), "-o", "program.csv", "-o", "program.ngc")
    passes = pcl_spiral.sections("dome.xyz", step_over=3, direction=30, **cutter)
    path = pcl_spiral.cutter_locations("dome.xyz", passes, **cutter)
    path.save("python.csv")
    path.program("python.ngc")
    same("program.csv", "python.csv")
