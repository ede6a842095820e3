// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The order of a program, the same in every language.
 */
#pragma once

#include "post_text.h"

#include <pcl_spiral/io/program_writer.h>

#include <limits>
#include <string>
#include <string_view>

namespace pcl_spiral {

/** Writes one program. The order is that of this class; the words are those of a language, and those that G-codes share are here. */
class Post {
public:
  /** \throw FileError what writeProgram refuses */
  Post(const std::string& file, Dialect dialect, const MachineProgram& program, const ProgramHeader& header);
  Post(const Post&) = delete;
  Post& operator=(const Post&) = delete;
  virtual ~Post() = default;

  /** \throw FileError */
  void write();

protected:
  static constexpr double axis_tolerance = 10.0; ///< degrees for each mm of the smoothing tolerance: 0.05 for 0.005

  /** Name, comments, units and plane. */
  virtual void writeOpening() = 0;
  virtual void writeComment(const std::string& text) { out_.text("(" + commentText(text) + ")\n"); }
  /** To the machine's \p z, with everything off that moves Z elsewhere. */
  virtual void writeRetract(double z) = 0;
  virtual void writeTool();
  virtual void writeSpindle();
  virtual void writeOffset() { out_.line(offset()); }
  /** The call for a \p tolerance in mm; and its end. */
  virtual void writeSmoothing(double tolerance) = 0;
  virtual void writeSmoothingOff() {}
  virtual void writeFirstAngles();
  /** To X Y of \p start, without tip control. */
  virtual void writeOverFirst(const ProgramBlock& start);
  /** Switches tip control, or the tool length, on before \p first, and the meaning of F. */
  virtual void writeTipControl(const ProgramBlock& first) = 0;
  virtual void writeTipControlOff() = 0;
  virtual void writeBlock(const ProgramBlock& before, const ProgramBlock& block) = 0;
  virtual void writeClosing() = 0;
  /** Largest F in 1/min that the control reads with G93; shorter blocks run slower. */
  virtual double highestInverseFeed() const { return std::numeric_limits<double>::infinity(); }

  /** Comments of the title, the machine and the header's notes. */
  void writeComments();
  /** X Y Z for the control. */
  const Eigen::Vector3d& positionOf(const ProgramBlock& block) const { return program_.machine.takesTips() ? block.tip : block.machine; }
  void writePosition(const ProgramBlock& block);
  /** The words of the two rotary axes, in degrees, in the order of their letters. */
  void writeAngles(const ProgramBlock& block, bool signs = false);
  /** F of \p block, by the meaning of F. */
  void writeFeed(const ProgramBlock& before, const ProgramBlock& block);
  /** The feed a minute that gives \p block its time: mm/min of the written X Y Z, or, where they stand in the text and only the rotary
   *  axes turn, degrees/min (NIST RS274, 2.1.2.5; iTNC 530, 60642x-03, M116). A floor would stop such a turn. */
  double minuteFeed(const ProgramBlock& before, const ProgramBlock& block) const;
  /** The work offset, G54 if none is given. */
  virtual std::string offset() const { return header_.work_offset.empty() ? "G54" : header_.work_offset; }
  bool hasAngles() const { return !program_.machine.three_axes; }
  /** The rotary axes stand still while the tool cuts: they are written once. */
  bool isFixed() const { return fixed_; }
  /** F is in mm/min. */
  bool isPerMinute() const { return per_minute_; }
  bool takesTips() const { return program_.machine.takesTips(); }

  const MachineProgram& program_;
  const ProgramHeader& header_;
  PostText out_;

private:
  void writeStart();
  void writeBlocks();
  void writeEnd();
  void writeCoolant();
  void writeShopLines(const std::vector<std::string>& lines);
  std::string valueOf(std::string_view name) const;
  std::string withValues(const std::string& line) const;
  double tolerance() const { return program_.machine.path_tolerance.value_or(header_.smoothing); }

  const std::string file_;
  bool fixed_, per_minute_;
};

} // namespace pcl_spiral
