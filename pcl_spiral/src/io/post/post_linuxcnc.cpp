// SPDX-License-Identifier: BSD-3-Clause
#include "post.h"

namespace pcl_spiral {
namespace {

class LinuxCNCPost : public Post {
public:
  using Post::Post;

private:
  void writeOpening() override
  {
    writeComment(header_.title);
    writeComments();
    out_.line("G21 G90 G17 G40 G80 G94");
    leaveTipControl();
  }

  void writeRetract(double z) override
  {
    out_.code("G53 G0");
    out_.word("Z", z);
    out_.endLine();
  }

  void writeTool() override
  {
    Post::writeTool();
    out_.line("G43"); // the length of the loaded tool
  }

  void writeSmoothing(double tolerance) override
  {
    if (!(tolerance > 0.0))
      return out_.line("G61"); // P0 would round corners without limit
    out_.code("G64");
    out_.word("P", tolerance, 6);
    out_.endLine();
  }

  void writeTipControl(const ProgramBlock&) override
  {
    switchKinematics(program_.machine.words.tip_control_on);
    if (!isPerMinute())
      out_.line("G93");
  }

  void writeTipControlOff() override
  {
    if (!isPerMinute())
      out_.line("G94");
    leaveTipControl();
  }

  void writeBlock(const ProgramBlock& before, const ProgramBlock& block) override
  {
    out_.code(block.rapid ? "G0" : "G1");
    writePosition(block);
    if (hasAngles() && !isFixed())
      writeAngles(block);
    if (!block.rapid)
      writeFeed(before, block);
    out_.endLine();
  }

  void writeClosing() override { out_.line("M2"); }

  /** G53 is the machine's Z in the identity kinematics. The kinematics of the tip use the tool length: without it their joints would
   *  jump, so G49 stands behind the word that leaves them. */
  void leaveTipControl()
  {
    switchKinematics(program_.machine.words.tip_control_off);
    if (!takesTips() || !program_.machine.words.tip_control_off.empty())
      out_.line("G49");
  }

  void switchKinematics(const std::string& word)
  {
    if (takesTips() && !word.empty())
      out_.line(word);
  }
};

} // namespace

void
writeLinuxCNC(const std::string& file, const MachineProgram& program, const ProgramHeader& header)
{
  LinuxCNCPost(file, Dialect::LinuxCNC, program, header).write();
}

} // namespace pcl_spiral
