# SPDX-License-Identifier: BSD-3-Clause
"""From a scan to a continuous spiral toolpath. Lengths in mm, angles in degrees."""

from . import _core
from ._inputs import file_of, line, place, scan
from ._keywords import document
from ._results import Error, Program, Verification, complete_path

__version__ = _core.__version__


@document
def spiral(points, **settings):
    """One continuous spiral of a ball cutter over a scan or a mesh, as pcl_spiral_toolpath makes it."""
    return _core.spiral(scan(points, settings), settings)


@document
def drive(points, **settings):
    """Passes of any cutter along planes, a helix, rings, a curve or offsets of the boundary, as pcl_spiral_drive makes them."""
    return _core.drive(scan(points, settings), settings)


@document
def ridge(points=None, **settings):
    """Rows of a beam or a cutter over a ridge from two measured lines, or from a scan, as pcl_spiral_ridge makes them."""
    return _core.ridge(scan(points, settings, "scan_normals"), settings)


@document
def program(path, file, **settings):
    """Writes a path as a program (.ngc .nc .mpf .h), CLDATA (.apt .cls) or robot frames (.yaml), with leads clear of the scan."""
    return Program(**path.write_program(file_of(file), settings))


@document
def verify(points, path, **settings):
    """Judges a path, or the file of a path or a program, by the scan or the mesh that it is meant for, as pcl_spiral_verify does."""
    return Verification(**_core.verify(scan(points, settings), path if isinstance(path, Path) else file_of(path), settings))


@document
def surface(points, **settings):
    """The prepared surface of a scan: clean, oriented, made once for all stages (ScannedSurface)."""
    return _core.surface(scan(points, settings), settings)


@document
def boundary_loops(surface, **settings):
    """The rim, holes and gaps of a surface (BoundaryLoops)."""
    return _core.boundary_loops(surface, settings)


@document
def bridge_gaps(surface, loops, **settings):
    """A surface with patches over its gaps, and its loops without them (GapBridging)."""
    return _core.bridge_gaps(surface, loops, settings)


@document
def radial_lines(surface, loops, **settings):
    """The lines that a radial spiral is drawn on (RadialLines)."""
    return _core.radial_lines(surface, loops, settings)


@document
def spiral_over(surface, loops=(), radial=None, **settings):
    """A spiral over a surface, its loops and radial lines; what is not given is made (SpiralToolpathGenerator)."""
    return _core.spiral_over(surface, loops, radial, settings)


def geodesic_path(surface, source, targets):
    """The shortest path on the surface from a place to each of the targets, (N, 3): an array each (GeodesicPath)."""
    return _core.geodesic_path(surface, place("source", source), line("targets", targets))


Path = complete_path(_core.Path, program)
BoundaryLoop, RadialLines, Surface = _core.BoundaryLoop, _core.RadialLines, _core.Surface
__all__ = ["BoundaryLoop", "Error", "Path", "Program", "RadialLines", "Surface", "Verification", "boundary_loops", "bridge_gaps"]
__all__ += ["drive", "geodesic_path", "program", "radial_lines", "ridge", "spiral", "spiral_over", "surface", "verify"]
