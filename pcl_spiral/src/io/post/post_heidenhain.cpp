// SPDX-License-Identifier: BSD-3-Clause
#include "post_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace pcl_spiral {
namespace {

/** Program name from the file name: letters, digits, _ and -. */
std::string
programName(const std::string& title)
{
  std::string name = std::filesystem::path(title).stem().string();
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-')
      c = '_';
  return name.empty() ? "SPIRAL" : name;
}

/** Numbered lines. */
class NumberedLines {
public:
  explicit NumberedLines(PostText& out) : out_(out) {}
  PostText& begin()
  {
    out_.text(std::to_string(next_++) + " ");
    return out_;
  }
  void line(const std::string& text) { begin().text(text + "\n"); }

private:
  PostText& out_;
  std::size_t next_ = 0;
};

void
writeRetract(NumberedLines& lines, const Machine& machine)
{
  if (!machine.retract_z)
    return;
  PostText& out = lines.begin();
  out.text("L ");
  out.word("Z", *machine.retract_z, 3, true);
  out.endLine(" R0 FMAX M91\n");
}

/** The F that gives the block its time: mm/min of the tip, or, where the tip stands in the text and only the rotary axes turn,
 *  degrees/min (iTNC 530, 60642x-03, M116: the feed of rotary axes). A floor would stop such a turn, which has no way of the tip.
 *  FT, the time of a block, is not on every control of this language. */
double
feedOf(const ProgramBlock& before, const ProgramBlock& block, int decimals)
{
  constexpr double least = 0.001; // the last decimal of F
  const double unit = std::pow(10.0, decimals);
  const double way = ((block.tip * unit).array().round() - (before.tip * unit).array().round()).matrix().norm() / unit;
  const double turn = std::hypot(block.angles.first - before.angles.first, block.angles.second - before.angles.second);
  return std::max(least, (way > 0.0 ? way : turn * in_degrees) / block.minutes);
}

} // namespace

void
writeHeidenhain(const std::string& file, const MachineProgram& program, const ProgramHeader& header)
{
  requireProgram(file, program, header);
  requireRTCP(file, program, "heidenhain");
  PostText out(file, header.decimals);
  NumberedLines lines(out);
  const std::string name = programName(header.title);
  lines.line("BEGIN PGM " + name + " MM");
  lines.line("; " + commentText(header.title));
  lines.line("; " + machineText(program));
  if (header.tool > 0)
    lines.line("TOOL CALL " + std::to_string(header.tool) + " Z S" + std::to_string(std::lround(header.spindle_speed)));
  if (header.spindle_speed > 0.0)
    lines.line("M3");
  writeRetract(lines, program.machine);
  lines.line("M128");
  const ProgramBlock* before = &program.blocks.front();
  writeBlocks(lines, program, header, [&](const ProgramBlock& block) {
    lines.begin().text("LN ");
    out.word("X", block.tip.x(), header.decimals, true);
    out.word("Y", block.tip.y(), header.decimals, true);
    out.word("Z", block.tip.z(), header.decimals, true);
    writeVector(out, {"NX", "NY", "NZ"}, block.normal, true);
    writeVector(out, {"TX", "TY", "TZ"}, block.axis, true);
    if (!block.rapid)
      out.word("F", feedOf(*before, block, header.decimals), 3);
    out.endLine(block.rapid ? " FMAX\n" : "\n");
    before = &block;
  });
  lines.line("M129");
  writeRetract(lines, program.machine);
  if (header.spindle_speed > 0.0)
    lines.line("M5");
  lines.line("M30");
  lines.line("END PGM " + name + " MM");
  out.close();
}

} // namespace pcl_spiral
