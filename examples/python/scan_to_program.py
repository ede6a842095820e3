# SPDX-License-Identifier: BSD-3-Clause
"""From a scan to a program. Usage: scan_to_program.py SCAN MACHINE.yaml PROGRAM.ngc"""
import sys

import pcl_spiral

scan, machine, file = sys.argv[1:]
path = pcl_spiral.spiral(scan, tool_radius=10, scallop=0.05)
for warning in path.warnings:
    print(warning, file=sys.stderr)
program = path.program(file, machine=machine, tool=3, spindle=12000)
print(path, program.blocks, "blocks,", round(program.minutes), "minutes")
