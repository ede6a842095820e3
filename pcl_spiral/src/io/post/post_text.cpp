// SPDX-License-Identifier: BSD-3-Clause
#include "post_text.h"

#include "io/kinematics_text.h"

#include <pcl_spiral/common/impl/message.h>

#include <pcl_spiral/io/file_error.h>

#include <charconv>

namespace pcl_spiral {
namespace {

constexpr std::size_t full = 1 << 20; ///< bytes to write at once

/** \p text with special characters, and those of \p others, turned to spaces. */
std::string
plainText(std::string text, std::string_view others)
{
  for (char& c : text)
    if (c < ' ' || c > '~' || others.find(c) != std::string_view::npos)
      c = ' ';
  return text;
}

} // namespace

void
PostText::word(std::string_view letters, double value)
{
  word(letters, value, decimals_);
}

void
PostText::word(std::string_view letters, double value, int decimals, bool signs)
{
  if (!at_start_)
    bytes_ += ' ';
  at_start_ = false;
  bytes_ += letters;
  number(value, decimals, signs);
}

void
PostText::number(double value, int decimals, bool signs)
{
  char digits[400]; // the largest double has 309 before the point
  const char* const end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals).ptr;
  std::string_view number(digits, static_cast<std::size_t>(end - digits));
  if (number[0] == '-' && number.find_first_not_of("-0.") == std::string_view::npos)
    number.remove_prefix(1); // no sign on zero
  if (signs && number[0] != '-')
    bytes_ += '+';
  bytes_ += number;
}

void
PostText::endLine(std::string_view end)
{
  bytes_ += end;
  at_start_ = true;
  if (bytes_.size() > full) {
    file_.write(bytes_);
    bytes_.clear();
  }
}

void
PostText::close()
{
  file_.write(bytes_);
  bytes_.clear();
  file_.close();
}

void
writeAngles(PostText& out, const MachineProgram& program, const ProgramBlock& block)
{
  const auto& rotary = program.machine.rotary;
  const bool swap = rotary[0].letter > rotary[1].letter; // A before C
  const double values[2] = {block.angles.first * in_degrees, block.angles.second * in_degrees};
  for (int i : {swap ? 1 : 0, swap ? 0 : 1})
    out.word(std::string_view(&rotary[i].letter, 1), values[i]);
}

void
writeTool(PostText& out, const ProgramHeader& header, std::string_view after)
{
  if (header.tool > 0) {
    out.text("T" + std::to_string(header.tool) + " M6\n");
    out.text(after);
  }
  if (header.spindle_speed > 0.0) {
    out.word("S", header.spindle_speed, 0);
    out.endLine(" M3\n");
  }
}

void
writeVector(PostText& out, const std::array<std::string_view, 3>& letters, const Eigen::Vector3d& v, bool signs)
{
  for (int i = 0; i < 3; ++i)
    out.word(letters[i], v[i], 8, signs);
}

std::string
faultOfCode(const std::string& code)
{
  constexpr std::string_view remedy = "; give one line such as M62 P0";
  constexpr std::size_t longest = 80; // LinuxCNC reads 255 characters per line, older controls fewer
  const auto fault = [&](std::string_view what) { return std::string(what) + std::string(remedy); };
  if (code != plainText(code, ""))
    return fault("has a line break or a special character");
  if (code.find_first_not_of(' ') == std::string::npos)
    return fault("has only spaces");
  if (code.size() > longest)
    return fault("has more than " + std::to_string(longest) + " characters");
  for (const char* const mark : {"(", ")", ";", "%"})
    if (code.find(mark) != std::string::npos)
      return fault(std::string("has ") + mark + (*mark == '%' ? ", which ends the program" : ", which belongs to comments"));
  return {};
}

void
requireProgram(const std::string& file, const MachineProgram& program, const ProgramHeader& header)
{
  if (program.blocks.empty())
    throw FileError(file, "not written: the program has no blocks");
  if (header.decimals < 3 || header.decimals > 6)
    throw FileError(file, textOf("not written: ", header.decimals, " decimals were asked for; give 3 to 6"));
  for (const std::string& code : {header.pass_begin, header.pass_end})
    if (const std::string fault = code.empty() ? std::string() : faultOfCode(code); !fault.empty())
      throw FileError(file, "not written: the code '" + plainText(code, "") + "' of a pass " + fault);
}

void
requireRTCP(const std::string& file, const MachineProgram& program, const std::string& language)
{
  if (!program.machine.rtcp)
    throw FileError(file, "not written: " + language + " needs tips and tool axes, but the machine file has rtcp: false; " +
                              "use linuxcnc or fanuc, or rtcp: true");
}

std::string
commentText(const std::string& title)
{
  return plainText(title, "()[]{};\"%");
}

std::string
machineText(const MachineProgram& program)
{
  const Machine& machine = program.machine;
  return commentText((machine.name.empty() ? "machine" : machine.name) + ", " + kinematicsText(machine));
}

} // namespace pcl_spiral
