// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Reader of programs for machine controls.
 */
#pragma once

#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/program_file.h>

#include <optional>
#include <string>

namespace pcl_spiral {

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
