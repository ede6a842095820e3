# SPDX-License-Identifier: BSD-3-Clause
"""From a scan to a continuous spiral toolpath. Lengths in mm, angles in degrees."""

from __future__ import annotations as _annotations  # of types that the stub has

from . import _core, _inputs
from ._keywords import document as _document
from ._results import Error, Feet, Modifier, Pass, Planner, Program, Verification
from ._results import complete_path as _complete_path

__version__ = _core.__version__


@_document
def spiral(points: Points, **settings) -> Path:
    """One continuous spiral of a ball cutter over a scan or a mesh, as pcl_spiral_toolpath makes it."""
    return _core.spiral(_inputs.scan(points, settings), settings)


@_document
def drive(points: Points, **settings) -> Path:
    """Passes of any cutter along planes, a helix, rings, a curve or offsets of the boundary, as pcl_spiral_drive makes them."""
    return _core.drive(_inputs.scan(points, settings), settings)


@_document
def ridge(points: Points | None = None, **settings) -> Path:
    """Rows of a beam or a cutter over a ridge from two measured lines, or from a scan, as pcl_spiral_ridge makes them."""
    return _core.ridge(_inputs.scan(points, settings, "scan_normals"), settings)


@_document
def program(path: Path, file: File, **settings) -> Program:
    """Writes a path as a program (.ngc .nc .mpf .h), CLDATA (.apt .cls) or robot frames (.yaml), with leads clear of the scan."""
    return Program(**path._write_program(_inputs.file_of("file", file), settings))


@_document
def verify(points: Points, path: Path | File, **settings) -> Verification:
    """Judges a path, or the file of a path or a program, by the scan or the mesh that it is meant for, as pcl_spiral_verify does."""
    judged = path if isinstance(path, Path) else _inputs.file_of("path", path)
    return Verification(**_core.verify(_inputs.scan(points, settings), judged, settings))


@_document
def surface(points: Points, **settings) -> Surface:
    """The prepared surface of a scan: clean, oriented, made once for all stages (ScannedSurface)."""
    return _core.surface(_inputs.scan(points, settings), settings)


@_document
def boundary_points(surface: Surface, **settings) -> NDArray[np.bool_]:
    """Which points of a surface lie on its boundary, (N,) of bool (CentroidBoundaryEstimation)."""
    return _core.boundary_points(surface, settings)


@_document
def boundary_loops(surface: Surface, **settings) -> list[BoundaryLoop]:
    """The rim, holes and gaps of a surface (BoundaryLoops)."""
    return _core.boundary_loops(surface, settings)


@_document
def bridge_gaps(surface: Surface, loops: Loops, **settings) -> tuple[Surface, list[BoundaryLoop]]:
    """A surface with patches over its gaps, and its loops without them (GapBridging)."""
    return _core.bridge_gaps(surface, loops, settings)


@_document
def radial_lines(surface: Surface, loops: Loops, **settings) -> RadialLines:
    """The lines that a radial spiral is drawn on (RadialLines)."""
    return _core.radial_lines(surface, loops, settings)


@_document
def step_over_field(surface: Surface, loops: Loops = (), **settings) -> StepOverField:
    """The distance of each place from its nearest boundary, counted in step-overs (StepOverField)."""
    return _core.step_over_field(surface, loops, settings)


@_document
def scallop_loops(field: StepOverField, **settings) -> ScallopLoops:
    """Closed loops one step-over apart that cover the surface of a field (ScallopLoops)."""
    return _core.scallop_loops(field, settings)


@_document
def link_loops(loops: ScallopLoops, **settings) -> LinkedPath:
    """One continuous curve over closed loops (LoopLinking)."""
    return _core.link_loops(loops, settings)


@_document
def spiral_over(surface: Surface, loops: Loops = (), made: RadialLines | StepOverField | ScallopLoops | LinkedPath | None = None, **settings) -> Path:
    """A spiral over a surface and its loops, from radial lines, a field, loops or a linked path on; what is not given is made."""
    return _core.spiral_over(surface, loops, made, settings)


@_document
def sections(points: Points, **settings) -> list[Pass]:
    """Passes of contacts along planes, a helix, rings, a curve or offsets of the boundary (MeshSections, DrivePath)."""
    return [Pass(*one) for one in _core.sections(_inputs.scan(points, settings), settings)]


@_document
def cutter_locations(points: Points, passes: Iterable[Sequence[ArrayLike | None]], **settings) -> Path:
    """A path of any cutter along passes of contacts, lifted where it would cut into the rest of the scan or mesh (CutterLocation)."""
    return _core.cutter_locations(_inputs.scan(points, settings), _inputs.passes("passes", passes), settings)


@_document
def ridge_lines(points: Points, **settings) -> tuple[Doubles, Doubles]:
    """Rail and generator of a ridge in a scan, each (N, 3) (RidgeLines)."""
    return _core.ridge_lines(_inputs.scan(points, settings, None), settings)


@_document
def project(surface: Surface, places: Points, **settings) -> Feet:
    """Feet, normals and curvatures of places (N, 3) on the moving-least-squares surface (MLSProjector)."""
    return Feet(*_core.project(surface, _inputs.line("places", places), settings))


def geodesic_path(surface: Surface, source: Place, targets: Points) -> list[Doubles]:
    """The shortest path on the surface from a place to each of the targets, (N, 3): an array each (GeodesicPath)."""
    return _core.geodesic_path(surface, _inputs.place("source", source), _inputs.line("targets", targets))


Path = _complete_path(_core.Path, program, _inputs.file_of)
BoundaryLoop, LinkedPath, RadialLines, ScallopLoops = _core.BoundaryLoop, _core.LinkedPath, _core.RadialLines, _core.ScallopLoops
StepOverField, Surface = _core.StepOverField, _core.Surface
__all__ = sorted(name for name in globals() if not name.startswith("_"))
