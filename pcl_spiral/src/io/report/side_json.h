// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The outer side of a surface in a report.
 */
#pragma once

#include <pcl_spiral/surface/impl/side_text.h>

#include <nlohmann/json.hpp>

namespace pcl_spiral {

/** What decided the side, the mean cosine and the share of the area that agrees. */
inline nlohmann::ordered_json
sideJson(const OuterSide& side)
{
  return {{"vote", nameOf(side.vote)}, {"mean_cosine", side.mean_cosine},     {"agreement", side.agreement},
          {"z_cosine", side.z_cosine}, {"convex_cosine", side.convex_cosine}, {"normals_ignored", side.normals_ignored},
          {"flipped", side.flipped}};
}

} // namespace pcl_spiral
