// SPDX-License-Identifier: BSD-3-Clause
#include "post_text.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

void
writeRetract(PostText& out, const Machine& machine)
{
  if (!machine.retract_z)
    return;
  out.word("G0 G53 Z", *machine.retract_z);
  out.endLine();
}

/** X Y Z and the tool direction, always all of them. */
void
writePlace(PostText& out, const MachineProgram& program, const ProgramBlock& block, bool vectors)
{
  const Eigen::Vector3d& position = positionOf(program, block);
  out.word("X", position.x());
  out.word("Y", position.y());
  out.word("Z", position.z());
  if (vectors)
    writeVector(out, {"I", "J", "K"}, block.axis);
  else
    writeAngles(out, program, block);
}

void
writeStart(PostText& out, const MachineProgram& program, const ProgramHeader& header, bool vectors)
{
  out.text("%\nO0001 (" + commentText(header.title) + ")\n(" + machineText(program) + ")\n");
  out.text("G21 G90 G94 G17 G40 G49 G80\n");
  writeTool(out, header);
  writeRetract(out, program.machine);
  out.text("G0 ");
  writeAngles(out, program, program.blocks.front()); // before the control keeps the tip in place
  out.endLine();
  out.text((!program.machine.rtcp ? "G43 H" : vectors ? "G43.5 H" : "G43.4 H") + std::to_string(std::max(1, header.tool)) + " ");
  writePlace(out, program, program.blocks.front(), vectors);
  out.endLine();
  out.text("G93\n");
}

void
writeFile(const std::string& file, const MachineProgram& program, const ProgramHeader& header, bool vectors)
{
  PostText out(file, header.decimals);
  writeStart(out, program, header, vectors);
  writeBlocks(out, program, header, [&](const ProgramBlock& block) {
    out.text(block.rapid ? "G0 " : "G1 ");
    writePlace(out, program, block, vectors);
    if (!block.rapid)
      out.word("F", 1.0 / block.minutes);
    out.endLine();
  });
  out.text("G94\nG49\n");
  writeRetract(out, program.machine);
  if (header.spindle_speed > 0.0)
    out.text("M5\n");
  out.text("M30\n%\n");
  out.close();
}

} // namespace

void
writeFanuc(const std::string& file, const MachineProgram& program, const ProgramHeader& header)
{
  requireProgram(file, program, header);
  writeFile(file, program, header, false);
}

void
writeFanucVectors(const std::string& file, const MachineProgram& program, const ProgramHeader& header)
{
  requireProgram(file, program, header);
  requireRTCP(file, program, "fanuc's G43.5");
  writeFile(file, program, header, true);
}

} // namespace pcl_spiral
