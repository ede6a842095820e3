# SPDX-License-Identifier: BSD-3-Clause
"""What the calls give, and what they raise."""

import html
import json
import os
import tempfile
from dataclasses import dataclass
from typing import NamedTuple

from ._picture import svg


class Pass(NamedTuple):
    """A pass for cutter_locations(): arrays (N, 3). Where a normal is zero, the cutter comes down along the axis."""

    position: object  # mm: where the cutter is to touch, or a place of its axis
    axis: object  # from the tip to the shank
    normal: object  # out of the material


class Feet(NamedTuple):
    """Places projected onto a surface; not-a-number where there is no surface."""

    position: object  # (N, 3), mm
    normal: object  # (N, 3), out of the material
    larger_curvature: object  # (N,), 1/mm, positive where the surface is convex
    smaller_curvature: object


class Planner:
    """Makes the curve in place of the spiral: derive from it, and give an object as planner=."""

    def plan(self, surface, boundaries, settings):
        """Points in travel order near the surface, (N, 3), or a list of such arrays: between them the tool is lifted."""
        raise NotImplementedError


class Modifier:
    """Changes a path before it is checked: derive from it, and give objects as modifiers=."""

    def modify(self, surface, settings, path):
        """Changes arrays of path: contact, normal, axis, turn, over_gap, foot, lift, and passes, the points where further ones begin."""
        raise NotImplementedError


class Error(ValueError):
    """What the library refuses, in the words of keywords: the fault, the place and value, and the remedy."""

    def __init__(self, text, id="", code="failed", places=(), settings=()):
        super().__init__(text)
        self.id = id  # the words without the values: the same for every fault of this kind
        self.code = code  # invalid-argument, invalid-input, failed, cancelled or file
        self.places = places  # (x, y, z) in the coordinates of the points, mm
        self.settings = settings  # keywords that it names

    def __reduce__(self):
        return type(self), (str(self), self.id, self.code, self.places, self.settings)


@dataclass(frozen=True)
class Program:
    """A file that program() wrote."""

    file: str
    warnings: list
    blocks: int = 0  # of CLDATA and robot frames: 0
    minutes: float = 0.0  # without rapids


@dataclass(frozen=True)
class Verification:
    """What verify() found. Arrays: one a region."""

    _report_text: str  # JSON
    broken: tuple  # what is wrong: limits, collisions, wrong poses
    warnings: tuple
    deviation: tuple  # mm, one a path point, positive out of the material
    stock: tuple  # mm, one a point of the scan, or a sample of the mesh

    @property
    def ok(self):
        """Whether nothing is broken."""
        return not self.broken

    @property
    def report(self):
        """All figures with their places, as in the JSON of pcl_spiral_verify."""
        return json.loads(self._report_text)


def _report(path):
    """Settings, figures, times and warnings, as in the JSON report of the programs."""
    return json.loads(path._report_text)


def _repr(path):
    count = len(path.passes)
    length = path.arc_length[-1] / 1000 if len(path) else 0.0
    return f"<pcl_spiral.Path: {len(path)} points, {count} {'pass' if count == 1 else 'passes'}, {length:.3f} m>"


def _repr_html(path):
    rows = "".join(f"<li>{html.escape(warning)}</li>" for warning in path.warnings)
    picture = svg(path, path._part + path._origin) if len(path) else ""
    return f"<p>{html.escape(repr(path))}</p>{picture}" + (f"<ul>{rows}</ul>" if rows else "")


def _to_vtk(path):
    """A vtkPolyData with one polyline a pass, and the point data of a .vtp. Needs the package vtk."""
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    with tempfile.TemporaryDirectory() as folder:
        path.save(os.path.join(folder, "path.vtp"))
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(os.path.join(folder, "path.vtp"))
        reader.Update()
        return reader.GetOutput()


def complete_path(path, program, file_of):
    """The class of the module with what is written in Python."""
    path.__module__ = "pcl_spiral"
    path.__doc__ = "A path. Arrays have one row a point and are read only; lengths in mm, in the coordinates of the points."

    def save(path, file):
        """Writes the path as .csv .pcd .ply .vtp .6d .5d, or its report as .json."""
        path._write(file_of("file", file))

    path.report = property(_report)
    path.program = program
    path.save = save
    path.__repr__ = _repr
    path._repr_html_ = _repr_html
    path.to_vtk = _to_vtk
    return path
