# SPDX-License-Identifier: BSD-3-Clause
"""Every setting is a keyword: tests made from the tables of settings."""

import inspect
import math
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest
from conftest import cap, source

import pcl_spiral
from pcl_spiral import _keywords, _stub

FUNCTIONS = {
    "spiral": lambda **k: pcl_spiral.spiral(CAP, **({"tool_radius": 6, "scallop": 0.5} | k)),
    "drive": lambda **k: pcl_spiral.drive(CAP, **({"tool_radius": 6, "step_over": 6} | k)),
    "ridge": lambda **k: pcl_spiral.ridge(rail=RAIL, generator=ACROSS, **({"spot": 4, "reference": (0, 0, 1)} | k)),
    "verify": lambda **k: pcl_spiral.verify(CAP, PATH, **({"tool_radius": 6} | k)),
    "program": lambda **k: pcl_spiral.program(PATH, "part.ngc", **k),
}
CAP = cap(400)
PATH = pcl_spiral.spiral(CAP, tool_radius=6, scallop=0.5)
X = np.linspace(0, 200, 60)
RAIL = np.column_stack([X, 0 * X, 0.0005 * X * (200 - X)])
Y = np.linspace(-10, 10, 30)
ACROSS = np.column_stack([0 * Y + 100, Y, 5 - 0.02 * Y**2])
ROWS = [(name, row) for name in FUNCTIONS for row in _keywords.table_of(name) if "text" in row]
NUMBERS = [(name, row) for name, row in ROWS if row["type"] in ("int", "float", "float | None")]


def named(pair):
    return f"{pair[0]}-{pair[1]['name']}"


def outside(row):
    """A number that the setting does not take, at each end of its range."""
    step = 1 if row["type"] == "int" else 0.001
    if math.isfinite(row["least"]):
        yield row["least"] - step if row["takes_least"] else row["least"]
    if math.isfinite(row["most"]):
        yield row["most"] + step if row["takes_most"] else row["most"]
    if row["type"] != "int":
        yield math.nan


@pytest.mark.parametrize("pair", NUMBERS, ids=named)
def test_a_number_out_of_range_is_refused_with_name_value_and_rule(pair, folder):
    name, row = pair
    for value in outside(row):
        with pytest.raises(pcl_spiral.Error) as error:
            FUNCTIONS[name](**{row["name"]: int(value) if row["type"] == "int" else value})
        text = str(error.value)
        assert row["name"] + "=" in text and "must be" in text, text
        assert math.isnan(value) or re.search(r"-?\d", text), text
        assert error.value.code == "invalid-argument" and "{" not in text and "set" + "Tool" not in text
        assert row["example"] == "" or row["example"] in text


@pytest.mark.parametrize("pair", ROWS, ids=named)
def test_values_of_another_type_are_refused_with_the_name(pair, folder):
    name, row = pair
    for value in (object(), [1, 2], "no such word", {}):
        with pytest.raises((TypeError, pcl_spiral.Error), match=row["name"] + "="):
            FUNCTIONS[name](**{row["name"]: value})


def result(name, **settings):
    """What a call makes, as bytes; an error as its text."""
    try:
        made = FUNCTIONS[name](**settings)
    except pcl_spiral.Error as error:
        return str(error)
    if name == "verify":
        return b"".join(deviation.tobytes() for deviation in made.deviation) + repr(made.broken).encode()
    if name == "program":
        with open(made.file, "rb") as file:
            return file.read()
    return made.contact.tobytes() + made.axis.tobytes() + made.tip.tobytes()


@pytest.fixture(scope="module")
def plain(tmp_path_factory):
    """What each call makes with the settings that it needs alone."""
    folder = tmp_path_factory.mktemp("plain")
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        return {name: result(name) for name in FUNCTIONS}


@pytest.mark.parametrize("pair", [pair for pair in ROWS if pair[1]["default"] is not ...], ids=named)
def test_the_default_changes_nothing_and_help_has_all(pair, folder, plain):
    name, row = pair
    call = getattr(pcl_spiral, name)
    assert isinstance(plain[name], bytes) and len(plain[name]) > 100
    assert row["name"] in inspect.signature(call).parameters
    assert f"    {row['name']}: {row['type']}" in call.__doc__ and row["help"] in call.__doc__
    given = result(name, **{row["name"]: row["default"]})
    idle = isinstance(given, str) and re.match(rf"{row['name']}=?:? ?.*(leave|belongs)", given)  # asked for, it would do nothing
    needed = (name, row["name"]) in {("drive", "step_over"), ("drive", "tool_radius"), ("ridge", "spot"), ("ridge", "reference")}
    assert given == plain[name] or idle or needed, given


REPORTED = [pair for pair in ROWS if pair[0] in ("spiral", "drive") and pair[1]["name"] not in ("unit", "origin", "flip_normals")]


@pytest.mark.parametrize("pair", REPORTED, ids=named)
def test_a_value_reaches_the_library(pair):
    """The report has it, or the call refuses what it means beside others."""
    name, row = pair
    kind = row["type"]
    if kind.startswith(("bool", "Literal")):
        value = not row["default"] if kind == "bool" else re.findall(r"'([^']*)'", kind)[-1]
    elif kind.startswith("Place"):
        value = [float(x) for x in row["example"].split(",")]
    else:
        value = (int if kind == "int" else float)(row["example"] or 1)
    try:
        report = FUNCTIONS[name](**{row["name"]: value}).report
    except pcl_spiral.Error as error:
        assert error.settings or error.places, error
        return
    if row["name"] in report["settings"] and row["name"] not in ("view_point", "part_at", "center", "start"):
        assert report["settings"][row["name"]] == value


@pytest.mark.parametrize("pair", [pair for pair in ROWS if pair[1]["name"] not in ("unit", "step_over")], ids=named)
def test_a_usual_value_is_taken(pair, folder):
    """It is taken, or refused by the library for what it means beside others, never for its type or its range."""
    name, row = pair
    kind = row["type"]
    if kind == "bool":
        value = not row["default"]
    elif kind.startswith("Literal"):
        value = re.findall(r"'([^']*)'", kind)[-1]
    elif kind.startswith("Place"):
        value = np.array([float(x) for x in row["example"].split(",")])
    else:
        value = np.float64(row["example"] or 1) if kind != "int" else np.int64(row["example"])
    given = {row["name"]: value}
    if (name, row["name"]) == ("drive", "scallop"):
        given["step_over"] = 0
    if name == "ridge" and row["name"] in ("scallop", "tool_radius"):
        given = {"spot": 0, "step_over": 2, "tool_radius": 6, "overlap": 0} | given
        given["step_over"] = 0 if row["name"] == "scallop" else 2
    try:
        FUNCTIONS[name](**given)
    except pcl_spiral.Error as error:
        assert not re.search(rf"it must be .*\({row['name']}=\)", str(error)), error


def test_misspelt_keywords_name_the_nearest():
    for name, wrong, right in (
        ("spiral", "tool_radus", "tool_radius"),
        ("spiral", "scalop", "scallop"),
        ("drive", "stepover", "step_over"),
        ("ridge", "over_lap", "overlap"),
        ("verify", "maxgouge", "max_gouge"),
        ("program", "spindel", "spindle"),
        ("spiral", "keep_out", "keep_outs"),
    ):
        with pytest.raises(TypeError, match=f"{name}\\(\\) has no keyword '{wrong}'; did you mean '{right}'\\?"):
            FUNCTIONS[name](**{wrong: 1})
    with pytest.raises(TypeError, match="help\\(pcl_spiral.spiral\\) lists them"):
        FUNCTIONS["spiral"](qqqqqqqqqqqqqqqqqqqqqqq=1)


def test_errors_speak_of_keywords():
    with pytest.raises(pcl_spiral.Error, match=r"\(scallop=\)") as error:
        pcl_spiral.spiral(CAP, tool_radius=6, scallop=7)
    assert error.value.settings == ("scallop",) and "{setScallopHeight}" in error.value.id
    with pytest.raises(pcl_spiral.Error, match="tool_radius="):
        pcl_spiral.spiral(CAP, scallop=0.1)
    with pytest.raises(pcl_spiral.Error, match="must be one of") as error:
        pcl_spiral.spiral(CAP, tool_radius=6, scallop=0.5, sense="left")
    assert error.value.settings == ("sense",)
    with pytest.raises(TypeError, match="machine="):
        PATH.program("part.ngc", machine=5)
    two = np.concatenate([CAP, CAP + [200, 0, 0]])
    with pytest.raises(pcl_spiral.Error, match="part_at=") as error:
        pcl_spiral.spiral(two, tool_radius=6, scallop=0.5)
    assert len(error.value.places) >= 2 and len(error.value.places[0]) == 3
    assert "--" not in str(error.value) and "setPartAt" not in str(error.value)


def test_types_are_up_to_date_and_strict(folder):
    with open(pcl_spiral.__file__ + "i", encoding="utf-8") as file:
        assert file.read() == _stub.stub()
    (folder / "wrong.py").write_text("import pcl_spiral\npcl_spiral.spiral('a.pcd', tool_radius=6, scallop=0.1, sense='left')\n")
    examples = sorted(str(p) for p in __import__("pathlib").Path(source("examples", "python")).glob("*.py"))
    check = [sys.executable, "-m", "mypy", "--strict", "--cache-dir=/dev/null"]
    shutil.copy(pcl_spiral.__file__ + "i", folder / "pcl_spiral.pyi")  # beside a package of the system mypy finds its typing_extensions
    done = subprocess.run([*check, "pcl_spiral.pyi", *examples], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    done = subprocess.run(check + ["wrong.py"], capture_output=True, text=True)
    assert "sense" in done.stdout and "Found 1 error" in done.stdout, done.stdout


WEIRD = [None, 5, -1.5, True, "", "none.txt", b"x", object(), [], [[]], {}, [None], [5], ["none.txt"], [[0, 0]], [[0, 0, 0]], np.zeros((0, 3))]
WEIRD += [np.full((4, 3), np.nan), np.full((4, 2), 1e308), np.zeros((2, 2, 2)), [np.zeros((4, 2))], np.zeros(4), np.zeros(3, "U2"), lambda: 0]
INPUTS = [(name, row["name"]) for name in FUNCTIONS for row in _keywords.table_of(name) if "text" not in row]


@pytest.mark.parametrize("name, keyword", INPUTS)
def test_whatever_an_input_is_given_it_is_taken_or_refused(name, keyword, folder):
    for value in WEIRD:
        try:
            FUNCTIONS[name](**{keyword: value})
        except (TypeError, pcl_spiral.Error) as error:
            assert len(str(error)) > 20 and "pybind11" not in str(error), error


IDLE = [
    ("spiral", {"sample_spacing": 0.5}, "sample_spacing=.*faces="),
    ("spiral", {"flank_length": 5}, "flank_length=.*holder="),
    ("spiral", {"holder_clearance": 1}, "holder_clearance=.*holder="),
    ("spiral", {"axis": (0, 0, 1), "tilt": 5}, "tilt=.*axis="),
    ("spiral", {"ball_closing": True, "lead": 5}, "lead=.*ball_closing="),
    ("drive", {"column_centre": (0, 0, 0)}, "column_centre=.*column_axis="),
    ("drive", {"column_axis": (0, 0, 1)}, "column_axis=.*drive=.*axis_mode="),
    ("drive", {"curve": np.zeros((9, 3))}, "curve=.*drive="),
    ("drive", {"curve_closed": True}, "curve_closed=.*drive="),
    ("drive", {"overrun": 1}, "overrun=.*drive="),
    ("drive", {"gouge_check": False}, "gouge_check=.*faces="),
    ("drive", {"crease_angle": 20}, "crease_angle=.*faces="),
    ("drive", {"drive": "offset", "direction": 30}, "direction=.*drive="),
    ("drive", {"retilt_step": 2}, "retilt_step=.*max_retilt="),
    ("ridge", {"corner_radius": 1}, "corner_radius=.*tool_radius="),
    ("ridge", {"holder": [(6, 40)]}, "holder=.*tool_radius="),
    ("verify", {"machine": "xyzac.yaml"}, "machine=.*programs"),
    ("verify", {"dialect": "siemens"}, "dialect=.*programs"),
    ("verify", {"sample_spacing": 1}, "sample_spacing=.*faces="),
    ("program", {"dialect": "siemens"}, "dialect=.*language siemens"),
    ("program", {"robot_z": "normal"}, "robot_z=.*yaml"),
]


@pytest.mark.parametrize("name, settings, said", IDLE, ids=[f"{one[0]}-{list(one[1])[-1]}" for one in IDLE])
def test_what_would_do_nothing_is_refused_with_the_other_keyword(name, settings, said, folder):
    with pytest.raises(pcl_spiral.Error, match=said) as error:
        FUNCTIONS[name](**settings)
    assert list(settings)[-1] in error.value.settings and list(folder.iterdir()) == []


@pytest.mark.parametrize("file", ["part.apt", "part.yaml"])
@pytest.mark.parametrize("settings", [{"work_offset": "G55"}, {"machine": "xyzac.yaml"}, {"dialect": "fanuc"}, {"smoothing": 0.1}])
def test_what_a_file_does_not_hold_is_refused(file, settings, folder):
    with pytest.raises(pcl_spiral.Error, match=list(settings)[0] + "=") as error:
        PATH.program(file, **settings)
    assert error.value.settings[0] == list(settings)[0] and list(folder.iterdir()) == []


def test_names_that_are_not_meant_for_users_are_private():
    allowed = set(pcl_spiral.__all__)
    assert {name for name in vars(pcl_spiral) if not name.startswith("_")} == allowed
    types = {"BoundaryLoop", "Error", "Feet", "LinkedPath", "Modifier", "Pass", "Path", "Planner", "Program", "RadialLines", "ScallopLoops"}
    assert types | {"StepOverField", "Surface", "Verification"} == {name for name in allowed if name[0].isupper()}
