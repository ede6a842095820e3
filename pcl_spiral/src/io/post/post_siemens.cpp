// SPDX-License-Identifier: BSD-3-Clause
#include "post.h"

namespace pcl_spiral {
namespace {

class SiemensPost : public Post {
public:
  using Post::Post;

private:
  void writeOpening() override
  {
    writeComment(header_.title);
    writeComments();
    out_.line("G71 G90 G94 G17 G40");
    if (takesTips())
      out_.line("TRAFOOF"); // of a program that was broken off
  }

  void writeComment(const std::string& text) override { out_.text("; " + commentText(text) + "\n"); }

  void writeRetract(double z) override
  {
    out_.code("SUPA G0");
    out_.word("Z", z);
    out_.endLine(" D0\n");
  }

  void writeOffset() override { out_.line(offset() + " D1"); }

  void writeSmoothing(double tolerance) override
  {
    if (!(tolerance > 0.0))
      return out_.line("G60"); // exact stop
    out_.code("CYCLE832(");
    out_.number(tolerance, 6);
    out_.text(",_ORI_FINISH,");
    out_.number(axis_tolerance * tolerance, 6);
    out_.endLine(")\n");
  }

  void writeSmoothingOff() override { out_.line("CYCLE832(0,_OFF,1)"); }

  void writeTipControl(const ProgramBlock&) override
  {
    if (takesTips()) {
      out_.line("TRAORI");
      out_.line(offset()); // TRAORI may take the offset away
      out_.line("ORIWKS");
      out_.line("ORIVECT");
    }
    if (!isPerMinute())
      out_.line("G93");
  }

  void writeTipControlOff() override
  {
    if (!isPerMinute())
      out_.line("G94");
    if (takesTips())
      out_.line("TRAFOOF");
  }

  void writeBlock(const ProgramBlock& before, const ProgramBlock& block) override
  {
    out_.code(block.rapid ? "G0" : "G1");
    writePosition(block);
    if (block.section == BlockSection::Unwind)
      writeAngles(block); // a vector is the same after a whole turn
    else if (takesTips())
      writeVector(out_, {"A3=", "B3=", "C3="}, block.axis);
    if (!block.rapid)
      writeFeed(before, block);
    out_.endLine();
  }

  void writeClosing() override
  {
    if (!program_.machine.retract_z)
      out_.line("D0"); // the tool length ends here; a retract has it in its block
    out_.line("M30");
  }
};

} // namespace

void
writeSiemens(const std::string& file, const MachineProgram& program, const ProgramHeader& header)
{
  SiemensPost(file, Dialect::Siemens, program, header).write();
}

} // namespace pcl_spiral
