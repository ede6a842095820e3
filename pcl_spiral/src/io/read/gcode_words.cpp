// SPDX-License-Identifier: BSD-3-Clause
#include "gcode_words.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pcl_spiral {
namespace {

/** Codes from \p first to \p last, in tenths, and why they are refused. */
struct RefusedCodes {
  int first, last;
  const char* reason;
};

constexpr RefusedCodes refused_g[] = {
    {20, 35, "an arc; write straight moves (G0, G1)"},
    {50, 59, "a spline; write straight moves (G0, G1)"},
    {70, 79, "programming by diameters or a cycle is not followed; write straight moves in X Y Z"},
    {100, 109, "it sets offsets, which are not in the machine file; set them at the control, and leave the line out"},
    {150, 169, "polar coordinates or a plane of the tool; write X Y Z of the workpiece"},
    {280, 309, "it goes to a place that the machine file does not have; use G53 with Z"},
    {330, 339, "thread cutting; write straight moves (G0, G1)"},
    {380, 389, "probing; leave the line out"},
    {410, 429, "the control shifts the path by a cutter radius of its table; write the path of the tip, with G40"},
    {431, 432, "a tool length from the program; use the length in the machine file, with G43"},
    {500, 529, "it scales or shifts coordinates; write X Y Z of the workpiece"},
    {650, 679, "a subprogram; write all moves in one program"},
    {680, 699, "it turns coordinates; write X Y Z of the workpiece"},
    {730, 769, "a cycle; write straight moves (G0, G1)"},
    {810, 899, "a cycle; write straight moves (G0, G1)"},
    {910, 919, "relative coordinates; write the program with G90"},
    {920, 929, "it shifts coordinates; set work_zero in the machine file"},
};

/** "54", or "59.1" */
std::string
wholeOrTenths(double code)
{
  const int tenths = static_cast<int>(std::lround(10.0 * code));
  return std::to_string(tenths / 10) + (tenths % 10 == 0 ? "" : "." + std::to_string(tenths % 10));
}

std::string
reasonOf(int tenths)
{
  const auto* const found = std::find_if(std::begin(refused_g), std::end(refused_g),
                                         [tenths](const RefusedCodes& codes) { return tenths >= codes.first && tenths <= codes.last; });
  return found == std::end(refused_g) ? "not a code that is understood; leave it out if it does not move the tool" : found->reason;
}

/** Planes, G40, G49's relatives and modes of rounding: they do not change straight moves. */
bool
isHarmless(Dialect dialect, int tenths)
{
  constexpr int everywhere[] = {51, 80, 90, 170, 180, 190, 400, 600, 610, 611, 640, 800, 900};
  constexpr int siemens[] = {601, 602, 641, 642, 643, 644, 645, 5000, 6010, 6020, 6410, 6420, 6430, 6440, 6450};
  if (std::find(std::begin(everywhere), std::end(everywhere), tenths) != std::end(everywhere))
    return true;
  if (dialect == Dialect::Siemens)
    return std::find(std::begin(siemens), std::end(siemens), tenths) != std::end(siemens);
  return tenths == 980 || tenths == 990; // heights of cycles
}

bool
takeMotion(int tenths, GCodeModes& modes)
{
  switch (tenths) {
  case 0:
  case 10:
    modes.rapid = tenths == 0;
    return true;
  case 40:
    return modes.dwells = modes.takes_values = true;
  case 530:
    return modes.of_machine = true;
  case 930:
  case 940:
    modes.inverse_time = tenths == 930;
    return true;
  default:
    return false;
  }
}

bool
takeUnit(Dialect dialect, int tenths, GCodeModes& modes)
{
  constexpr double inch = 25.4;
  const bool siemens = dialect == Dialect::Siemens;
  const bool inches = siemens ? tenths == 700 || tenths == 7000 : tenths == 200;
  const bool millimetres = siemens ? tenths == 710 || tenths == 7100 : tenths == 210;
  if (inches || millimetres)
    modes.unit = inches ? inch : 1.0;
  return inches || millimetres;
}

bool
takeToolLength(Dialect dialect, int tenths, GCodeModes& modes)
{
  if (dialect == Dialect::Siemens)
    return false;
  const bool fanuc = dialect != Dialect::LinuxCNC, guides = fanuc && (tenths == 434 || tenths == 435);
  if (tenths != 430 && tenths != 490 && !guides)
    return false;
  modes.tool_length = tenths != 490;
  if (fanuc)
    modes.guides_tip = guides;
  modes.vectors = tenths == 435;
  return true;
}

bool
isOffset(Dialect dialect, int tenths)
{
  if (dialect == Dialect::Siemens)
    return (tenths >= 540 && tenths <= 570 && tenths % 10 == 0) || (tenths >= 5050 && tenths <= 5990 && tenths % 10 == 0);
  if (tenths >= 540 && tenths <= 590 && tenths % 10 == 0)
    return true;
  return dialect == Dialect::LinuxCNC ? tenths > 590 && tenths < 594 : tenths == 541;
}

/** The machine file has one work_zero, which stands for the one offset of the program. */
std::string
takeOffset(double code, GCodeModes& modes)
{
  const std::string name = "G" + wholeOrTenths(code);
  modes.takes_values = true; // the P of G54.1
  if (!modes.offset.empty() && modes.offset != name)
    return "another work offset than " + modes.offset + " before; judge one program for each work offset";
  modes.offset = name;
  return {};
}

} // namespace

std::string
takeG(Dialect dialect, double code, GCodeModes& modes)
{
  const int tenths = static_cast<int>(std::lround(10.0 * code));
  if (isOffset(dialect, tenths))
    return takeOffset(code, modes);
  if ((tenths == 640 && dialect == Dialect::LinuxCNC) || tenths == 51 || tenths == 80)
    modes.takes_values = true;
  if (takeMotion(tenths, modes) || takeUnit(dialect, tenths, modes) || takeToolLength(dialect, tenths, modes) ||
      isHarmless(dialect, tenths))
    return {};
  return reasonOf(tenths);
}

std::string
takeM(Dialect dialect, double code, bool moved, GCodeModes& modes)
{
  modes.takes_values = true;
  const int whole = static_cast<int>(std::lround(code));
  switch (whole) {
  case 2:
  case 30:
    modes.ended = true;
    return {};
  case 3:
  case 4:
  case 5:
    modes.spindle = whole != 5;
    return {};
  case 6:
    return moved ? "another tool; judge one program for each tool" : "";
  case 17:
  case 97:
  case 98:
  case 99:
    return "a subprogram; write all moves in one program";
  case 70:
  case 71:
  case 72:
  case 73:
    return "it restores modes; write the modes themselves";
  case 428:
  case 429:
    modes.guides_tip = dialect == Dialect::LinuxCNC ? whole == 428 : modes.guides_tip;
    return {};
  case 430:
    return "it changes the kinematics; the machine file has one kinematics: leave it out";
  default:
    return {};
  }
}

std::string
takeKeyword(Dialect dialect, const std::string& word, GCodeModes& modes)
{
  if (dialect == Dialect::Siemens) {
    if (word == "SUPA")
      modes.of_machine = true;
    else if (word == "TRAORI" || word == "TRAFOOF")
      modes.guides_tip = modes.vectors = word == "TRAORI";
    else if (word != "ORIWKS" && word != "ORIVECT")
      return "not a word that is understood; write straight moves with TRAORI, ORIWKS and ORIVECT";
    return {};
  }
  return "not a word that is understood; give the language of the program, or leave the word out if it does not move the tool";
}

} // namespace pcl_spiral
