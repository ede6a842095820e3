// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  An awkward scan of a part that is known exactly, and what a user wants of it.
 */
#pragma once

#include "support/sampling.h"
#include "support/surfaces.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl_spiral::awkward {

/** How a run may end. A path that is written must be right in every case. */
enum class Outcome {
  Path,         ///< a path
  Refusal,      ///< no path, and a reason
  PathOrRefusal ///< either
};

/** One run of the program on the scan. */
struct Step {
  std::vector<std::string> arguments; ///< beside the scan, the cutter and the outputs
  Outcome outcome = Outcome::Path;
  std::vector<std::string> words; ///< that the user must be told, each with its choices: "sheet|part"
};

/** Lengths in mm, in the frame of the part unless the file is named. */
struct Scene {
  std::string name;        ///< kind and what was drawn
  test::SurfacePtr part;   ///< exact
  test::Sampled scan;      ///< all that the scanner saw; normals are those of the part, for files that hold them
  Polyline bodies;         ///< samples of all that stands beside or on the part, seen or not: the ball must not enter it
  double body_spacing = 0; ///< of these samples
  /** Whether a place of the part may be left uncut. */
  std::function<bool(const Eigen::Vector3d&)> exempt = [](const Eigen::Vector3d&) { return false; };
  /** Whether a place of the part may be left uncut if the user keeps out of what stands there. */
  std::function<bool(const Eigen::Vector3d&)> exempt_kept_out = [](const Eigen::Vector3d&) { return false; };
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity(); ///< from the part to the file
  double unit = 1.0;                                        ///< of the file
  std::string file = "scan.xyz";                            ///< .xyz, .ply with normals, or .pcd with a VIEWPOINT
  Eigen::Vector3d view_point = Eigen::Vector3d::Zero();     ///< for a .pcd, of the file
  test::PlaneLoop keep_out;                                 ///< written to keep.txt, if there is one
  double size = 1.0;                                        ///< of the part as drawn: 0.6 for a smaller one
  double radius = 4.0, scallop = 0.1, noise = 0.0, spacing = 0.8;
  std::vector<Step> steps;

  /** \p x of the part in the file's unit, as a value of an option. */
  std::string place(const Eigen::Vector3d& x) const;
};

/** Names of the kinds of scenes. */
std::vector<std::string> kinds();

/** Scene \p index of the series \p seed of a kind, its part smaller by \p size; the same on every platform. */
Scene makeScene(const std::string& kind, std::uint64_t seed, std::uint64_t index, double size);

} // namespace pcl_spiral::awkward
