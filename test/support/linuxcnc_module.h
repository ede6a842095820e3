// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  LinuxCNC's own modules of kinematics for trunnion tables, loaded with a replacement for their HAL. Programs that use it
 *  export their symbols (ENABLE_EXPORTS), because the modules call them.
 */
#pragma once

#include <Eigen/Core>

#include <array>
#include <string>

namespace pcl_spiral::test {

/** One module. Joints are X, Y, Z in mm, the tilt and C in degrees. */
class LinuxCNCModule {
public:
  explicit LinuxCNCModule(const std::string& name);
  ~LinuxCNCModule();
  LinuxCNCModule(const LinuxCNCModule&) = delete;
  LinuxCNCModule& operator=(const LinuxCNCModule&) = delete;

  bool isThere() const { return handle_ != nullptr; }
  /** The point of C, the offset of the tilt from it, and the tool; a pin that is missing, or nothing. */
  std::string set(const Eigen::Vector3d& point, const Eigen::Vector3d& offset, double tool_length) const;
  /** X Y Z of the control for these joints. */
  Eigen::Vector3d forward(const std::array<double, 5>& joints) const;
  /** Joints for X Y Z of the control and the angles of the tilt, named \p letter, and of C. */
  std::array<double, 5> inverse(const Eigen::Vector3d& xyz, char letter, double tilt, double c) const;

private:
  void* handle_;
};

} // namespace pcl_spiral::test
