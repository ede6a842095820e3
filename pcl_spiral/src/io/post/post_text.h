// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Parts that the writers of control programs share.
 */
#pragma once

#include "io/byte_file.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/program_writer.h>

#include <array>
#include <string>
#include <string_view>

namespace pcl_spiral {

/** A program as text, built word by word; numbers do not depend on the locale. */
class PostText {
public:
  PostText(const std::string& file, int decimals) : file_(file), decimals_(decimals) {}

  /** A word: \p letters and the number, with the program's decimals, separated from the word before by a
   * space. */
  void word(std::string_view letters, double value);
  /** The same with \p decimals; always with a sign if \p signs. */
  void word(std::string_view letters, double value, int decimals, bool signs = false);
  /** A number without letters, with \p decimals. */
  void number(double value, int decimals, bool signs = false);
  /** Text, unchanged. */
  void text(std::string_view text) { bytes_ += text; }
  void endLine(std::string_view end = "\n");
  /** A whole line, unchanged. */
  void line(std::string_view words)
  {
    text(words);
    endLine();
  }
  /** \throw FileError */
  void close();

private:
  ByteFile file_;
  int decimals_;
  std::string bytes_;
  bool at_start_ = true;
};

/** \p title with special characters, and those that end a comment, turned to spaces. */
std::string commentText(const std::string& title);

/** Text that names the machine, its axes and its coordinates. */
std::string machineText(const MachineProgram& program);

/** The words of the two rotary axes, in degrees, in the order of their letters. */
void writeAngles(PostText& out, const MachineProgram& program, const ProgramBlock& block);

/** The tool call, with \p after on separate lines, and the spindle start; each if the header asks for
 * it. */
void writeTool(PostText& out, const ProgramHeader& header, std::string_view after = "");

/** Three words of a vector, such as I J K, with 8 decimals. */
void writeVector(PostText& out, const std::array<std::string_view, 3>& letters, const Eigen::Vector3d& v, bool signs = false);

/** \throw FileError for a program without blocks, a number of decimals out of range, or a code that is not a line */
void requireProgram(const std::string& file, const MachineProgram& program, const ProgramHeader& header);

/** \throw FileError if the machine has no RTCP, which \p language needs */
void requireRTCP(const std::string& file, const MachineProgram& program, const std::string& language);

/** X, Y, Z for the control. */
inline const Eigen::Vector3d&
positionOf(const MachineProgram& program, const ProgramBlock& block)
{
  return program.machine.rtcp ? block.tip : block.machine;
}

/** Writes all blocks of \p program with \p write, and the header's codes as a line of \p lines before and after each cut. */
template <typename Lines, typename Write>
void
writeBlocks(Lines& lines, const MachineProgram& program, const ProgramHeader& header, const Write& write)
{
  bool cutting = false;
  const auto turn = [&](bool cuts) {
    const std::string& code = cuts ? header.pass_begin : header.pass_end;
    if (cuts != cutting && !code.empty())
      lines.line(code);
    cutting = cuts;
  };
  for (const ProgramBlock& block : program.blocks) {
    turn(block.section == BlockSection::Cut);
    write(block);
  }
  turn(false);
}

} // namespace pcl_spiral
