/** \file
 *  Writers of programs for machine controls.
 */
#pragma once

#include <pcl_spiral/machine/machine_program.h>

#include <string>

namespace pcl_spiral {

/** The language of a control. */
enum class Dialect {
  LinuxCNC,     ///< G93 with an F on every G1
  Fanuc,        ///< G43.4 H with rotary angles
  FanucVectors, ///< G43.5 H with I J K
  Siemens,      ///< TRAORI, A3= B3= C3=
  Heidenhain    ///< LN with NX NY NZ and TX TY TZ, M128
};

/** What a program says beyond its moves. */
struct ProgramHeader {
  std::string title;          ///< a comment
  double spindle_speed = 0.0; ///< rev/min; 0: the spindle is left alone
  int tool = 0;               ///< called at the start; 0: the tool is left alone
  int decimals = 4;           ///< of mm and degrees, 3 to 6
  std::string pass_begin = {}; ///< a line before each run of cutting blocks, such as M62 P0 for a beam; empty: none
  std::string pass_end = {};   ///< a line after each of them, such as M63 P0; empty: none
};

/** Why \p code cannot stand on a line of its own, with the remedy: not one line of plain characters, opens a comment, or ends the
 *  program. Empty where it can. */
std::string faultOfCode(const std::string& code);

/** A program in the language of \p dialect. Rotary axes in degrees that count on turn by turn; F, but in
 * Heidenhain's, is inverse time (G93) and stands in every G1. The codes of a pass stand where the tool is at the first
 * point of a row, after its lead, and at the last: a beam is off on leads, between rows, and while an axis unwinds in a row.
 * \throw FileError the file cannot be written, the program has no blocks, a code is no line of it, or the language takes
 * tips and tool axes alone and the machine has no RTCP */
void writeProgram(const std::string& file, const MachineProgram& program, Dialect dialect,
                  const ProgramHeader& header);

/** LinuxCNC: G21 G90 G64 P, G93 with an F on every G1, G94, M2. With RTCP X Y Z are the tip's, as
 * xyzac-trt-kins and xyzbc-trt-kins take them; without, the machine's. \throw FileError */
void writeLinuxCNC(const std::string& file, const MachineProgram& program, const ProgramHeader& header);

/** Fanuc: G43.4 H (or G43.5 H where \p vectors) X Y Z with A B C or I J K, all on every line, G93, G49, M30.
 * Without RTCP G43 H and the machine's X Y Z. H is the tool's number, or 1. \throw FileError */
void writeFanuc(const std::string& file, const MachineProgram& program, const ProgramHeader& header,
                bool vectors);

/** Siemens 840D: TRAORI, ORIWKS, ORIVECT, A3= B3= C3= on every line, G93, TRAFOOF, M30. \throw FileError */
void writeSiemens(const std::string& file, const MachineProgram& program, const ProgramHeader& header);

/** Heidenhain Klartext: M128, LN X Y Z NX NY NZ TX TY TZ, F in mm/min of the tip that gives the block its
 * time, M129, M30. \throw FileError */
void writeHeidenhain(const std::string& file, const MachineProgram& program, const ProgramHeader& header);

} // namespace pcl_spiral
