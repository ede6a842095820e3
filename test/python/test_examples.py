# SPDX-License-Identifier: BSD-3-Clause
"""The examples and the lines on the pages run as they stand."""

import pathlib
import re
import shutil
import subprocess
import sys

import pytest
from conftest import cap, run, source

import pcl_spiral


def script(*arguments):
    done = subprocess.run([sys.executable, "-B", *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def example(name):
    return source("examples", "python", name)


@pytest.fixture
def part(folder):
    """part.pcd, part.stl, ridge.pcd and xyzac.yaml, as the pages name them."""
    points = cap(6000, rim=50.0, sphere=90.0)
    rows = "\n".join("{:.9g} {:.9g} {:.9g}".format(*p) for p in points)
    fields = "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1"
    (folder / "part.pcd").write_text(f"{fields}\nWIDTH {len(points)}\nHEIGHT 1\nPOINTS {len(points)}\nDATA ascii\n{rows}\n")
    shutil.copy(source("examples", "machines", "xyzac.yaml"), folder)
    return folder


def test_scan_to_program(part):
    said = script(example("scan_to_program.py"), "part.pcd", "xyzac.yaml", "part.ngc")
    assert re.search(r"\d+ blocks, \d+ minutes", said)
    run("toolpath", "part.pcd", "-o", "other.ngc", "--tool-radius", 10, "--scallop", 0.05, "--machine", "xyzac.yaml", "--tool", 3, "--spindle", 12000)
    assert (part / "part.ngc").read_bytes() == (part / "other.ngc").read_bytes()


def test_stage_by_stage(part):
    script(example("stage_by_stage.py"), "part.pcd", "part.csv")
    pcl_spiral.spiral("part.pcd", tool_radius=6, scallop=0.1, method="radial").save("other.csv")
    assert (part / "part.csv").read_bytes() == (part / "other.csv").read_bytes()


def test_sensor_arrays(folder):
    said = script(example("sensor_arrays.py"), "dome.csv")
    centre, left = re.search(r"(\d+\.\d+) mm from the middle", said), re.search(r"at most (\S+) mm are left; ok", said)
    assert abs(float(centre[1]) - 85) < 1e-3 and float(left[1]) <= 0.105 and (folder / "dome.csv").exists()


def test_robot_cell(folder):
    said = script(example("robot_cell.py")).splitlines()
    assert [bool(re.search("waypoints, highest tip at 80.[0-9] mm", line)) for line in said] == [True, True, False, False]
    assert "clusters='ride'" in said[2] and "81.97" in said[2].rsplit("look at", 1)[1] and "points= is empty" in said[3]
    assert sorted(p.name for p in folder.iterdir()) == ["part_0.yaml", "part_1.yaml"]
    assert (folder / "part_0.yaml").read_bytes() == (folder / "part_1.yaml").read_bytes()


@pytest.mark.parametrize("page", [("README.md",), ("pcl_spiral", "doc", "python.md"), ("pcl_spiral", "doc", "python_stages.md")],
                         ids=lambda names: names[-1])
def test_lines_on_pages_run_word_for_word(page, part):
    blocks = re.findall(r"```python\n(.*?)```", pathlib.Path(source(*page)).read_text(), re.S)
    assert blocks
    for block in blocks:
        (part / "lines.py").write_text(block)
        script("lines.py")
