#include <pcl_spiral/surface/mls_surface.h>

#include <pcl_spiral/search/neighbour_search.h>

#include "local_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr int fewest_neighbours = 32, most_neighbours = 256;
constexpr double farthest_in_spacings = 4.0; // of a query from the nearest point; triangles span up to three
constexpr double refit_distance = 0.1;       // in spacings: a foot that far from the query gets a fit of its own
constexpr double run_width = 1.5;            // of queries searched together, in radii of a neighbourhood
constexpr double largest_overhang = 1.25;    // in spacings

/** Mean of the oriented normals of the nearest few neighbours. */
Eigen::Vector3d
meanNormal(const Neighbourhood& near, const std::vector<Eigen::Vector3f>& normals)
{
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (int j = 0; j < std::min(near.size, 12); ++j)
    sum += normals[near.index[j]];
  const float norm = sum.norm();
  return norm > 0.0f ? Eigen::Vector3d((sum / norm).cast<double>()) : normals[near.index[0]].cast<double>();
}

/** Queries that lie together, one search for all of them. */
struct QueryRun {
  std::size_t begin, end;
  Box box;
};

/** Runs of up to a block of spatially sorted queries, none wider than \p widest: few queries far apart would each scan
 *  what lies between them. */
std::vector<QueryRun>
runsOf(const std::vector<IndexedPosition>& order, float widest)
{
  std::vector<QueryRun> runs;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (!runs.empty() && i - runs.back().begin < PointBlocks::block_size) {
      Box box = runs.back().box;
      box.extend(&order[i].x);
      if (box.diagonal() <= widest) {
        runs.back().box = box;
        runs.back().end = i + 1;
        continue;
      }
    }
    QueryRun run{i, i + 1, {}};
    run.box.extend(&order[i].x);
    runs.push_back(run);
  }
  return runs;
}

} // namespace

double
overhang(const Neighbourhood& near, const Eigen::Vector3d& centroid)
{
  const double distance = centroid.norm();
  if (!(distance > 0.0))
    return 0.0;
  const Eigen::Vector3f inward = (centroid / distance).cast<float>();
  float nearest = near.x[0] * inward.x() + near.y[0] * inward.y() + near.z[0] * inward.z();
  for (int j = 1; j < near.size; ++j)
    nearest = std::min(nearest, near.x[j] * inward.x() + near.y[j] * inward.y() + near.z[j] * inward.z());
  return std::max(0.0f, nearest);
}

MlsSurface::MlsSurface(const SurfaceGraph& graph, int neighbours, ProjectionMethod method)
: graph_(graph), method_(method), neighbours_(neighbours)
{
  chooseNeighbours();
}

void
MlsSurface::projectOnce(const std::vector<std::uint32_t>& which, std::vector<SurfaceFoot>& feet, int neighbours) const
{
  std::vector<IndexedPosition> order(which.size());
  for (std::size_t i = 0; i < which.size(); ++i) {
    const Eigen::Vector3f q = feet[which[i]].position.cast<float>();
    order[i] = {q.x(), q.y(), q.z(), which[i]};
  }
  sortSpatially(order);
  const auto widest = static_cast<float>(run_width * graph_.spacing() * std::sqrt(neighbours / M_PI));
  const std::vector<QueryRun> runs = runsOf(order, widest);
  const auto reach = static_cast<float>(12.0 * graph_.spacing() * std::sqrt(neighbours / M_PI));
#pragma omp parallel
  {
    NeighbourSearch search(graph_.blocks(), neighbours, reach);
#pragma omp for schedule(dynamic, 16)
    for (std::int64_t r = 0; r < static_cast<std::int64_t>(runs.size()); ++r) {
      search.setRun(runs[r].box);
      for (std::size_t i = runs[r].begin; i < runs[r].end; ++i) {
        SurfaceFoot& foot = feet[order[i].index];
        const Eigen::Vector3d from = foot.position;
        const Neighbourhood& near = search.find(from);
        foot.valid = false;
        if (near.size < std::min<int>(neighbours, static_cast<int>(graph_.size())) ||
            std::sqrt(near.squared_distance[0]) > farthest_in_spacings * graph_.spacing(near.index[0]))
          continue;
        switch (method_) {
        case ProjectionMethod::Quadratic:
          foot = quadraticFoot(from, near, meanNormal(near, graph_.normals()));
          break;
        case ProjectionMethod::RobustQuartic:
          foot = robustQuarticFoot(from, near, meanNormal(near, graph_.normals()));
          break;
        case ProjectionMethod::DirectionalCentroid:
          foot = directionalCentroidFoot(from, near, graph_.normals());
          break;
        }
        foot.valid = foot.valid && foot.overhang < largest_overhang * graph_.spacing(near.index[0]);
      }
    }
  }
}

void
MlsSurface::project(const std::vector<Eigen::Vector3d>& queries, std::vector<SurfaceFoot>& feet) const
{
  constexpr int most_rounds = 4;
  feet.assign(queries.size(), SurfaceFoot());
  std::vector<std::uint32_t> which;
  which.reserve(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    feet[i].position = queries[i];
    if (queries[i].allFinite() && queries[i].cwiseAbs().maxCoeff() < 1e15)
      which.push_back(static_cast<std::uint32_t>(i));
  }
  // A fit is about the query; where the foot lies well away from it, fit again about the foot.
  for (int round = 0; round < most_rounds && !which.empty(); ++round) {
    std::vector<Eigen::Vector3d> before(which.size());
    for (std::size_t i = 0; i < which.size(); ++i)
      before[i] = feet[which[i]].position;
    projectOnce(which, feet, neighbours_);
    std::vector<std::uint32_t> again;
    for (std::size_t i = 0; i < which.size(); ++i) {
      const SurfaceFoot& foot = feet[which[i]];
      if (foot.valid && (foot.position - before[i]).norm() > refit_distance * graph_.spacing())
        again.push_back(which[i]);
    }
    which.swap(again);
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
  // Places spread over the cloud: centroids of triangles, so that no point of the cloud weighs more than its share.
  std::vector<Eigen::Vector3d> sample;
  const Triangulation& mesh = graph_.triangulation();
  const std::size_t step = std::max<std::size_t>(1, mesh.triangleCount() / 2000);
  for (std::size_t t = step / 2; t < mesh.triangleCount(); t += step) {
    const auto& corner = mesh.triangle(t);
    sample.push_back((graph_.position(corner[0]) + graph_.position(corner[1]) + graph_.position(corner[2])) / 3.0);
  }
  std::vector<std::uint32_t> which(sample.size());
  std::iota(which.begin(), which.end(), 0u);
  std::size_t determined = 0; // fits at the sample, last time
  const auto scatter = [&](int k) {
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
    noise_ = std::sqrt(scatter(neighbours_));
    return;
  }
  neighbours_ = std::max(fewest_neighbours, graph_.neighbours());
  if (method_ == ProjectionMethod::RobustQuartic)
    neighbours_ += neighbours_ / 2;
  neighbours_ = std::min(neighbours_, limit);
  double variance = scatter(neighbours_);
  // Scan lines far apart: a fit to one line and a half does not know the slope across.
  while (1000 * determined < 999 * sample.size() && 2 * neighbours_ <= std::min(most_neighbours, limit)) {
    neighbours_ *= 2;
    variance = scatter(neighbours_);
  }
  noise_ = std::sqrt(variance);
  // Rounding to single precision is no noise worth averaging.
  double magnitude = 0.0;
  for (int d = 0; d < 3; ++d)
    magnitude = std::max<double>({magnitude, std::abs(graph_.blocks().box().low[d]), std::abs(graph_.blocks().box().high[d])});
  if (noise_ < 1e-7 * magnitude)
    return;
  // Where noise alone scatters the points, a wider fit finds the same variance; where the surface's own shape does,
  // the variance grows with the fourth power of the neighbours.
  constexpr double still_noise = 1.05;
  while (2 * neighbours_ <= std::min(most_neighbours, limit)) {
    const double wider = scatter(2 * neighbours_);
    if (wider > still_noise * variance)
      break;
    neighbours_ *= 2;
    variance = wider;
    noise_ = std::sqrt(variance);
  }
}

} // namespace pcl_spiral
