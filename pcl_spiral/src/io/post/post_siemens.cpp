// SPDX-License-Identifier: BSD-3-Clause
#include "post_text.h"

namespace pcl_spiral {
namespace {

void
writeRetract(PostText& out, const Machine& machine)
{
  if (!machine.retract_z)
    return;
  out.word("SUPA G0 Z", *machine.retract_z);
  out.endLine(" D0\n");
}

void
writeStart(PostText& out, const MachineProgram& program, const ProgramHeader& header)
{
  out.text("; " + commentText(header.title) + "\n; " + machineText(program) + "\n");
  out.text("G71 G90 G94 G17 G40\n");
  writeTool(out, header);
  writeRetract(out, program.machine);
  out.text("D1\nTRAORI\nORIWKS\nORIVECT\nG93\n");
}

} // namespace

void
writeSiemens(const std::string& file, const MachineProgram& program, const ProgramHeader& header)
{
  requireProgram(file, program, header);
  requireRTCP(file, program, "siemens");
  PostText out(file, header.decimals);
  writeStart(out, program, header);
  writeBlocks(out, program, header, [&](const ProgramBlock& block) {
    out.word(block.rapid ? "G0 X" : "G1 X", block.tip.x());
    out.word("Y", block.tip.y());
    out.word("Z", block.tip.z());
    writeVector(out, {"A3=", "B3=", "C3="}, block.axis);
    if (!block.rapid)
      out.word("F", 1.0 / block.minutes);
    out.endLine();
  });
  out.text("G94\nTRAFOOF\n");
  writeRetract(out, program.machine);
  if (header.spindle_speed > 0.0)
    out.text("M5\n");
  out.text("M30\n");
  out.close();
}

} // namespace pcl_spiral
