// SPDX-License-Identifier: BSD-3-Clause
#include "post.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

class FanucPost : public Post {
public:
  FanucPost(const std::string& file, const MachineProgram& program, const ProgramHeader& header, bool vectors)
  : Post(file, vectors ? Dialect::FanucVectors : Dialect::Fanuc, program, header), vectors_(vectors)
  {}

private:
  void writeOpening() override
  {
    out_.text("%\nO0001 (" + commentText(header_.title) + ")\n");
    writeComments();
    out_.line("G21 G90 G94 G17 G40 G49 G80");
  }

  void writeRetract(double z) override
  {
    out_.code("G0 G53");
    out_.word("Z", z);
    out_.endLine();
  }

  void writeSmoothing(double tolerance) override
  {
    if (tolerance > 0.0)
      out_.line("G5.1 Q1");
  }

  void writeSmoothingOff() override { out_.line("G5.1 Q0"); }

  void writeTipControl(const ProgramBlock& first) override
  {
    const std::string length = " H" + std::to_string(std::max(1, header_.tool));
    out_.code((!takesTips() ? "G43" : vectors_ ? "G43.5" : "G43.4") + length);
    writePlace(first);
    out_.endLine();
    if (!isPerMinute())
      out_.line("G93");
  }

  void writeTipControlOff() override
  {
    if (!isPerMinute())
      out_.line("G94");
    out_.line("G49");
  }

  void writeBlock(const ProgramBlock& before, const ProgramBlock& block) override
  {
    out_.code(block.rapid ? "G0" : "G1");
    writePlace(block);
    if (!block.rapid)
      writeFeed(before, block);
    out_.endLine();
  }

  double highestInverseFeed() const override { return 9999.999; }

  void writeClosing() override
  {
    out_.line("M30");
    out_.text("%\n");
  }

  /** X Y Z and the tool direction, always all of them; without the direction where it never changes. */
  void writePlace(const ProgramBlock& block)
  {
    writePosition(block);
    if (vectors_)
      writeVector(out_, {"I", "J", "K"}, block.axis);
    else if (hasAngles() && !isFixed())
      writeAngles(block);
  }

  bool vectors_;
};

} // namespace

void
writeFanuc(const std::string& file, const MachineProgram& program, const ProgramHeader& header)
{
  FanucPost(file, program, header, false).write();
}

void
writeFanucVectors(const std::string& file, const MachineProgram& program, const ProgramHeader& header)
{
  FanucPost(file, program, header, true).write();
}

} // namespace pcl_spiral
