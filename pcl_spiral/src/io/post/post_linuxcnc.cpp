// SPDX-License-Identifier: BSD-3-Clause
#include "post_text.h"

namespace pcl_spiral {
namespace {

void
writeRetract(PostText& out, const Machine& machine)
{
  if (!machine.retract_z)
    return;
  out.word("G53 G0 Z", *machine.retract_z);
  out.endLine();
}

void
writeStart(PostText& out, const MachineProgram& program, const ProgramHeader& header)
{
  out.text("(" + commentText(header.title) + ")\n(" + machineText(program) + ")\n");
  out.text("G21 G90 G17 G40 G49 G80 G94\n");
  if (program.machine.path_tolerance > 0.0) {
    out.word("G64 P", program.machine.path_tolerance, 6);
    out.endLine();
  }
  else
    out.text("G61\n"); // P0 would round corners without limit
  if (header.tool == 0)
    out.text("G43\n"); // the length of the loaded tool
  writeTool(out, header, "G43\n");
  writeRetract(out, program.machine);
  out.text("G0 ");
  writeAngles(out, program, program.blocks.front());
  out.endLine();
  out.text("G93\n");
}

} // namespace

void
writeLinuxCNC(const std::string& file, const MachineProgram& program, const ProgramHeader& header)
{
  requireProgram(file, program, header);
  PostText out(file, header.decimals);
  writeStart(out, program, header);
  writeBlocks(out, program, header, [&](const ProgramBlock& block) {
    const Eigen::Vector3d& position = positionOf(program, block);
    out.word(block.rapid ? "G0 X" : "G1 X", position.x());
    out.word("Y", position.y());
    out.word("Z", position.z());
    writeAngles(out, program, block);
    if (!block.rapid)
      out.word("F", 1.0 / block.minutes);
    out.endLine();
  });
  out.text("G94\n");
  writeRetract(out, program.machine);
  if (header.spindle_speed > 0.0)
    out.text("M5\n");
  out.text("M2\n");
  out.close();
}

} // namespace pcl_spiral
