// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The moves of a program from the axes that its lines name.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/program_reader.h>
#include <pcl_spiral/machine/impl/kinematics.h>

#include <array>
#include <optional>

namespace pcl_spiral {

/** What one line asks for. Lengths in mm, angles in radians. */
struct ProgramTarget {
  std::array<std::optional<double>, 3> xyz;
  std::array<std::optional<double>, 2> angles; ///< in the order of Machine::rotary
  std::optional<Eigen::Vector3d> axis;         ///< of the tool, instead of the angles
  bool of_machine = false;                     ///< xyz is that of the gauge point in machine coordinates
  bool of_tip = false;                         ///< xyz is that of the tip; false: as programmed without RTCP
  bool rapid = false;
  bool link = false;           ///< between two passes, off the surface
  bool inverse_time = false;   ///< the feed is 1 / minutes; false: X Y Z a minute, or degrees a minute where they stand
  double feed = 0.0;           ///< as written
  double unit = 1.0;           ///< of X Y Z in the feed, mm
  bool counts_degrees = false; ///< where X Y Z move, a degree of a rotary axis counts as one unit of them
  bool names() const { return xyz[0] || xyz[1] || xyz[2] || angles[0] || angles[1] || axis; }
};

/** Follows the axes of the machine from line to line. Axes that a line does not name stay where they are. */
class ProgramTrack {
public:
  /** \p in_workpiece: machine coordinates are along the axes of the workpiece, as LinuxCNC's with RTCP. */
  ProgramTrack(const Machine& machine, bool in_workpiece);

  /** Makes the block of a line. Nothing yet while the place of an axis is not known. \return why it cannot be made; empty if it can */
  Diagnostic move(std::size_t line, const ProgramTarget& target);
  /** Whether the place of all axes is known. */
  bool begun() const { return !file_.program.blocks.empty(); }
  /** The moves so far, which are moved out. */
  ProgramFile take() { return std::move(file_); }

private:
  Diagnostic turnTo(const Eigen::Vector3d& axis);
  void goTo(const ProgramTarget& target);
  void placeMachine();
  /** The way that a feed a minute counts: of X Y Z, or, where they stand, of the rotary axes, degrees. doc/machining_time.md has the
   *  sources. */
  double fedWay(const ProgramBlock& block, const ProgramTarget& target) const;
  void add(std::size_t line, const ProgramTarget& target);

  Kinematics kinematics_;
  bool in_workpiece_;
  std::array<std::optional<double>, 3> tip_;     ///< in the workpiece
  std::array<std::optional<double>, 3> machine_; ///< as programmed without RTCP
  std::array<std::optional<double>, 2> angles_;
  ProgramFile file_;
};

} // namespace pcl_spiral
