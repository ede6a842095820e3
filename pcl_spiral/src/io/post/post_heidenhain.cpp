// SPDX-License-Identifier: BSD-3-Clause
#include "post.h"

#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>

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

class HeidenhainPost : public Post {
public:
  HeidenhainPost(const std::string& file, const MachineProgram& program, const ProgramHeader& header)
  : Post(file, Dialect::Heidenhain, program, header), name_(programName(header.title))
  {
    out_.numberLines("", 0, 1, std::numeric_limits<std::size_t>::max() - 1);
  }

private:
  void writeOpening() override
  {
    out_.line("BEGIN PGM " + name_ + " MM");
    writeComment(header_.title);
    writeComments();
    if (takesTips())
      out_.line("M129"); // of a program that was broken off
  }

  void writeComment(const std::string& text) override { out_.line("; " + commentText(text)); }

  void writeRetract(double z) override
  {
    out_.code("L");
    out_.word("Z", z, 3, true);
    out_.endLine(" R0 FMAX M91\n");
  }

  void writeTool() override
  {
    if (header_.tool == 0 && !(header_.spindle_speed > 0.0))
      return;
    out_.line("TOOL CALL " + (header_.tool > 0 ? std::to_string(header_.tool) + " " : std::string()) + "Z S" +
              std::to_string(std::lround(header_.spindle_speed)));
  }

  void writeSpindle() override
  {
    if (header_.spindle_speed > 0.0)
      out_.line(header_.spindle_direction == SpindleDirection::Clockwise ? "M3" : "M4");
  }

  std::string offset() const override { return header_.work_offset.empty() ? "of the preset in use" : "preset " + header_.work_offset; }

  void writeOffset() override
  {
    if (!header_.work_offset.empty())
      out_.line("CYCL DEF 247 DATUM SETTING Q339=+" + header_.work_offset);
  }

  void writeSmoothing(double tolerance) override
  {
    if (!(tolerance > 0.0))
      return;
    out_.line("CYCL DEF 32.0 TOLERANCE");
    out_.code("CYCL DEF 32.1 T");
    out_.number(tolerance, 6);
    out_.endLine();
    out_.code("CYCL DEF 32.2 HSC-MODE:0 TA");
    out_.number(axis_tolerance * tolerance, 6);
    out_.endLine();
  }

  void writeSmoothingOff() override
  {
    out_.line("CYCL DEF 32.0 TOLERANCE");
    out_.line("CYCL DEF 32.1");
  }

  void writeFirstAngles() override
  {
    out_.code("L");
    writeAngles(program_.blocks.front(), true);
    out_.endLine(" R0 FMAX\n");
  }

  void writeOverFirst(const ProgramBlock& start) override
  {
    out_.code("L");
    out_.word("X", start.machine.x(), header_.decimals, true);
    out_.word("Y", start.machine.y(), header_.decimals, true);
    out_.endLine(" R0 FMAX\n");
  }

  void writeTipControl(const ProgramBlock&) override
  {
    if (takesTips())
      out_.line("M128");
  }

  void writeTipControlOff() override
  {
    if (takesTips())
      out_.line("M129");
  }

  void writeBlock(const ProgramBlock& before, const ProgramBlock& block) override
  {
    const bool by_angles = block.section == BlockSection::Unwind; // a vector is the same after a whole turn
    const Eigen::Vector3d& position = positionOf(block);
    out_.code(takesTips() && !by_angles ? "LN" : "L");
    out_.word("X", position.x(), header_.decimals, true);
    out_.word("Y", position.y(), header_.decimals, true);
    out_.word("Z", position.z(), header_.decimals, true);
    if (by_angles)
      writeAngles(block, true);
    else if (takesTips()) {
      writeVector(out_, {"NX", "NY", "NZ"}, block.normal, true);
      writeVector(out_, {"TX", "TY", "TZ"}, block.axis, true);
    }
    if (!block.rapid)
      out_.word("F", minuteFeed(before, block), 3);
    out_.endLine(block.rapid ? " FMAX\n" : "\n");
  }

  void writeClosing() override
  {
    out_.line("M30");
    out_.line("END PGM " + name_ + " MM");
  }

  std::string name_;
};

} // namespace

void
writeHeidenhain(const std::string& file, const MachineProgram& program, const ProgramHeader& header)
{
  HeidenhainPost(file, program, header).write();
}

} // namespace pcl_spiral
