# SPDX-License-Identifier: BSD-3-Clause
"""Planners and modifiers written in Python take the place of those of the library."""

import gc
import threading
import weakref

import numpy as np
import pytest
from conftest import cap

import pcl_spiral

SETTINGS = {"tool_radius": 6, "scallop": 0.1}
CAP = cap(6000, rim=40.0, sphere=90.0)


class Rows(pcl_spiral.Planner):
    """Rows along x, each a pass, on a cap about a place."""

    def __init__(self, place=(0, 0, 0)):
        self.place = np.array(place, float)

    def plan(self, surface, boundaries, settings):
        self.seen = settings.tool_radius, [loop.type for loop in boundaries], threading.current_thread()
        points, rows = surface.points - self.place, []
        for y in np.arange(-25, 26, 5.0):
            x = np.arange(-25, 26, 1.0)
            z = points[np.argmin(np.hypot(points[:, 0] - x[:, None], points[:, 1] - y), axis=1), 2]
            rows.append(np.column_stack([x, 0 * x + y, z]) + self.place)
        return rows


@pytest.mark.parametrize("place", [(0, 0, 0), (4e8, 3e8, 0)])
def test_a_planner_makes_rows(place):
    planner = Rows(place)
    path = pcl_spiral.spiral(CAP + place, planner=planner, **SETTINGS)
    assert planner.seen[:2] == (6, ["outer"]) and planner.seen[2] is not threading.main_thread()
    assert len(path.passes) == 11
    contact = path.contact - place
    for k, row in enumerate(path.passes):
        x, y, _ = contact[row].T
        assert np.abs(y + 25 - 5 * k).max() < 0.3 and abs(x.max() - x.min() - 50) < 1
    assert np.abs(np.linalg.norm(contact - [0, 0, -np.sqrt(90.0**2 - 40.0**2)], axis=1) - 90).max() < 0.01
    again = pcl_spiral.spiral_over(pcl_spiral.surface(CAP + place), planner=planner, **SETTINGS)
    assert again.contact.tobytes() == path.contact.tobytes()


class Changed(pcl_spiral.Modifier):
    def __init__(self, change):
        self.change = change

    def modify(self, surface, settings, path):
        self.change(path)


def test_a_modifier_changes_the_path():
    expected = pcl_spiral.spiral(CAP, **SETTINGS)
    seen = []
    same = pcl_spiral.spiral(CAP, modifiers=[Changed(lambda path: seen.append(sorted(vars(path))))], **SETTINGS)
    for name in ("contact", "normal", "axis", "turn", "arc_length"):
        assert getattr(same, name).tobytes() == getattr(expected, name).tobytes(), name
    assert seen == [["axis", "contact", "foot", "lift", "normal", "over_gap", "passes", "turn"]]

    def upright(path):
        path.axis[:] = path.normal

    path = pcl_spiral.spiral(CAP, modifiers=[Changed(upright), Changed(lambda path: None)], **SETTINGS)
    assert np.abs(path.axis - path.normal).max() < 1e-6 and path.contact.tobytes() == expected.contact.tobytes()

    def half(path):
        size = len(path.contact) // 2
        for name in ("contact", "normal", "axis", "turn", "over_gap"):
            setattr(path, name, getattr(path, name)[:size])

    path = pcl_spiral.spiral_over(pcl_spiral.surface(CAP), modifiers=[Changed(half)], **SETTINGS)
    assert len(path) == len(expected) // 2 and path.contact.tobytes() == expected.contact[: len(path)].tobytes()


def test_what_is_no_path_is_refused():
    def short(path):
        path.normal = path.normal[:-1]

    def inward(path):
        path.normal *= -1

    for change in (short, inward):
        with pytest.raises(pcl_spiral.Error):
            pcl_spiral.spiral(CAP, modifiers=[Changed(change)], **SETTINGS)
    for change in (lambda path: setattr(path, "axis", "up"), lambda path: setattr(path, "contact", np.zeros(5))):
        with pytest.raises((TypeError, ValueError), match="modifiers="):
            pcl_spiral.spiral(CAP, modifiers=[Changed(change)], **SETTINGS)

    class Gives(pcl_spiral.Planner):
        def __init__(self, given):
            self.given = given

        def plan(self, surface, boundaries, settings):
            return self.given

    for given in (np.zeros((5, 2)), [np.zeros(3)], "part.csv", [], [np.zeros((0, 3))], np.full((9, 3), np.nan), np.zeros((5, 3)), [[[1, 1, 900]]], None, 5):
        with pytest.raises((TypeError, ValueError)):
            pcl_spiral.spiral(CAP, planner=Gives(given), **SETTINGS)
    for wrong in (5, pcl_spiral.Modifier(), "rows"):
        with pytest.raises(TypeError, match="planner=.*plan()"):
            pcl_spiral.spiral(CAP, planner=wrong, **SETTINGS)
    with pytest.raises(NotImplementedError):
        pcl_spiral.spiral(CAP, planner=pcl_spiral.Planner(), **SETTINGS)


def test_exceptions_come_through_and_nothing_is_kept():
    class Own(Exception):
        pass

    class Fails(pcl_spiral.Planner, pcl_spiral.Modifier):
        def plan(self, *given):
            raise Own("plan")

        def modify(self, *given):
            raise Own("modify")

    fails = Fails()
    alive = weakref.ref(fails)
    for keyword in ({"planner": fails}, {"modifiers": [fails]}):
        with pytest.raises(Own):
            pcl_spiral.spiral(CAP, **keyword, **SETTINGS)
    rows = Rows()
    path = pcl_spiral.spiral(CAP, planner=rows, progress=lambda share, stage: True, **SETTINGS)
    kept = weakref.ref(rows)
    del fails, rows, path, keyword
    gc.collect()
    assert alive() is None and kept() is None


def test_planners_in_several_threads_at_once():
    expected = pcl_spiral.spiral(CAP, planner=Rows(), **SETTINGS).contact.tobytes()
    made = []
    threads = [threading.Thread(target=lambda: made.append(pcl_spiral.spiral(CAP, planner=Rows(), **SETTINGS).contact.tobytes())) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert made == [expected] * 6
