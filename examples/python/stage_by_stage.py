# SPDX-License-Identifier: BSD-3-Clause
"""A spiral stage by stage: the same bytes as pcl_spiral.spiral. Usage: stage_by_stage.py SCAN OUTPUT.csv"""
import sys

import pcl_spiral

scan, output = sys.argv[1:]
surface = pcl_spiral.surface(scan)  # clean, oriented: made once, shared by all stages
print(f"{len(surface)} points, {surface.spacing:.3g} mm apart, noise {surface.noise:.2g} mm")
loops = pcl_spiral.boundary_loops(surface)
for loop in loops:
    print(f"{loop.type} loop, {loop.length:.1f} mm long")
surface, loops = pcl_spiral.bridge_gaps(surface, loops)  # a new surface, with patches over the gaps
lines = pcl_spiral.radial_lines(surface, loops, tool_radius=6, scallop=0.1)
path = pcl_spiral.spiral_over(surface, loops, lines, tool_radius=6, scallop=0.1, method="radial")
path.save(output)
print(path)
