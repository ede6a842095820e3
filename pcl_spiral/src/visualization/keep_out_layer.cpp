// SPDX-License-Identifier: BSD-3-Clause
#include "keep_out_layer.h"

#include "actors.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr Color keep_out_color{0.85, 0.33, 0.0};
constexpr double sides = 60.0; // steps across a keep-out
constexpr float line_width = 3.0f;

/** \p place, which is square to the axis of \p keep_out, moved along it to the height of the path nearest to it. */
Eigen::Vector3d
atThePath(const Eigen::Vector3d& place, const Prism& keep_out, const pcl::PointCloud<ToolpathPoint>& path)
{
  const Eigen::Vector3f axis = keep_out.axis().cast<float>(), from = place.cast<float>();
  const auto aside = [&](const ToolpathPoint& p) { return (p.getVector3fMap() - from).cross(axis).squaredNorm(); };
  const auto nearest =
      std::min_element(path.begin(), path.end(), [&](const ToolpathPoint& a, const ToolpathPoint& b) { return aside(a) < aside(b); });
  return place + static_cast<double>(nearest->getVector3fMap().dot(axis)) * keep_out.axis();
}

} // namespace

void
addKeepOuts(PartView& view, const PictureScene& scene, std::vector<LegendEntry>& legend)
{
  if (scene.keep_outs.empty() || scene.path->empty())
    return;
  std::vector<Polyline> lines;
  for (const Prism& keep_out : scene.keep_outs) {
    Polyline line = keep_out.outline(keep_out.width() / sides);
    for (Eigen::Vector3d& place : line)
      place = atThePath(place, keep_out, *scene.path);
    lines.push_back(line);
  }
  view.addInFront(lineActor(lines, true, keep_out_color, line_width));
  legend.push_back({lines.size() == 1 ? "keep-out" : "keep-outs", keep_out_color});
}

} // namespace pcl_spiral
