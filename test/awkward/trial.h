// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Runs the program on an awkward scan as a user would, follows the remedies of its refusals, and judges every path.
 */
#pragma once

#include "scene.h"

#include "support/scratch_folder.h"

#include <cstddef>

namespace pcl_spiral::awkward {

/** How the runs of a kind of scenes ended. */
struct Counts {
  std::size_t paths = 0;     ///< right
  std::size_t refusals = 0;  ///< with a reason, and a remedy that leads to a right path
  std::size_t dead_ends = 0; ///< remedies of these that end in another refusal; another remedy leads to a path
  std::size_t wrong = 0;
};

/** Writes the scan and the polygon of the scene. */
void writeScan(const Scene& scene, const ScratchFolder& folder);

/** Runs one step, prints a line about it, with the messages if it is wrong, and counts it. */
void tryStep(const Scene& scene, const Step& step, const ScratchFolder& folder, Counts& counts);

} // namespace pcl_spiral::awkward
