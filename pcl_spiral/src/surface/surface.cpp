// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/surface/surface.h>

#include <pcl_spiral/common/impl/message.h>
#include <pcl_spiral/surface/impl/smoothing_remedy.h>

#include <algorithm>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double two_sheets_noise = 0.35; // of the spacing: with more noise it is no surface

/** The point farthest off the surface, of some hundreds, and its distance. */
std::pair<Eigen::Vector3d, double>
farthestOff(const Surface& surface)
{
  constexpr std::size_t samples = 500;
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < surface.size(); i += std::max<std::size_t>(1, surface.size() / samples))
    places.push_back(surface.position(i));
  std::vector<SurfaceFoot> feet;
  surface.fit().project(places, feet);
  std::pair<Eigen::Vector3d, double> farthest{places.front(), 0.0};
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const double off = (feet[i].position - places[i]).norm(); feet[i].valid && off > farthest.second)
      farthest = {places[i], off};
  return farthest;
}

} // namespace

Surface::Surface(Parts parts) : parts_(std::move(parts)), fit_(parts_.graph), voids_(parts_.graph) {}

Status
checkSingleSheet(const Surface& surface)
{
  if (!(surface.noise() > two_sheets_noise * surface.spacing()))
    return Status::success();
  const auto [place, off] = farthestOff(surface);
  return {StatusCode::InvalidInput,
          textOf("the noise of the points about a local surface is ", surface.noise(), " mm, up to ", off, " mm at ", placeText(place),
                 ", and their spacing is ", surface.spacing(),
                 " mm: this is not a single sheet (a thin double wall, or noise above the point spacing); for a wall, keep only "
                 "one side in the cloud; for noise, ",
                 smoothingRemedy(surface.noise()))};
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
