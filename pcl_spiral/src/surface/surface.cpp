// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/surface/surface.h>

#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/surface/impl/smoothing_remedy.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double two_sheets_noise = 0.35; // of the spacing: with more noise it is no surface

/** How some hundreds of points lie about the surface fitted to them. */
struct Lie {
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< of the point farthest off
  double farthest = 0.0;                           ///< its distance
  double half = 0.0;                               ///< half of the points lie within this distance
  double tenth = 0.0;                              ///< one in ten lies farther off than this
  double above = 0.0;                              ///< share of those on the outer side
};

Lie
lieOf(const Surface& surface)
{
  constexpr std::size_t samples = 500;
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < surface.size(); i += std::max<std::size_t>(1, surface.size() / samples))
    places.push_back(surface.position(i));
  std::vector<SurfaceFoot> feet;
  surface.fit().project(places, feet);
  Lie lie;
  std::vector<std::pair<double, bool>> heights; // distance; whether on the outer side
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!feet[i].valid)
      continue;
    const double height = (places[i] - feet[i].position).dot(feet[i].normal);
    heights.emplace_back(std::abs(height), height > 0.0);
    if (std::abs(height) > lie.farthest) {
      lie.farthest = std::abs(height);
      lie.place = places[i];
    }
  }
  if (heights.empty())
    return lie;
  std::sort(heights.begin(), heights.end());
  const std::size_t far = heights.size() - 1 - heights.size() / 10;
  lie.half = heights[heights.size() / 2].first;
  lie.tenth = heights[far].first;
  lie.above = static_cast<double>(std::count_if(heights.begin() + static_cast<std::ptrdiff_t>(far), heights.end(),
                                                [](const auto& height) { return height.second; })) /
              static_cast<double>(heights.size() - far);
  return lie;
}

} // namespace

Surface::Surface(Parts parts) : parts_(std::move(parts)), fit_(parts_.graph), voids_(parts_.graph) {}

Status
checkSingleSheet(const Surface& surface)
{
  if (!(surface.noise() > two_sheets_noise * surface.spacing()))
    return Status::success();
  const Lie lie = lieOf(surface);
  return {StatusCode::InvalidInput,
          textOf("the noise of the points about a local surface is ", surface.noise(), " mm, up to ", lie.farthest, " mm at ",
                 placeText(lie.place), ", and their spacing is ", surface.spacing(), " mm. Half of the points lie within ", lie.half,
                 " mm of the surface, one in ten more than ", lie.tenth, " mm off it, ", std::round(100.0 * lie.above),
                 " % of these above it: this is not a single sheet (a thin double wall, noise above the point spacing, or trees or "
                 "flying points over the surface); for a wall, keep only one side in the cloud; where trees or flying points are, crop "
                 "the scan to the part (setCrop); for noise, ",
                 smoothingRemedy(surface.noise()))};
}

std::vector<Eigen::Vector3f>
Surface::riddenPoints() const
{
  std::vector<Eigen::Vector3f> points;
  if (settings().clusters == ClusterHandling::Ride)
    for (const StandingCluster& cluster : clusters())
      points.insert(points.end(), cluster.positions.begin(), cluster.positions.end());
  return points;
}

void
dropTriangulation(const Surface::ConstPtr& surface)
{
  if (surface.use_count() == 1) // made by makeSurface, never as a constant
    const_cast<Surface&>(*surface).parts_.graph.dropTriangulation();
}

std::string
disagreement(const SurfaceSettings& asked, const SurfaceSettings& made)
{
  const SurfaceSettings unset;
  if (asked.view_point && asked.view_point != made.view_point)
    return "setViewPoint";
  if (asked.flip_normals && !made.flip_normals)
    return "setFlipNormals";
  if (asked.largest_part && !made.largest_part)
    return "setLargestPart";
  if (asked.part_at && asked.part_at != made.part_at)
    return "setPartAt";
  if (asked.clusters != unset.clusters && asked.clusters != made.clusters)
    return "setClusterHandling";
  if (asked.thinning != unset.thinning && asked.thinning != made.thinning)
    return "setThinning";
  if (asked.outlier_neighbours != unset.outlier_neighbours &&
      (asked.outlier_neighbours != made.outlier_neighbours || asked.outlier_deviations != made.outlier_deviations))
    return "setOutlierRemoval";
  if (asked.neighbours != unset.neighbours && asked.neighbours != made.neighbours)
    return "setKSearch";
  if (asked.alpha != unset.alpha && asked.alpha != made.alpha)
    return "setAlpha";
  return {};
}

} // namespace pcl_spiral
