// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Reader of programs for machine controls.
 */
#pragma once

#include <pcl_spiral/io/program_writer.h>
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
  std::vector<std::size_t> lines; ///< line of the text of each block, from 1
  std::size_t still_line = 0;     ///< line of the first feed move with the spindle off (neither M3 nor M4 with an S); 0: none
  std::string language;           ///< word of its entry in dialect_entries, or "apt"
  bool by_vectors = false; ///< tool axes are vectors: the angles are those nearest to the ones before, and the control may choose others
  bool axis_arcs = false;  ///< the tool axis moves along arcs from block to block (ORIVECT, APT without machine); false: the rotary axes
                           ///< move evenly
};

/** Reads a program back from its text: G-code and Klartext as writeProgram makes them, and other programs of straight moves; APT (.apt,
 *  .cls). A .ngc is for LinuxCNC, a .mpf for Siemens, a .h for Heidenhain. The language of a .nc is found from its words. \p dialect
 *  overrides both. Modal words, comments, line numbers, G0 G1, G20 G21, G93 G94, G43 G43.4 G43.5, G53, TRAORI, SUPA, M128, M91 are
 *  followed. Tool axes become angles of \p machine nearest to those before. An APT needs no machine.
 *
 *  \throw FileError with line, word and remedy for a word that is not understood: arcs, cycles, subprograms, variables, offsets, relative
 *  coordinates; for a program that ends without its end; and for a machine that the program was not made for: other rotary axes, or
 *  rtcp that does not suit the words of the program */
ProgramFile readProgram(const std::string& file, const std::optional<Machine>& machine, std::optional<Dialect> dialect = {});

} // namespace pcl_spiral
