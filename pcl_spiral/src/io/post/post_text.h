// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the writers of control programs share.
 */
#pragma once

#include "io/byte_file.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/program_writer.h>

#include <array>
#include <string>
#include <string_view>

namespace pcl_spiral {

/** A program as text, built up word by word; numbers do not depend on the locale. */
class PostText {
public:
  PostText(const std::string& file, int decimals) : file_(file), decimals_(decimals) {}

  /** A word: \p letters and the number after them, to the program's decimals, parted from the last by a
   * space. */
  void word(std::string_view letters, double value);
  /** The same to \p decimals, with a sign always where \p signs. */
  void word(std::string_view letters, double value, int decimals, bool signs = false);
  /** A number alone, to \p decimals. */
  void number(double value, int decimals, bool signs = false);
  /** Text as it is. */
  void text(std::string_view text) { bytes_ += text; }
  void endLine(std::string_view end = "\n");
  /** A whole line as it is. */
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

/** \p title with what could end a comment or is no plain character turned to spaces. */
std::string commentText(const std::string& title);

/** A line or two that name the machine and how it is driven. */
std::string machineText(const MachineProgram& program);

/** The words of the two rotary axes, in degrees and by their letters' order. */
void writeAngles(PostText& out, const MachineProgram& program, const ProgramBlock& block);

/** The tool's call with \p after on lines of its own, and the spindle's start; each where the header asks for
 * it. */
void writeTool(PostText& out, const ProgramHeader& header, std::string_view after = "");

/** Three words of a vector, such as I J K, in 8 decimals. */
void writeVector(PostText& out, const std::array<std::string_view, 3>& letters, const Eigen::Vector3d& v, bool signs = false);

/** \throw FileError for a program without blocks, a count of decimals out of range, or a code that is no line */
void requireProgram(const std::string& file, const MachineProgram& program, const ProgramHeader& header);

/** \throw FileError where the machine has no RTCP, which \p language needs */
void requireRTCP(const std::string& file, const MachineProgram& program, const std::string& language);

/** X, Y, Z as the control takes them. */
inline const Eigen::Vector3d&
positionOf(const MachineProgram& program, const ProgramBlock& block)
{
  return program.machine.rtcp ? block.tip : block.machine;
}

/** All blocks of \p program by \p write, and the header's codes as a line of \p lines before and after each run of cutting. */
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
