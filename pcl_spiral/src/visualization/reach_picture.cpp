// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/visualization/reach_picture.h>

#include "actors.h"
#include "canvas.h"
#include "verification_map.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pcl_spiral {
namespace {

constexpr double least_disc = 1.0, most_disc = 6.0; ///< pixels

ValueStyle
reachStyle(vtkScalarsToColors* colors)
{
  return {[](float radius) { return 1.0f / radius; }, // the tightest in front
          [colors](float radius) {
            Color color;
            colors->GetColor(radius, color.data());
            return color;
          },
          [](float) { return false; }};
}

/** Share of \p radii below \p radius, in words. */
std::string
shareBelow(const std::vector<float>& radii, double radius)
{
  const auto below = std::count_if(radii.begin(), radii.end(), [radius](float r) { return r < static_cast<float>(radius); });
  return below == 0 ? std::string("none")
                    : formatted("%.2g %% of the points", 100.0 * static_cast<double>(below) / static_cast<double>(radii.size()));
}

/** Normal of the path at the contact nearest to \p place. */
Eigen::Vector3d
normalNear(const pcl::PointCloud<ToolpathPoint>& path, const Eigen::Vector3f& place)
{
  const auto nearest = std::min_element(path.begin(), path.end(), [&place](const ToolpathPoint& a, const ToolpathPoint& b) {
    return (a.getVector3fMap() - place).squaredNorm() < (b.getVector3fMap() - place).squaredNorm();
  });
  return nearest->getNormalVector3fMap().cast<double>();
}

void
check(const ReachScene& scene)
{
  if (!scene.part.cloud || scene.part.cloud->empty() || !scene.part.path || scene.part.path->empty())
    throw std::invalid_argument("a picture of the largest balls needs points and a path");
  if (scene.radii.size() != scene.part.cloud->size())
    throw std::invalid_argument(std::to_string(scene.radii.size()) + " radii for " + std::to_string(scene.part.cloud->size()) +
                                " points; give one radius per point");
}

} // namespace

void
writeReach(const std::string& file, const ReachScene& scene)
{
  check(scene);
  const pcl::PointCloud<pcl::PointXYZ>& points = *scene.part.cloud;
  const pcl::PointCloud<ToolpathPoint>& path = *scene.part.path;
  const double tool = scene.part.settings.tool_radius;
  const DisplaySurface surface = displaySurface(scene.part);
  const auto tightest = static_cast<std::size_t>(std::min_element(scene.radii.begin(), scene.radii.end()) - scene.radii.begin());
  const double least = scene.radii[tightest];
  const auto colors = colorScale(std::min(least, 0.5 * scene.largest), scene.largest);
  const ValueStyle style = reachStyle(colors);
  Canvas canvas(surface);
  canvas.add(surfaceActor(surface.mesh, surface_color));
  const double radius = discRadius(surface, points.size());
  addPointMap(canvas, DepthMap(surface, canvas), points, scene.radii,
              std::clamp(radius / canvas.projection().mm_per_pixel, least_disc, most_disc), style);
  canvas.addAxes();
  canvas.addColorBar("largest ball, radius in mm", colors);
  std::vector<LegendEntry> legend;
  if (least < scene.largest) {
    const Eigen::Vector3f at = points[tightest].getVector3fMap();
    const Eigen::Vector3d place = at.cast<double>();
    const bool hidden = canvas.addCircle(place);
    legend.push_back({formatted("tightest, %.3g mm", least) + (hidden ? ", hidden by the part" : ""), ink, Marker::Circle});
    addPointInset(canvas, 0, surface, {place, normalNear(path, at), insetWidth(surface, path), "the tightest place"}, points, scene.radii,
                  radius, style, path);
  }
  canvas.addLegend(legend);
  canvas.addTitle(scene.part.title + ": largest ball that reaches each point",
                  formatted("a ball of radius %g mm does not reach: ", tool) + shareBelow(scene.radii, tool) +
                      formatted("; radii up to %g mm were tried", scene.largest));
  canvas.save(file);
}

} // namespace pcl_spiral
