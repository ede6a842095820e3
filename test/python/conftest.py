# SPDX-License-Identifier: BSD-3-Clause
"""Scenes, and the programs beside the package."""

import os
import subprocess

import numpy as np
import pytest


def cap(count=6000, rim=24.0, sphere=60.0, seed=5, noise=0.002):
    """Points of a cap of a sphere, its rim in the plane z = 0."""
    random = np.random.default_rng(seed)
    r = rim * np.sqrt(random.uniform(size=count))
    angle = random.uniform(0, 2 * np.pi, count)
    z = np.sqrt(sphere**2 - r**2) - np.sqrt(sphere**2 - rim**2)
    return np.column_stack([r * np.cos(angle), r * np.sin(angle), z + random.normal(scale=noise, size=count)])


def scene():
    """Two caps over a table."""
    random = np.random.default_rng(7)
    left, right = cap(5000) + [-75, 0, 0], cap(5000, rim=28.0, seed=6) + [85, 10, 0]
    table = np.column_stack([random.uniform(-140, 140, 9000), random.uniform(-70, 70, 9000), random.normal(-20, 0.002, 9000)])
    return np.concatenate([left, right, table])


def saddle(cells=30):
    """Vertices and faces of a mesh."""
    i, k = np.divmod(np.arange((cells + 1) ** 2), cells + 1)
    vertices = np.column_stack([2.0 * i, 2.0 * k, 0.004 * (i - 15) ** 2 - 0.002 * (k - 12) ** 2])
    a = np.array([i * (cells + 1) + k for i in range(cells) for k in range(cells)])
    b, c, d = a + cells + 1, a + cells + 2, a + 1
    return vertices, np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])


def points_of(file):
    """x y z of a binary .pcd of floats."""
    with open(file, "rb") as stream:
        data = stream.read().split(b"DATA binary\n", 1)[1]
    return np.frombuffer(data, "<f4").reshape(-1, 3)


def write_points(file, points):
    """A text that keeps every digit."""
    np.savetxt(file, points, fmt="%.17g")


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """An empty folder to work in."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def run(program, *arguments):
    """A program of the suite. It must succeed."""
    done = subprocess.run(
        [os.path.join(os.environ["PCL_SPIRAL_PROGRAMS"], "pcl_spiral_" + program), *map(str, arguments)],
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    return done


def source(*names):
    """A file of the project."""
    return os.path.join(os.environ["PCL_SPIRAL_SOURCE"], *names)
