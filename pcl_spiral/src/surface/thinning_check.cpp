// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/surface/impl/thinning_check.h>

#include <pcl_spiral/core/diagnostic.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace pcl_spiral {
namespace {

constexpr std::size_t most_samples = 200000;
constexpr double cube_edges = 3.0; // thinning edges
constexpr double standard_errors = 3.0;
constexpr std::size_t fewest = 8;    // points in a cube
constexpr double share = 0.99;       // of the cubes
constexpr double remedy_share = 0.8; // of the edge at which the error should just be allowed

struct Cube {
  std::size_t count = 0;
  double sum = 0.0, squares = 0.0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); // of its first point
};

/** Evenly chosen points that thinning left out. */
std::vector<Eigen::Vector3d>
thinnedPoints(const LeftOutPoints& left_out, std::size_t thinned)
{
  const std::size_t every = 1 + thinned / most_samples;
  std::vector<Eigen::Vector3d> places;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < left_out.why.size(); ++i)
    if (left_out.why[i] == LeftOut::Thinned && seen++ % every == 0)
      places.push_back(left_out.positions[i].cast<double>());
  return places;
}

/** Mean distance in a cube, less what its noise explains. */
double
distanceOf(const Cube& cube)
{
  const double n = static_cast<double>(cube.count), mean = cube.sum / n;
  const double variance = std::max(0.0, cube.squares / n - mean * mean);
  return std::max(0.0, std::abs(mean) - standard_errors * std::sqrt(variance / (n - 1.0)));
}

} // namespace

ThinningError
thinningError(const Surface& surface)
{
  const std::vector<Eigen::Vector3d> places = thinnedPoints(surface.leftOut(), surface.report().thinned);
  std::vector<SurfaceFoot> feet;
  surface.fit().project(places, feet);
  std::map<std::array<long, 3>, Cube> cubes;
  const double edge = cube_edges * surface.settings().thinning;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!feet[i].valid)
      continue;
    const Eigen::Array3d at = ((places[i] - places.front()) / edge).array().floor();
    Cube& cube = cubes[{static_cast<long>(at.x()), static_cast<long>(at.y()), static_cast<long>(at.z())}];
    const double off = (places[i] - feet[i].position).dot(feet[i].normal);
    if (cube.count++ == 0)
      cube.place = places[i];
    cube.sum += off;
    cube.squares += off * off;
  }
  std::vector<ThinningError> errors;
  for (const auto& [at, cube] : cubes)
    if (cube.count >= fewest)
      errors.push_back({distanceOf(cube), cube.place});
  if (errors.empty())
    return {};
  const std::size_t at = static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1));
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(at), errors.end(),
                   [](const ThinningError& a, const ThinningError& b) { return a.distance < b.distance; });
  return errors[at];
}

Status
checkThinning(const Surface& surface, double allowed)
{
  if (surface.report().thinned == 0)
    return Status::success();
  const ThinningError error = thinningError(surface);
  const double edge = surface.settings().thinning;
  if (error.distance <= std::max(allowed, surface.noise()))
    return Status::success();
  return {StatusCode::Failed,
          Diagnostic("the {cloud} was thinned to ", edge, " {mm}, and the surface then lies ", error.distance,
                     " {mm} beside the points that were left out, at ", Place(error.place), "; ", allowed,
                     " {mm} is allowed, the scallop height: thin to ",
                     Proposed("setThinning", remedy_share * edge * std::sqrt(allowed / error.distance)),
                     " {mm} or less ({setThinning}), or set a scallop height above ", error.distance, " {mm} ({setScallopHeight})")};
}

} // namespace pcl_spiral
