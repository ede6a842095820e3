// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A program that was read back from its text.
 */
#pragma once

#include <pcl_spiral/core/control_model.h>
#include <pcl_spiral/machine/machine_program.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** A program as the control runs it. */
struct ProgramFile {
  /** Its moves. Each block has tip, axis, angles and machine position. Feed moves are BlockSection::Cut, or Link
   *  between the marks of a link; the others are BlockSection::Position.
   *  normal is the axis, and arc_length is that of the tip: the text says no more. The first block is the first place at which all axes
   *  are known; the way to it is not. */
  MachineProgram program;
  std::vector<std::size_t> lines; ///< line of the text of each block, from 1; empty: of a program without text, whose blocks are counted
  std::size_t still_line = 0;     ///< line of the first feed move with the spindle off (neither M3 nor M4 with an S); 0: none
  std::string language;           ///< word of its entry in dialect_entries, or "apt"
  std::optional<ControlKind> control; ///< that reads this language; absent: not known, as of APT, and so the machining time is not
  std::optional<double> tolerance;    ///< at corners, mm, where the text says it (G64 P)
  bool by_vectors = false; ///< tool axes are vectors: the angles are those nearest to the ones before, and the control may choose others
  bool axis_arcs = false;  ///< the tool axis moves along arcs from block to block (ORIVECT, APT without machine); false: the rotary axes
                           ///< move evenly
};

} // namespace pcl_spiral
