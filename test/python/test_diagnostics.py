# SPDX-License-Identifier: BSD-3-Clause
"""Everything the library says is an exception in the words of keywords: tests made from the sentences in its sources."""

import pathlib
import re

import numpy as np
import pytest
from conftest import cap, source

import pcl_spiral
from pcl_spiral import _core

LITERALS = re.compile(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*')
COMMENTS = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)
FIELD = re.compile(r"(?<!\{)\{([^{}]+)\}(?!\})")
SETTER = re.compile(r"(set|add|clear)[A-Z]\w*(\(\w+::\w+\))?|[A-Z]\w*::\w+")
ROOMS = ("cleaning", "cutter", "drive", "features", "geodesic", "mesh", "planning", "ridge", "spiral", "surface", "verify", "machine")


def sentences():
    """The literals with fields, of the rooms that scripts reach."""
    found = set()
    for room in ROOMS:
        for folder in (source("pcl_spiral", "src", room), source("pcl_spiral", "include", "pcl_spiral", room)):
            for file in sorted(pathlib.Path(folder).rglob("*.[ch]*")):
                for literal in LITERALS.findall(COMMENTS.sub("", file.read_text())):
                    words = "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', literal))
                    if FIELD.search(words) and "\\" not in words:
                        found.add(words)
    return sorted(found)


WORDS = {name: word for _, words in _core.tables.values() for name, word in words.items()}
KEYWORDS = {row["name"] for table, _ in _core.tables.values() for row in table} | {"points", "scan"}
IN_CODE = {  # what scripts do not have: other inputs of classes, and settings that a planner sets itself
    "LocationEvaluation::FittedSurface", "LocationEvaluation::Points", "SpiralMethod::Radial", "clearRadialLines", "setBoundaryPoints",
    "setCreaseBand", "setDrivePasses", "setDrivePath", "setDrivePoints", "setEvaluation", "setFaces", "setFitTolerance", "setIndices",
    "setInputGenerator", "setInputPasses", "setInputPath", "setInputPlan", "setInputPoses", "setInputProgram", "setInputSurface",
    "setInputTips", "setInputToolpath", "setLevels", "setLocationSurface", "setMargin", "setMaximumIterations", "setPolynomialOrder",
    "setRawScan", "setRounding", "setSampleMesh", "setSearchMethod", "setSearchRadius", "setSearchSurface", "setSettings", "setShank",
    "setSourcePoint", "setSurroundings", "setTargetIndices", "setTargetPoints", "setTolerance",
}
SENTENCES = sentences()


def test_there_are_sentences():
    assert len(SENTENCES) > 150 and sum("{set" in words for words in SENTENCES) > 60


@pytest.mark.parametrize("words", SENTENCES)
def test_every_sentence_is_an_exception_in_the_words_of_keywords(words):
    with pytest.raises(pcl_spiral.Error) as error:
        _core._say(WORDS, words)
    text, raised = str(error.value), error.value
    assert raised.code == "failed" and raised.places == () and raised.id == words
    named = [field for field in FIELD.findall(words) if field in WORDS]
    keywords = [re.search(r"(\w+)=|^(points)$", WORDS[field]) for field in named if re.search("[a-z][A-Z]|::", field)]
    assert raised.settings == tuple(dict.fromkeys(keyword[1] or keyword[2] for keyword in keywords if keyword))
    assert "{set" not in text and "{mm}" not in text and "--" not in text
    for field in FIELD.findall(words):
        assert not SETTER.fullmatch(field) or field in WORDS or field in IN_CODE, f"no keyword for {field}"
    remarks = re.findall(r"(?<!\w)\(([^()]*)\)", words)
    dropped = {field for remark in remarks for field in FIELD.findall(remark) if not set(FIELD.findall(remark)) <= set(WORDS)}
    for field in set(named) - dropped:
        assert WORDS[field] in text and not re.search(rf"\b{re.escape(field)}\b", text), text


def test_every_word_is_a_keyword():
    for name, word in WORDS.items():
        assert re.split("[= ]", word.removeprefix("without ").removeprefix("leave "))[0] in KEYWORDS or name == "Scale it to mm", word


def test_a_change_that_helps_is_written_as_python_takes_it():
    points, settings = np.concatenate([cap(1500), cap(1200, seed=6) + [80, 0, 0]]), {"tool_radius": 6, "scallop": 0.5}
    with pytest.raises(pcl_spiral.Error) as error:
        pcl_spiral.spiral(points, **settings)
    change = re.search(r"one gives a path of .*: (part_at=\(.*\))$", str(error.value))
    assert change, str(error.value)
    path = pcl_spiral.spiral(points, **settings, **eval(f"dict({change[1]})"))
    assert len(path.contact) > 100


def cap_with_blocks(places, spacing):
    """A cap, and the tops of blocks that hide some of its rim."""
    part, side = cap(4000), np.arange(-3, 3.1, spacing)
    hidden = (abs(part[:, None, :2] - places) < 3.3).all(axis=2).any(axis=1)
    top = np.array([(u, v, 12.0) for u in side for v in side])
    return np.concatenate([part[~hidden]] + [top + [*place, 0] for place in places])


def test_two_changes_together_are_keywords():
    one, settings = cap_with_blocks(np.array([(27, 0)]), 1.0), {"tool_radius": 4, "scallop": 0.2}
    points = np.concatenate([one, one * [-1, 1, 1] - [90, 0, 0]])
    with pytest.raises(pcl_spiral.Error) as error:
        pcl_spiral.spiral(points, **settings)
    change = re.search(r"two together give a path of .*: (part_at=.*)$", str(error.value))
    assert change, str(error.value)
    changed = eval(f"dict({change[1]})")
    assert set(changed) == {"part_at", "keep_outs"}
    assert len(pcl_spiral.spiral(points, **settings, **changed).contact) > 100


def test_further_keep_outs_are_written_with_those_that_were_given(tmp_path):
    places = np.array([(27, 0), (-27, 0), (0, 27), (0, -27)])
    points = cap_with_blocks(places, 0.6)
    about = [place + 5 * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) for place in places[:2]]
    np.savetxt(tmp_path / "keep out.txt", about[1])
    settings = {"tool_radius": 4, "scallop": 0.2, "part_at": (0, 0, 5)}
    for given in ([], [about[0]], [about[0], tmp_path / "keep out.txt"]):
        with pytest.raises(pcl_spiral.Error) as error:
            pcl_spiral.spiral(points, keep_outs=given, **settings)
        change = re.search(r"one gives a path of .*: (keep_outs=.*)$", str(error.value))
        assert change, str(error.value)
        changed = eval(f"dict({change[1]})")
        assert len(changed["keep_outs"]) == len(places)
        assert len(pcl_spiral.spiral(points, **{**settings, **changed}).contact) > 100
