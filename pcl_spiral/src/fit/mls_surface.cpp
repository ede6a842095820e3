// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/fit/impl/mls_surface.h>

#include "search/neighbour_search.h"

#include "local_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr int fewest_neighbours = 32, most_neighbours = 256;
constexpr double farthest_in_spacings = 4.0; // of a query from the nearest point; triangles span up to three
constexpr double refit_distance = 0.1;       // in spacings: a foot this far from the query gets a fit of its own
constexpr double run_width = 3.0;            // of queries searched together, in radii of a neighbourhood
constexpr double largest_overhang = 1.25;    // in spacings

struct NearestPoint {
  std::uint32_t index;
  float squared_distance;
};

NearestPoint
nearestOf(const Patch& patch)
{
  return {patch.nearest, patch.nearest_squared_distance};
}

NearestPoint
nearestOf(const Neighbourhood& near)
{
  return {near.index[0], near.squared_distance[0]};
}

void
keepMarked(const std::vector<std::uint8_t>& marked, std::vector<std::uint32_t>& list)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (marked[i])
      list[kept++] = list[i];
  list.resize(kept);
}

/** End of the run of queries from \p begin that one search serves, and the run's \p box: no wider than \p widest, because
 *  few queries far apart would each scan everything between them. */
std::size_t
endOfRun(const std::vector<IndexedPosition>& order, std::size_t begin, std::size_t end, float widest, Box& box)
{
  box = Box();
  box.extend(&order[begin].x);
  std::size_t i = begin + 1;
  for (; i < end; ++i) {
    Box wider = box;
    wider.extend(&order[i].x);
    if (wider.diagonal() > widest)
      break;
    box = wider;
  }
  return i;
}

} // namespace

Eigen::Vector3d
meanNormal(const std::uint32_t* nearest, int count, const std::vector<Eigen::Vector3f>& normals)
{
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (int j = 0; j < count; ++j)
    sum += normals[nearest[j]];
  const float norm = sum.norm();
  return norm > 0.0f ? Eigen::Vector3d((sum / norm).cast<double>()) : normals[nearest[0]].cast<double>();
}

MlsSurface::MlsSurface(const SurfaceGraph& graph, int neighbours, ProjectionMethod method)
: graph_(graph), method_(method), neighbours_(neighbours)
{
  chooseNeighbours();
}

MlsSurface
MlsSurface::withoutTriangulation() const
{
  MlsSurface same = *this;
  same.graph_ = graph_.withoutTriangulation();
  return same;
}

std::vector<std::uint8_t>
MlsSurface::projectOnce(const std::vector<std::uint32_t>& which, std::vector<SurfaceFoot>& feet, int neighbours) const
{
  const auto count = static_cast<std::int64_t>(which.size());
  std::vector<std::uint8_t> moved(which.size(), 0);
  std::vector<IndexedPosition> order(which.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i) {
    const Eigen::Vector3f q = feet[which[i]].position.cast<float>();
    order[i] = {q.x(), q.y(), q.z(), static_cast<std::uint32_t>(i)};
  }
  sortSpatially(order);
  const double usual_radius = graph_.spacing() * std::sqrt(neighbours / pi);
  const auto widest = static_cast<float>(run_width * usual_radius), reach = static_cast<float>(12.0 * usual_radius);
  const auto fitAll = [&](auto search, auto fit) {
    const BlockPartition blocks(which.size());
    const int needed = std::min<int>(neighbours, static_cast<int>(graph_.size()));
#pragma omp for schedule(dynamic, 16)
    for (std::int64_t block = 0; block < static_cast<std::int64_t>(blocks.blocks()); ++block) {
      const std::size_t block_end = blocks.begin(block + 1);
      for (std::size_t i = blocks.begin(block), end = i; i < block_end;) {
        Box box;
        end = endOfRun(order, i, block_end, widest, box);
        search.setRun(box);
        for (; i < end; ++i) {
          SurfaceFoot& foot = feet[which[order[i].index]];
          const Eigen::Vector3d from = foot.position;
          const auto& near = search.find(from);
          foot.valid = false;
          if (near.size < needed)
            continue;
          const NearestPoint nearest = nearestOf(near);
          const double spacing = graph_.spacing(nearest.index);
          const double farthest = farthest_in_spacings * std::max(spacing, graph_.spacing());
          if (std::sqrt(nearest.squared_distance) > (neighbours > neighbours_ ? 2.0 : 1.0) * farthest)
            continue;
          foot = fit(from, near);
          foot.nearest = nearest.index;
          foot.nearest_distance = std::sqrt(nearest.squared_distance);
          foot.valid = foot.valid && foot.overhang < largest_overhang * spacing && (foot.position - from).norm() < farthest;
          moved[order[i].index] = foot.valid && (foot.position - from).norm() > refit_distance * graph_.spacing();
        }
      }
    }
  };
  const std::vector<Eigen::Vector3f>& normals = graph_.normals();
  const auto quadratic = [&](const Eigen::Vector3d& q, const Patch& near) {
    return quadraticFoot(q, near, meanNormal(near.inner, near.inner_size, normals));
  };
  const auto quartic = [&](const Eigen::Vector3d& q, const Neighbourhood& near) {
    return robustQuarticFoot(q, near, meanNormal(near.index, std::min(near.size, 12), normals));
  };
  const auto centroid = [&](const Eigen::Vector3d& q, const Neighbourhood& near) { return directionalCentroidFoot(q, near, normals); };
#pragma omp parallel
  switch (method_) {
  case ProjectionMethod::Quadratic:
    fitAll(PatchSearch(graph_.blocks(), neighbours, reach), quadratic);
    break;
  case ProjectionMethod::RobustQuartic:
    fitAll(NeighbourSearch(graph_.blocks(), neighbours, reach), quartic);
    break;
  case ProjectionMethod::DirectionalCentroid:
    fitAll(NeighbourSearch(graph_.blocks(), neighbours, reach), centroid);
    break;
  }
  return moved;
}

double
MlsSurface::fitNoise() const
{
  const double factor = method_ == ProjectionMethod::Quadratic ? 50.0 / 7.0 : method_ == ProjectionMethod::RobustQuartic ? 9.46 : 2.08;
  return noise_ * std::sqrt(factor / neighbours_);
}

void
MlsSurface::project(const std::vector<Eigen::Vector3d>& queries, std::vector<SurfaceFoot>& feet, int widest) const
{
  constexpr int most_rounds = 4;
  constexpr double farthest_query = 1e15;
  feet.resize(queries.size());
  std::vector<std::uint32_t> which;
  which.reserve(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i)
    if (queries[i].allFinite() && queries[i].cwiseAbs().maxCoeff() < farthest_query)
      which.push_back(static_cast<std::uint32_t>(i));
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(queries.size()); ++i) {
    feet[i] = SurfaceFoot();
    feet[i].position = queries[i];
  }
  // Where points are closer together on one side than on the other, the nearest ones may all lie on that side: a wider fit spans both.
  for (int width = 1; width <= widest && !which.empty(); width *= 2) {
    std::vector<std::uint32_t> moving = which;
    for (int round = 0; round < most_rounds && !moving.empty(); ++round) {
      const std::vector<std::uint8_t> moved = projectOnce(moving, feet, width * neighbours_);
      keepMarked(moved, moving); // a fit is about the query; if the foot is far from it, fit again about the foot
    }
    std::vector<std::uint8_t> open(which.size());
    for (std::size_t i = 0; i < which.size(); ++i) {
      open[i] = !feet[which[i]].valid;
      if (open[i])
        feet[which[i]].position = queries[which[i]];
    }
    keepMarked(open, which);
  }
}

SurfaceFoot
MlsSurface::project(const Eigen::Vector3d& query) const
{
  std::vector<SurfaceFoot> feet;
  project(std::vector<Eigen::Vector3d>{query}, feet);
  return feet[0];
}

void
MlsSurface::chooseNeighbours()
{
  // Places spread over the cloud: centroids of triangles, so that no point counts more than its share.
  std::vector<Eigen::Vector3d> sample;
  const Triangulation& mesh = graph_.triangulation();
  const std::size_t step = std::max<std::size_t>(1, mesh.triangleCount() / 2000);
  for (std::size_t t = step / 2; t < mesh.triangleCount(); t += step) {
    const auto& corner = mesh.triangle(t);
    sample.push_back((graph_.position(corner[0]) + graph_.position(corner[1]) + graph_.position(corner[2])) / 3.0);
  }
  std::vector<std::uint32_t> which(sample.size());
  std::iota(which.begin(), which.end(), 0u);
  std::size_t determined = 0; // number of fits determined at the sample, last time
  const auto varianceOf = [&](int k) {
    std::vector<SurfaceFoot> feet(sample.size());
    for (std::size_t i = 0; i < sample.size(); ++i)
      feet[i].position = sample[i];
    projectOnce(which, feet, k);
    double squares = 0.0;
    std::size_t count = 0;
    for (const SurfaceFoot& foot : feet)
      if (foot.valid) {
        squares += foot.residual * foot.residual;
        ++count;
      }
    determined = count;
    return count ? squares / static_cast<double>(count) : 0.0;
  };
  const auto limit = static_cast<int>(graph_.size());
  if (neighbours_ > 0) {
    neighbours_ = std::min(neighbours_, limit);
    noise_ = std::sqrt(varianceOf(neighbours_));
    return;
  }
  neighbours_ = std::max(fewest_neighbours, graph_.neighbours());
  if (method_ == ProjectionMethod::RobustQuartic)
    neighbours_ += neighbours_ / 2;
  neighbours_ = std::min(neighbours_, limit);
  double variance = varianceOf(neighbours_);
  // Scan lines far apart: a fit to one line and a half does not show the slope across.
  while (1000 * determined < 999 * sample.size() && 2 * neighbours_ <= std::min(most_neighbours, limit)) {
    neighbours_ *= 2;
    variance = varianceOf(neighbours_);
  }
  noise_ = std::sqrt(variance);
  // Rounding to single precision is not noise to be averaged.
  double magnitude = 0.0;
  for (int d = 0; d < 3; ++d)
    magnitude = std::max<double>({magnitude, std::abs(graph_.blocks().box().low[d]), std::abs(graph_.blocks().box().high[d])});
  if (noise_ < 1e-7 * magnitude)
    return;
  // If only noise moves the points, a wider fit finds the same variance. If the shape of the surface does,
  // the variance grows with the fourth power of the number of neighbours.
  constexpr double still_noise = 1.05;
  while (2 * neighbours_ <= std::min(most_neighbours, limit)) {
    const double wider = varianceOf(2 * neighbours_);
    if (wider > still_noise * variance)
      break;
    neighbours_ *= 2;
    variance = wider;
    noise_ = std::sqrt(variance);
  }
}

} // namespace pcl_spiral
