// SPDX-License-Identifier: BSD-3-Clause
#include "scene_check.h"

#include <stdexcept>

namespace pcl_spiral {
namespace {

void
check(const std::vector<float>& values, std::size_t points, const char* what)
{
  if (!values.empty() && values.size() != points)
    throw std::invalid_argument(std::to_string(values.size()) + " " + what + " for " + std::to_string(points) +
                                " points; give one value per point");
}

} // namespace

VerificationScene
checkedScene(VerificationScene scene, bool with_path)
{
  if (!scene.part.cloud || !scene.part.path || (with_path && scene.part.path->empty()))
    throw std::invalid_argument("pictures of a verification need the reference and the path");
  check(scene.deviation, scene.part.path->size(), "deviations");
  check(scene.stock, scene.part.cloud->size(), "heights of stock");
  check(scene.ridges, scene.part.cloud->size(), "heights of ridges");
  return scene;
}

} // namespace pcl_spiral
