// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a user does after a refusal: what its message names.
 */
#pragma once

#include "scene.h"

#include "support/scratch_folder.h"

#include <string>
#include <vector>

namespace pcl_spiral::awkward {

/** One remedy of a message. */
struct Remedy {
  std::string name;                   ///< as the message has it, such as "--keep-out"
  std::vector<std::string> arguments; ///< to add to those that were refused
  double radius = 0.0;                ///< of another ball, mm; 0: the same one
  double scallop = 0.0;               ///< another height, mm; 0: the same one
};

/** The remedies that \p said names to a run with \p arguments, one after the other, as a user who knows the part takes them. Polygons are
 *  drawn by the extents in the message and written to \p folder, with names that begin with \p prefix. */
std::vector<Remedy> remediesOf(const Scene& scene, const std::vector<std::string>& arguments, const std::string& said,
                               const std::string& prefix, const ScratchFolder& folder);

} // namespace pcl_spiral::awkward
