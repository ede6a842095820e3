// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Writers of programs for machine controls.
 */
#pragma once

#include <pcl_spiral/core/control_model.h>
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/setting.h>
#include <pcl_spiral/machine/machine_program.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** The language of a control. */
enum class Dialect {
  LinuxCNC,     ///< G93 with an F on every G1
  Fanuc,        ///< G43.4 H with rotary angles
  FanucVectors, ///< G43.5 H with I J K
  Siemens,      ///< TRAORI, A3= B3= C3=
  Heidenhain    ///< LN with NX NY NZ and TX TY TZ, M128
};

/** Turning direction of the spindle, seen from it to the tool. */
enum class SpindleDirection {
  Clockwise,       ///< M3
  CounterClockwise ///< M4
};

/** What cools the cutter. */
enum class Coolant {
  None,   ///< no word for it
  Mist,   ///< M7
  Flood,  ///< M8
  Through ///< through the spindle, by ControlWords::through
};

/** What F means. */
enum class FeedMode {
  InverseTime, ///< G93: the time of the block. Programs whose rotary axes stand still, and Heidenhain's, have mm/min all the same.
  PerMinute    ///< G94: mm/min of the tip, on Fanuc and Siemens controls with their tip control
};

/** Contents of a program apart from its moves. */
struct ProgramHeader {
  std::string title;           ///< a comment
  double spindle_speed = 0.0;  ///< rev/min; 0: the program does not set the spindle
  int tool = 0;                ///< called at the start; 0: the program calls no tool
  int decimals = 4;            ///< for mm and degrees, 3 to 6
  std::string pass_begin = {}; ///< a line before each run of cutting blocks, such as M62 P0 for a beam; empty: none
  std::string pass_end = {};   ///< a line after each of these runs, such as M63 P0; empty: none
  SpindleDirection spindle_direction = SpindleDirection::Clockwise; ///< of the spindle
  Coolant coolant = Coolant::None;                                  ///< from the start to the end of the program
  std::string work_offset = {};                                     ///< such as G55; empty: G54, for Heidenhain the preset in use
  std::vector<std::string> notes = {};                              ///< more comments, one a line
  int line_step = 0;                                                ///< N10 N20 for 10; 0: no line numbers. Heidenhain always counts by 1
  FeedMode feed_mode = FeedMode::InverseTime;                       ///< of blocks that turn rotary axes
  double smoothing = 0.01; ///< the control may round corners by this, mm, if the machine has no path_tolerance; 0: it stops exactly
};

/** Numbers and choices of \p header; its smoothing comes with the path, and its texts are not of one kind. */
std::vector<Setting> settingTable(ProgramHeader& header);

/** Why \p code cannot be a line of its own, with the remedy: it is not one line of
 *  plain characters, it opens a comment, or it ends the program. Empty if it can. */
Diagnostic faultOfCode(const std::string& code);

/** The same for a line of ShopLines, which may be a comment and may hold names in braces. */
Diagnostic faultOfShopLine(const std::string& line);

/** Why \p offset is no work offset of the language, with the remedy; empty if it is one. LinuxCNC: G54 to G59.3; Fanuc: G54 to G59, G54.1
 *  P1 to P300; Siemens: G54 to G57, G505 to G599; Heidenhain: the number of a preset. */
Diagnostic faultOfOffset(Dialect dialect, const std::string& offset);

/** Writes a program in the language of \p dialect. Its order is the same in all: units and plane, the shop's header, retract, tool,
 *  spindle, coolant, work offset, smoothing, rotary axes to their first angles, over the first point, tip control, the blocks; tip control
 *  off, retract, spindle and coolant off, the shop's footer, end. Rotary axes are in degrees and continue over 360. F is inverse time (G93)
 *  and is in every G1, unless FeedMode says otherwise. The codes of a pass are where the tool is at the first point of a row, after its
 *  lead, and at the last point. So a beam is off on leads, between rows, and while an axis unwinds in a row. \throw FileError the file
 *  cannot be written, the program has no blocks, a code is not a valid line, the control has no word for what the header asks, or the
 *  language takes only tips and tool axes and the machine has no RTCP */
void writeProgram(const std::string& file, const MachineProgram& program, Dialect dialect, const ProgramHeader& header);

/** Writes LinuxCNC: G21 G90 G64 P, G93 with an F on every G1, G94, M2. With RTCP, X Y Z are those of the tip, as xyzac-trt-kins and
 *  xyzbc-trt-kins take them, between ControlWords::tip_control_on and off; without RTCP, those of the machine. \throw FileError */
void writeLinuxCNC(const std::string& file, const MachineProgram& program, const ProgramHeader& header);

/** Writes Fanuc: G43.4 H X Y Z with A B C, all on every line, G93, G49, M30. Without RTCP:
 *  G43 H and the X Y Z of the machine. H is the tool number, or 1. \throw FileError */
void writeFanuc(const std::string& file, const MachineProgram& program, const ProgramHeader& header);

/** The same with G43.5 H and I J K, the vector of the tool axis. \throw FileError */
void writeFanucVectors(const std::string& file, const MachineProgram& program, const ProgramHeader& header);

/** Writes Siemens 840D: CYCLE832, TRAORI, ORIWKS, ORIVECT, A3= B3= C3= on every line, G93, TRAFOOF, M30. \throw FileError */
void writeSiemens(const std::string& file, const MachineProgram& program, const ProgramHeader& header);

/** Writes Heidenhain Klartext: CYCL DEF 32, M128, LN X Y Z NX NY NZ TX TY TZ, F in mm/min
 *  of the tip, which gives the block its time, M129, M30. \throw FileError */
void writeHeidenhain(const std::string& file, const MachineProgram& program, const ProgramHeader& header);

/** What a language is called and takes, and its writer. */
struct DialectEntry {
  Dialect dialect;         ///< the language
  const char* word;        ///< in options and job files
  const char* extension;   ///< of files that are always in this language; none: "". Any other program is a .nc
  bool needs_rtcp;         ///< it takes only tips and tool axes, no rotary angles
  bool feeds_tip;          ///< with tip control, F may be in mm/min of the tip (FeedMode::PerMinute)
  const char* offsets;     ///< a regular expression for its work offsets
  const char* offset_help; ///< the same in words
  void (*write)(const std::string&, const MachineProgram&, const ProgramHeader&); ///< its writer
  ControlKind control;                                                            ///< that reads it, for the machining time
};

/** All languages. A new one needs an entry here, its value and the declaration of its writer above, and a file with the writer. */
inline constexpr std::array dialect_entries{
    DialectEntry{Dialect::LinuxCNC, "linuxcnc", ".ngc", false, false, "G5[4-9]|G59\\.[123]", "G54 to G59, or G59.1 to G59.3", writeLinuxCNC,
                 ControlKind::LinuxCNC},
    DialectEntry{Dialect::Fanuc, "fanuc", "", false, true, "G5[4-9]|G54\\.1 P([1-9]|[1-9][0-9]|[12][0-9][0-9]|300)",
                 "G54 to G59, or G54.1 P1 to G54.1 P300", writeFanuc, ControlKind::Fanuc},
    DialectEntry{Dialect::FanucVectors, "fanuc-ijk", "", true, true, "G5[4-9]|G54\\.1 P([1-9]|[1-9][0-9]|[12][0-9][0-9]|300)",
                 "G54 to G59, or G54.1 P1 to G54.1 P300", writeFanucVectors, ControlKind::Fanuc},
    DialectEntry{Dialect::Siemens, "siemens", ".mpf", true, true, "G5[4-7]|G50[5-9]|G5[1-9][0-9]", "G54 to G57, or G505 to G599",
                 writeSiemens, ControlKind::Siemens},
    DialectEntry{Dialect::Heidenhain, "heidenhain", ".h", true, false, "[0-9]{1,4}", "the number of a preset, such as 1", writeHeidenhain,
                 ControlKind::Heidenhain}};

/** The entry of \p dialect. */
const DialectEntry& entryOf(Dialect dialect);

/** The language that \p extension, in small letters, stands for; none for .nc, which may hold any, and for files that are no programs. */
std::optional<Dialect> dialectOfExtension(const std::string& extension);

/** Whether \p extension, in small letters, is that of a program of a control: .ngc .nc .mpf .h */
bool isProgramExtension(const std::string& extension);

} // namespace pcl_spiral
