// SPDX-License-Identifier: BSD-3-Clause
#include "space_filling.h"

#include "sheet_refusal.h"

#include "core/median.h"
#include "graph/local_shape.h"
#include "search/neighbour_search.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl_spiral {
namespace {

constexpr std::size_t fewest_points = 10000; // fewer are soon refused by the stages that follow
constexpr std::size_t places_looked_at = 500;
constexpr int about_part = 4096; // points about part_at that are looked at
constexpr int sizes[] = {256, 128, 64, 32};
constexpr double thick = 0.4;               // thickness over width
constexpr double most = 0.5, nearly = 0.95; // shares of the places

/** Indices of at most \p count of \p points, evenly chosen. */
std::vector<std::uint32_t>
someOf(std::size_t points, std::size_t count)
{
  const std::size_t step = std::max<std::size_t>(1, points / count);
  std::vector<std::uint32_t> some;
  for (std::size_t i = step / 2; i < points; i += step)
    some.push_back(static_cast<std::uint32_t>(i));
  return some;
}

/** Points looked at, in the order of the blocks: spread over all, or about the place of the part. */
std::vector<std::uint32_t>
pointsLookedAt(const PointBlocks& blocks, const SurfaceSettings& settings)
{
  if (!settings.part_at)
    return someOf(blocks.size(), places_looked_at);
  const std::uint32_t at = blocks.nearest(*settings.part_at);
  NeighbourSearch search(blocks, about_part);
  Box box;
  box.extend(blocks.point(at).data());
  search.setRun(box);
  const Neighbourhood& near = search.find(blocks.position(at));
  std::vector<std::uint32_t> points = someOf(static_cast<std::size_t>(near.size), places_looked_at);
  for (std::uint32_t& i : points)
    i = near.index[i];
  return points;
}

/** What the neighbours of one point show. */
struct LookedAt {
  bool fills = true;
  PointHeight height;   ///< of one of the points of its largest neighbourhood over their plane
  double noise = 0.0;   ///< of that neighbourhood about its plane, mm
  double spacing = 0.0; ///< mm
};

/** Thickness of the neighbours of a point, and the height of one of them over their plane, towards \p outward. */
void
look(const Neighbourhood& near, const Eigen::Vector3d& outward, LookedAt& place)
{
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int j = 0; j < near.size; ++j) {
    const Eigen::Vector3d d(near.x[j], near.y[j], near.z[j]);
    mean += d / near.size;
    moment += d * d.transpose() / near.size;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moment - mean * mean.transpose());
  const double thickness = std::sqrt(std::max(0.0, solver.eigenvalues()[0])), width = std::sqrt(solver.eigenvalues()[2]);
  place.fills = place.fills && thickness > thick * width;
  if (near.size < sizes[0])
    return;
  place.noise = thickness;
  place.spacing = evenSpacing(std::sqrt(near.squared_distance[near.size - 1]), near.size);
  const int other = near.size / 2; // one of the points; the one in the middle is always near the plane
  const Eigen::Vector3d normal = solver.eigenvectors().col(0), offset(near.x[other], near.y[other], near.z[other]);
  place.height.place += offset;
  place.height.value = normal.dot(offset - mean) * (normal.dot(outward) < 0.0 ? -1.0 : 1.0);
}

std::vector<LookedAt>
lookAt(const PointBlocks& blocks, const std::vector<std::uint32_t>& points, const SurfaceSettings& settings)
{
  std::vector<LookedAt> places(points.size());
#pragma omp parallel
  {
    NeighbourSearch search(blocks, sizes[0]);
#pragma omp for schedule(dynamic, 8)
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(points.size()); ++i) {
      Box box;
      box.extend(blocks.point(points[i]).data());
      search.setRun(box);
      Neighbourhood near = search.find(blocks.position(points[i]));
      const Eigen::Vector3d position = blocks.position(points[i]);
      const Eigen::Vector3d outward = settings.view_point ? Eigen::Vector3d(*settings.view_point - position) : Eigen::Vector3d::UnitZ();
      places[i].height.place = position;
      for (const int size : sizes) { // nearest first: the smaller neighbourhoods are its beginnings
        near.size = size;
        look(near, outward, places[i]);
      }
    }
  }
  return places;
}

} // namespace

Status
checkFillsSpace(const PointBlocks& blocks, const SurfaceSettings& settings)
{
  if (blocks.size() < fewest_points)
    return Status::success();
  const std::vector<LookedAt> places = lookAt(blocks, pointsLookedAt(blocks, settings), settings);
  const auto fill = std::count_if(places.begin(), places.end(), [](const LookedAt& place) { return place.fills; });
  if (static_cast<double>(fill) < (settings.largest_part ? nearly : most) * static_cast<double>(places.size()))
    return Status::success();
  std::vector<double> noise, spacing;
  std::vector<PointHeight> heights;
  for (const LookedAt& place : places) {
    noise.push_back(place.noise);
    spacing.push_back(place.spacing);
    heights.push_back(place.height);
  }
  return sheetRefusal(medianOf(noise), medianOf(spacing), heights);
}

} // namespace pcl_spiral
