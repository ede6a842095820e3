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
  Fanuc,        ///< G43.4 with rotary angles
  FanucVectors, ///< G43.5 with I J K
  Siemens,      ///< TRAORI, A3= B3= C3=
  Heidenhain    ///< LN with TX TY TZ, M128
};

/** What a program says beyond its moves. */
struct ProgramHeader {
  std::string title;          ///< a comment
  double spindle_speed = 0.0; ///< rev/min; 0: the spindle is left alone
  int tool = 0;               ///< called at the start; 0: the tool is left alone
  int decimals = 4;           ///< of mm and degrees
};

/** A program for LinuxCNC: G21 G90 G64 P, G93 with an F on every G1, rotary axes in degrees that
 * count on turn by turn. With RTCP X Y Z are the tip's, as xyzac-trt-kins and xyzbc-trt-kins take them; without, the machine's.
 *  \throw FileError */
void writeLinuxCNC(const std::string& file, const MachineProgram& program, const ProgramHeader& header);

} // namespace pcl_spiral
