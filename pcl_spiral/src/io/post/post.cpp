// SPDX-License-Identifier: BSD-3-Clause
#include "post.h"

#include "post_check.h"

#include "io/kinematics_text.h"
#include "io/link_marks.h"
#include "io/named_values.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr std::size_t highest_number = 99999; ///< of a line: five digits are read by every control

bool
standsStill(const MachineProgram& program)
{
  if (program.blocks.empty())
    return false;
  const RotaryAngles& first = program.blocks.front().angles;
  return std::all_of(program.blocks.begin(), program.blocks.end(), [&first](const ProgramBlock& block) {
    return block.angles.first == first.first && block.angles.second == first.second;
  });
}

bool
isOfStart(const ProgramBlock& block)
{
  return block.section == BlockSection::Start;
}

} // namespace

Post::Post(const std::string& file, Dialect dialect, const MachineProgram& program, const ProgramHeader& header)
: program_((requireProgram(file, dialect, program, header), program)), header_(header), out_(file, header.decimals), file_(file),
  fixed_(standsStill(program)), per_minute_(fixed_ || header.feed_mode == FeedMode::PerMinute)
{
  if (header.line_step > 0)
    out_.numberLines("N", static_cast<std::size_t>(header.line_step), static_cast<std::size_t>(header.line_step), highest_number);
}

void
Post::write()
{
  writeStart();
  writeBlocks();
  writeEnd();
  out_.close();
}

void
Post::writeStart()
{
  const Machine& machine = program_.machine;
  const bool above = isOfStart(program_.blocks.front());
  writeOpening();
  writeShopLines(machine.lines.header);
  if (machine.retract_z)
    writeRetract(*machine.retract_z);
  writeTool();
  writeSpindle();
  writeCoolant();
  writeOffset();
  if (machine.words.smoothing_on)
    writeShopLines(*machine.words.smoothing_on);
  else
    writeSmoothing(tolerance());
  if (hasAngles())
    writeFirstAngles();
  if (above)
    writeOverFirst(program_.blocks.front());
  writeTipControl(program_.blocks[above ? 1 : 0]);
}

void
Post::writeBlocks()
{
  bool cutting = false, linking = false;
  const auto turn = [&](bool cuts) {
    if (cuts == cutting)
      return;
    const std::string& code = cuts ? header_.pass_begin : header_.pass_end;
    if (!code.empty())
      out_.line(code);
    writeShopLines(cuts ? program_.machine.lines.pass_begin : program_.machine.lines.pass_end);
    cutting = cuts;
  };
  const ProgramBlock* before = &program_.blocks.front();
  for (const ProgramBlock& block : program_.blocks) {
    if (isOfStart(block) || block.section == BlockSection::End)
      continue;
    turn(block.section == BlockSection::Cut);
    if (const bool links = block.section == BlockSection::Link; links != linking) {
      writeComment(std::string(links ? link_begin : link_end));
      linking = links;
    }
    writeBlock(*before, block);
    before = &block;
  }
  turn(false);
}

void
Post::writeEnd()
{
  const Machine& machine = program_.machine;
  writeTipControlOff();
  if (machine.retract_z)
    writeRetract(*machine.retract_z);
  if (header_.spindle_speed > 0.0)
    out_.line("M5");
  if (header_.coolant != Coolant::None)
    out_.line(machine.words.coolant_off.empty() ? "M9" : machine.words.coolant_off);
  if (machine.words.smoothing_off)
    writeShopLines(*machine.words.smoothing_off);
  else if (!machine.words.smoothing_on && tolerance() > 0.0)
    writeSmoothingOff();
  writeShopLines(machine.lines.footer);
  writeClosing();
}

void
Post::writeTool()
{
  if (header_.tool > 0)
    out_.line("T" + std::to_string(header_.tool) + " M6");
}

void
Post::writeSpindle()
{
  if (!(header_.spindle_speed > 0.0))
    return;
  out_.word("S", header_.spindle_speed, 0);
  out_.endLine(header_.spindle_direction == SpindleDirection::Clockwise ? " M3\n" : " M4\n");
}

void
Post::writeCoolant()
{
  const ControlWords& words = program_.machine.words;
  const auto given = [](const std::string& word, const char* usual) { return word.empty() ? std::string(usual) : word; };
  switch (header_.coolant) {
  case Coolant::None:
    return;
  case Coolant::Mist:
    return out_.line(given(words.mist, "M7"));
  case Coolant::Flood:
    return out_.line(given(words.flood, "M8"));
  case Coolant::Through:
    return out_.line(words.through);
  }
}

void
Post::writeFirstAngles()
{
  out_.code("G0");
  writeAngles(program_.blocks.front());
  out_.endLine();
}

void
Post::writeOverFirst(const ProgramBlock& start)
{
  out_.code("G0");
  out_.word("X", start.machine.x());
  out_.word("Y", start.machine.y());
  out_.endLine();
}

void
Post::writeComments()
{
  const Machine& machine = program_.machine;
  writeComment((machine.name.empty() ? "machine" : machine.name) + ", " + kinematicsText(machine));
  const Eigen::Vector3d& zero = machine.work_zero;
  writeComment(Diagnostic("checked for work zero ", zero.x(), " ", zero.y(), " ", zero.z(), " and tool length ", machine.tool_length,
                          " of the machine file")
                   .text());
  writeComment(offset_opening + offset());
  if (!machine.retract_z)
    writeComment("no retract_z in the machine file: start above the part");
  for (const std::string& note : header_.notes)
    writeComment(note);
}

void
Post::writePosition(const ProgramBlock& block)
{
  const Eigen::Vector3d& position = positionOf(block);
  out_.word("X", position.x());
  out_.word("Y", position.y());
  out_.word("Z", position.z());
}

void
Post::writeAngles(const ProgramBlock& block, bool signs)
{
  const auto& rotary = program_.machine.rotary;
  const bool swap = rotary[0].letter > rotary[1].letter; // A before C
  const double values[2] = {block.angles.first * in_degrees, block.angles.second * in_degrees};
  for (int i : {swap ? 1 : 0, swap ? 0 : 1})
    out_.word(std::string_view(&rotary[i].letter, 1), values[i], header_.decimals, signs);
}

double
Post::minuteFeed(const ProgramBlock& before, const ProgramBlock& block) const
{
  constexpr double least = 0.001; // the last decimal of F
  const double unit = std::pow(10.0, header_.decimals);
  const double way = ((positionOf(block) * unit).array().round() - (positionOf(before) * unit).array().round()).matrix().norm() / unit;
  const double turn = std::hypot(block.angles.first - before.angles.first, block.angles.second - before.angles.second);
  return std::max(least, (way > 0.0 ? way : turn * in_degrees) / block.minutes);
}

void
Post::writeFeed(const ProgramBlock& before, const ProgramBlock& block)
{
  if (per_minute_)
    out_.word("F", minuteFeed(before, block), 3);
  else
    out_.word("F", std::min(highestInverseFeed(), 1.0 / block.minutes));
}

void
Post::writeShopLines(const std::vector<std::string>& lines)
{
  for (const std::string& line : lines)
    out_.line(withValues(line));
}

std::string
Post::withValues(const std::string& line) const
{
  std::string all;
  takePieces(line, [&](std::string_view piece, bool is_name) { all += is_name ? valueOf(piece) : std::string(piece); });
  return all;
}

std::string
Post::valueOf(std::string_view name) const
{
  if (name == "spindle")
    return std::to_string(std::lround(header_.spindle_speed));
  if (name == "tool")
    return std::to_string(header_.tool);
  if (name == "part")
    return commentText(header_.title);
  if (name == "feed")
    return Diagnostic(program_.feed).text();
  if (name == "tolerance")
    return Diagnostic(tolerance()).text();
  if (name == "offset")
    return offset();
  if (!program_.machine.retract_z)
    throw FileError(file_, "not written: a line of the machine file holds {{safe_z}}, and the machine file has no retract_z; give it");
  return Diagnostic(*program_.machine.retract_z).text();
}

} // namespace pcl_spiral
