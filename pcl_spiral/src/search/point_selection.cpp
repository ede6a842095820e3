#include <pcl_spiral/search/neighbour_search.h>
#include <pcl_spiral/search/point_selection.h>

#include <cmath>
#include <numeric>

namespace pcl_spiral {

namespace {

std::vector<std::uint32_t>
allIndices(std::size_t n)
{
  std::vector<std::uint32_t> indices(n);
  std::iota(indices.begin(), indices.end(), 0u);
  return indices;
}

/** Mean distance of each point to its nearest. */
std::vector<double>
meanDistances(const std::vector<Eigen::Vector3f>& points, int neighbours)
{
  const PointBlocks blocks(points);
  std::vector<double> mean(points.size(), 0.0);
  const auto count = static_cast<std::int64_t>(blocks.blockCount());
#pragma omp parallel
  {
    NeighbourSearch search(blocks, neighbours + 1);
#pragma omp for schedule(dynamic, 16)
    for (std::int64_t b = 0; b < count; ++b) {
      search.setRun(blocks.blockBox(b));
      for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i) {
        const Neighbourhood& near = search.find(blocks.position(i));
        double sum = 0.0;
        for (int k = 1; k < near.size; ++k)
          sum += std::sqrt(static_cast<double>(near.squared_distance[k]));
        mean[blocks.originalIndex(i)] = sum / std::max(1, near.size - 1);
      }
    }
  }
  return mean;
}

} // namespace

std::vector<std::uint32_t>
distinctPoints(const std::vector<Eigen::Vector3f>& points)
{
  std::vector<std::uint32_t> order = allIndices(points.size());
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const Eigen::Vector3f &p = points[a], &q = points[b];
    if (p.x() != q.x())
      return p.x() < q.x();
    if (p.y() != q.y())
      return p.y() < q.y();
    return p.z() != q.z() ? p.z() < q.z() : a < b;
  });
  const auto same = [&](std::uint32_t a, std::uint32_t b) { return points[a] == points[b]; };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  std::sort(order.begin(), order.end());
  return order;
}

std::vector<std::uint32_t>
statisticalInliers(const std::vector<Eigen::Vector3f>& points, int neighbours, double deviations)
{
  if (points.size() < 2)
    return allIndices(points.size());
  const std::vector<double> distance = meanDistances(points, neighbours);
  const double n = static_cast<double>(points.size());
  const double mean = std::accumulate(distance.begin(), distance.end(), 0.0) / n;
  double squares = 0.0;
  for (const double d : distance)
    squares += (d - mean) * (d - mean);
  const double limit = mean + deviations * std::sqrt(squares / (n - 1.0));
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (distance[i] <= limit)
      kept.push_back(static_cast<std::uint32_t>(i));
  return kept;
}

std::vector<std::uint32_t>
voxelRepresentatives(const std::vector<Eigen::Vector3f>& points, double edge)
{
  constexpr double reach = 1 << 20;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> voxels;
  voxels.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::uint64_t key = 0;
    for (int d = 0; d < 3; ++d) {
      const double cell = std::floor(static_cast<double>(points[i][d]) / edge) + reach;
      if (!(cell >= 0.0 && cell < 2.0 * reach))
        return {};
      key = key << 21 | static_cast<std::uint64_t>(cell);
    }
    voxels.emplace_back(key, static_cast<std::uint32_t>(i));
  }
  std::sort(voxels.begin(), voxels.end());
  std::vector<std::uint32_t> kept;
  for (std::size_t first = 0, end; first < voxels.size(); first = end) {
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    for (end = first; end < voxels.size() && voxels[end].first == voxels[first].first; ++end)
      centroid += points[voxels[end].second].cast<double>();
    centroid /= static_cast<double>(end - first);
    std::size_t best = first;
    double least = 1e300;
    for (std::size_t i = first; i < end; ++i)
      if (const double d = (points[voxels[i].second].cast<double>() - centroid).squaredNorm(); d < least) {
        least = d;
        best = i;
      }
    kept.push_back(voxels[best].second);
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

} // namespace pcl_spiral
