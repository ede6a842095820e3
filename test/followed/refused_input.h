// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Scans and commands of which many are refused, drawn at random.
 */
#pragma once

#include "awkward/scene.h"

#include <Eigen/Core>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace pcl_spiral::followed {

/** A scan, and the command that a user gives for it. Lengths in mm, in the frame of the file. */
struct RefusedInput {
  std::string name;                         ///< kind, seed and index
  std::vector<Eigen::Vector3d> points;      ///< of the scan
  double noise = 0.0, spacing = 1.0;        ///< of the scan
  Eigen::Vector3d sensor{0, 0, 0};          ///< zero: not known, the file is a list of points
  std::vector<std::string> arguments;       ///< beside scan, tool, scallop and output
  std::map<std::string, std::string> files; ///< that the arguments name, with their text
  double radius = 4.0, scallop = 0.1;       ///< of the ball, and of what it may leave

  std::string scanName() const { return sensor.isZero(0.0) ? "scan.xyz" : "scan.pcd"; } ///< Of the file.
};

/** Names of the kinds. */
std::vector<std::string> kinds();

/** Input \p index of the series \p seed of a kind; the same on every platform. It may be one over which a path is found. */
RefusedInput makeInput(const std::string& kind, std::uint64_t seed, std::uint64_t index);

} // namespace pcl_spiral::followed
