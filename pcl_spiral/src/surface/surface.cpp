// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/surface/surface.h>

#include "part_choice.h"
#include "sheet_refusal.h"

#include <algorithm>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double two_sheets_noise = 0.35; // of the spacing: with more noise it is no surface

/** Heights of some hundreds of the points over the surface fitted to them. */
std::vector<PointHeight>
heightsOf(const Surface& surface)
{
  constexpr std::size_t samples = 500;
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < surface.size(); i += std::max<std::size_t>(1, surface.size() / samples))
    places.push_back(surface.position(i));
  std::vector<SurfaceFoot> feet;
  surface.fit().project(places, feet);
  std::vector<PointHeight> heights;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (feet[i].valid)
      heights.push_back({places[i], (places[i] - feet[i].position).dot(feet[i].normal)});
  return heights;
}

} // namespace

Surface::Surface(Parts parts) : graph_(parts.graph), fit_(graph_), voids_(std::make_shared<const ScanVoids>(graph_))
{
  parts.graph = SurfaceGraph();
  parts_ = std::make_shared<const Parts>(std::move(parts));
}

Surface::ConstPtr
Surface::withoutTriangulation(const ConstPtr& surface)
{
  const auto bare = std::make_shared<Surface>(*surface);
  bare->fit_ = surface->fit_.withoutTriangulation();
  bare->graph_ = bare->fit_.graph();
  return bare;
}

Status
checkSingleSheet(const Surface& surface)
{
  if (!(surface.noise() > two_sheets_noise * surface.spacing()))
    return Status::success();
  if (const Status status = checkChosen(surface.graph(), surface.settings()); !status.ok())
    return status;
  return sheetRefusal(surface.noise(), surface.spacing(), heightsOf(surface));
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

} // namespace pcl_spiral
