# SPDX-License-Identifier: BSD-3-Clause
"""Progress, cancelling, threads, memory, silence, pickling."""

import copy
import multiprocessing
import os
import pickle
import re
import signal
import subprocess
import sys
import threading
import time
from xml.etree import ElementTree

import numpy as np
import pytest
from conftest import cap

import pcl_spiral

SETTINGS = {"tool_radius": 6, "scallop": 0.5}
POINTS = cap(1500)


def test_progress_rises_to_the_end():
    said = []
    pcl_spiral.spiral(POINTS, progress=lambda share, stage: said.append((share, stage)), **SETTINGS)
    shares = [share for share, _ in said]
    assert len(said) > 3 and shares == sorted(shares) and 0 <= shares[0] and shares[-1] <= 1
    assert all(isinstance(stage, str) and stage for _, stage in said)


def test_false_cancels_and_exceptions_come_through():
    class Own(Exception):
        pass

    def fail(share, stage):
        raise Own(stage)

    calls = []
    with pytest.raises(pcl_spiral.Error) as error:
        pcl_spiral.spiral(POINTS, progress=lambda share, stage: bool(calls.append(share)), **SETTINGS)
    assert error.value.code == "cancelled" and len(calls) == 1
    for call, settings in ((pcl_spiral.spiral, SETTINGS), (pcl_spiral.drive, {"tool_radius": 6, "step_over": 5})):
        with pytest.raises(Own):
            call(POINTS, progress=fail, **settings)
    path = pcl_spiral.spiral(POINTS, **SETTINGS)
    with pytest.raises(Own):
        pcl_spiral.verify(POINTS, path, progress=fail, tool_radius=6)
    with pytest.raises(TypeError, match="progress="):
        pcl_spiral.spiral(POINTS, progress=5, **SETTINGS)
    with pytest.raises(TypeError):
        pcl_spiral.spiral(POINTS, progress=lambda: None, **SETTINGS)


LONG = """
import numpy, os, signal, sys, threading, time
import pcl_spiral
sys.path.insert(0, sys.argv[1])
from conftest import cap
signal.signal(signal.SIGINT, signal.default_int_handler)  # which a process in the background does not have
points = cap(400000, rim=50.0)
sent = []
def send():
    time.sleep(float(sys.argv[2]))
    sent.append(time.monotonic())
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=send).start()
try:
    pcl_spiral.spiral(points, tool_radius=2, scallop=0.0005)
    print("done")
except KeyboardInterrupt:
    print(time.monotonic() - sent[0])
"""


@pytest.mark.parametrize("delay", [0.3, 1.0, 2.0])
def test_control_c_cancels_at_once(delay):
    done = subprocess.run([sys.executable, "-c", LONG, os.path.dirname(__file__), str(delay)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    late = float(done.stdout)  # of two cores that others use, too
    print(f"{late:.3f} s after the signal")
    assert late < 0.6


def test_other_threads_of_python_go_on():
    counts = [0]
    stop = threading.Event()

    def count():
        while not stop.is_set():
            counts[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    begin = time.monotonic()
    pcl_spiral.spiral(cap(60000), tool_radius=4, scallop=0.02)
    seconds, counted = time.monotonic() - begin, counts[0]
    stop.set()
    thread.join()
    assert counted > 50 * seconds


def test_eight_threads_at_once_and_cancelled_at_random():
    expected = pcl_spiral.spiral(POINTS, **SETTINGS).contact.tobytes()
    faults = []

    def work(seed):
        random = np.random.default_rng(seed)
        for _ in range(4):
            left = random.integers(1, 30)

            def progress(share, stage):
                nonlocal left
                left -= 1
                return left > 0

            try:
                path = pcl_spiral.spiral(POINTS, progress=progress if random.integers(2) else None, **SETTINGS)
                if path.contact.tobytes() != expected:
                    faults.append("another path")
            except pcl_spiral.Error as error:
                if error.code != "cancelled":
                    faults.append(str(error))

    threads = [threading.Thread(target=work, args=(i,)) for i in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert faults == []


def test_files_and_arrays_are_read_while_other_threads_go_on(folder):
    points = cap(400000, rim=50.0)
    np.savetxt("scan.xyz", points, fmt="%.9g")
    stop, gaps = threading.Event(), []

    def tick():
        last = time.monotonic()
        while not stop.is_set():
            time.sleep(0.002)
            gaps.append((now := time.monotonic()) - last)
            last = now

    thread = threading.Thread(target=tick)
    thread.start()
    for given in ("scan.xyz", points):
        with pytest.raises(pcl_spiral.Error):
            pcl_spiral.spiral(given, tool_radius=6, scallop=0.1, crop=(1e6, 2e6, 0, 1))
    stop.set()
    thread.join()
    assert sorted(gaps)[-2] < 0.15  # of two cores that others use, too; reading takes 0.3 s


def length_with(radius):
    return float(pcl_spiral.spiral(POINTS, tool_radius=radius, scallop=0.5).arc_length[-1])


def test_processes_that_are_forked_after_a_run():
    expected = [length_with(radius) for radius in (5, 6, 7)]
    with multiprocessing.get_context("fork").Pool(2) as pool:
        assert pool.map_async(length_with, (5, 6, 7)).get(timeout=60) == expected


def resident():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def test_memory_stays_flat():
    def once():
        path = pcl_spiral.spiral(POINTS, **SETTINGS)
        path.contact, path.turn, path.report  # noqa: B018
        pickle.loads(pickle.dumps(path))
        with pytest.raises(pcl_spiral.Error):
            pcl_spiral.spiral(POINTS, tool_radius=6, scallop=7)

    count = int(os.environ.get("PCL_SPIRAL_RUNS", "30"))
    for _ in range(8):
        once()
    before = resident()
    for _ in range(count):
        once()
    assert resident() - before < 12  # MB; one path with its plan takes 1.5


def test_nothing_is_printed(capfd):
    pcl_spiral.spiral(POINTS, **SETTINGS)
    for call, points, settings in (
        (pcl_spiral.spiral, POINTS[:3], SETTINGS),
        (pcl_spiral.spiral, POINTS, {"tool_radius": 6}),
        (pcl_spiral.drive, POINTS[:3], {"tool_radius": 6, "step_over": 5}),
        (pcl_spiral.ridge, POINTS, {"tool_radius": 6, "step_over": 5}),
    ):
        with pytest.raises(pcl_spiral.Error):
            call(points, **settings)
    assert capfd.readouterr() == ("", "")


def test_arrays_are_views_that_outlive_the_path():
    path = pcl_spiral.spiral(POINTS, **SETTINGS)
    for name in ("contact", "normal", "tip", "axis", "turn", "arc_length", "lift", "over_gap"):
        first, second = getattr(path, name), getattr(path, name)
        assert first is not second and np.shares_memory(first, second) and not first.flags.owndata and not first.flags.writeable
        with pytest.raises(ValueError):
            first.setflags(write=True)
    assert path.contact.strides == path.normal.strides and path.contact.strides[0] == 96  # one array of poses
    for name, kind in {"turn": "f4", "arc_length": "f8", "lift": "f4", "over_gap": "?"}.items():
        assert getattr(path, name).shape == (len(path),) and getattr(path, name).dtype == kind
    for name in ("contact", "normal", "tip", "axis"):
        array = getattr(path, name)
        assert array.shape == (len(path), 3) and array.dtype == "f8" and not array.flags.writeable
    tip = path.contact + 6 * (path.normal - path.axis)
    assert np.abs(tip - path.tip).max() < 1e-9
    contact, copied = path.contact, path.contact.copy()
    del path
    for _ in range(3):
        pcl_spiral.spiral(POINTS, **SETTINGS)
    assert contact.tobytes() == copied.tobytes()


@pytest.mark.parametrize("kind", ["spiral", "drive"])
def test_pickling(kind, folder):
    path = (
        pcl_spiral.spiral(POINTS, **SETTINGS)
        if kind == "spiral"
        else pcl_spiral.drive(POINTS, tool_radius=6, corner_radius=1, step_over=5)
    )
    for other in (pickle.loads(pickle.dumps(path)), copy.deepcopy(path)):
        for name in ("contact", "normal", "tip", "axis", "turn", "arc_length", "lift", "over_gap"):
            assert getattr(other, name).tobytes() == getattr(path, name).tobytes()
        assert (other.report, other.warnings, other.passes) == (path.report, path.warnings, path.passes)
        path.save("a.csv")
        other.save("b.csv")
        assert open("a.csv", "rb").read() == open("b.csv", "rb").read()
    with pytest.raises(pcl_spiral.Error, match="was unpickled"):
        other.program("part.ngc")
    with pytest.raises(pcl_spiral.Error) as error:
        pcl_spiral.spiral(POINTS[:3], **SETTINGS)
    copied = pickle.loads(pickle.dumps(error.value))
    assert (str(copied), copied.id, copied.code) == (str(error.value), error.value.id, error.value.code)
    found = pcl_spiral.verify(POINTS, path, tool_radius=6, corner_radius=6 if kind == "spiral" else 1)
    assert pickle.loads(pickle.dumps(found)).report == found.report


def test_files_that_cannot_be_written(folder):
    path = pcl_spiral.spiral(POINTS, **SETTINGS)
    for name in ("part.doc", "part", "part.ngc"):
        with pytest.raises(pcl_spiral.Error, match="not known"):
            path.save(name)
    with pytest.raises(pcl_spiral.Error, match="none/part.csv"):
        path.save("none/part.csv")
    for name, settings, said in (
        ("part.csv", {}, "not known"),
        ("part.mpf", {}, "no machine="),
        ("part.nc", {"machine": "none.yaml"}, "no dialect="),
        ("part.ngc", {"machine": "none.yaml"}, "none.yaml"),
    ):
        with pytest.raises(pcl_spiral.Error, match=said):
            path.program(name, **settings)
    with pytest.raises(TypeError):
        path.save(5)
    assert os.listdir() == []


def drawn(path):
    """Places of the lines of a picture, the bars of its part, and its text."""
    html = path._repr_html_()
    picture = ElementTree.fromstring(html[html.index("<svg") : html.index("</svg>") + 6])
    lines = [shape.attrib["d"] for shape in picture if shape.attrib.get("stroke", "none") not in ("none", "#222")]
    places = np.array([float(number) for line in lines for number in re.findall(r"[-\d.]+", line)]).reshape(-1, 2)
    part = [shape.attrib["d"].count("z") for shape in picture if shape.attrib.get("fill") == "#d8dce2"]
    return places, part, " ".join(shape.text for shape in picture if shape.text), len(html)


def test_pictures_of_notebooks():
    path = pcl_spiral.spiral(POINTS + [4e5, 3e6, 0], **SETTINGS)
    places, part, text, size = drawn(path)
    assert size < 200000 and "10 mm" in text and "from the side" in text
    assert (places >= 0).all() and places.max() <= 900 and len(part) == 2 and min(part) > 1
    above = places[: len(places) // 2]  # the same points as from the side
    extent = np.ptp(path.contact, axis=0)
    assert np.ptp(above[:, 0]) / np.ptp(above[:, 1]) == pytest.approx(extent[0] / extent[1], rel=0.02)
    assert drawn(path)[0].tobytes() == places.tobytes()
    kept = drawn(pickle.loads(pickle.dumps(path)))  # which has no scan
    assert kept[0].tobytes() == places.tobytes() and kept[1] == []


def test_pictures_of_many_passes():
    plane = np.stack(np.meshgrid(np.arange(0, 60, 0.5), np.arange(0, 40, 0.5), [0.0]), -1).reshape(-1, 3)
    path = pcl_spiral.drive(plane, tool_radius=0.5, step_over=0.035)
    assert len(path.passes) > 1000 and drawn(path)[3] < 200000


def test_texts_of_notebooks_and_vtk():
    path = pcl_spiral.spiral(POINTS, **SETTINGS)
    assert "points" in repr(path) and repr(path)[1:-1] in path._repr_html_().replace("&lt;", "<").replace("&gt;", ">")
    if not pytest.importorskip("vtkmodules.vtkIOXML"):
        return
    lines = path.to_vtk()
    assert lines.GetNumberOfPoints() == len(path) and lines.GetNumberOfLines() == len(path.passes)


def test_what_is_false_cancels():
    for answer in (np.False_, 0):
        with pytest.raises(pcl_spiral.Error) as error:
            pcl_spiral.spiral(POINTS, progress=lambda share, stage, answer=answer: answer, **SETTINGS)
        assert error.value.code == "cancelled"


def test_broken_pickles_are_refused():
    path = pcl_spiral.spiral(POINTS, **SETTINGS)
    data = pickle.dumps(path)
    points = path.__reduce_ex__(2)[2]
    state = list(points if isinstance(points, tuple) else points[0])
    where = next(i for i, part in enumerate(state) if isinstance(part, bytes) and part)
    state[where] = state[where][:-5]
    fresh = type(path).__new__(type(path))
    with pytest.raises(TypeError, match="broken"):
        fresh.__setstate__(tuple(state))
    assert len(pickle.loads(data)) == len(path)


BESIDE = """
import os, sys, threading, time
sys.path.insert(0, {tests!r})
import pcl_spiral
from conftest import cap
points = cap(60000)
threading.Thread(target=lambda: pcl_spiral.spiral(points, tool_radius=6, scallop=0.02), daemon=True).start()
time.sleep(0.2)
if {fork}:
    child = os.fork()
    if child == 0:
        sys.exit(7)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7
"""


@pytest.mark.parametrize("fork", [False, True])
def test_ends_beside_a_run_of_a_daemon_thread(fork):
    script = BESIDE.format(tests=os.path.dirname(__file__), fork=fork)
    quiet = ["-W", "ignore::DeprecationWarning"]  # of Python from 3.12 on, about forks beside threads
    done = subprocess.run([sys.executable, *quiet, "-c", script], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0 and done.stderr == "", done.stderr
