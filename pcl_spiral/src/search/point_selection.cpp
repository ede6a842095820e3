// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/search/impl/point_selection.h>

#include "hash_parts.h"
#include "mean_distances.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
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

/** Ascending indices of the values that are not 0. */
std::vector<std::uint32_t>
indicesOf(const std::vector<std::uint8_t>& kept)
{
  std::vector<std::uint32_t> indices;
  indices.reserve(static_cast<std::size_t>(std::count(kept.begin(), kept.end(), 1)));
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i])
      indices.push_back(static_cast<std::uint32_t>(i));
  return indices;
}

/** Hash of a place: 0 and -0 are the same. */
std::uint64_t
hashOf(const Eigen::Vector3f& p)
{
  std::array<std::uint32_t, 3> bits;
  const Eigen::Vector3f without_sign_of_zero = p + Eigen::Vector3f::Zero();
  std::memcpy(bits.data(), without_sign_of_zero.data(), sizeof bits);
  return mixed(mixed(static_cast<std::uint64_t>(bits[0]) << 32 | bits[1]) + bits[2]);
}

Eigen::Vector3f
positionOf(const IndexedPosition& p)
{
  return {p.x, p.y, p.z};
}

/** Voxels of one edge, numbered along each axis from the origin. */
class VoxelGrid {
public:
  explicit VoxelGrid(double edge) : edge_(edge) {}

  /** Whether every point has a voxel: at most 2^20 from the origin. */
  bool holds(const std::vector<Eigen::Vector3f>& points) const
  {
    Box box;
    for (const Eigen::Vector3f& p : points)
      box.extend(p.data());
    for (int d = 0; d < 3 && !points.empty(); ++d)
      if (!(cell(box.low[d]) >= 0.0 && cell(box.high[d]) < 2.0 * reach))
        return false;
    return true;
  }
  std::uint64_t key(const Eigen::Vector3f& p) const
  {
    std::uint64_t key = 0;
    for (int d = 0; d < 3; ++d)
      key = key << 21 | static_cast<std::uint64_t>(cell(p[d]));
    return key;
  }

private:
  static constexpr double reach = 1 << 20;
  double cell(float x) const { return std::floor(static_cast<double>(x) / edge_) + reach; }

  double edge_;
};

/** The voxels of one part of the points. */
class PartVoxels {
public:
  /** Mark in \p kept the point nearest to the centroid of each voxel; of equally near points the first. */
  void mark(const VoxelGrid& grid, const IndexedPosition* begin, const IndexedPosition* end, std::vector<std::uint8_t>& kept)
  {
    table_.reset(static_cast<std::size_t>(end - begin));
    voxels_.clear();
    voxel_of_.clear();
    for (const IndexedPosition* i = begin; i != end; ++i) {
      const Eigen::Vector3f p = positionOf(*i);
      const std::uint64_t key = grid.key(p);
      const std::uint32_t v = table_.number(mixed(key), [&](std::uint32_t n) { return voxels_[n].key == key; });
      if (v == voxels_.size())
        voxels_.push_back({key});
      voxels_[v].sum += p.cast<double>();
      ++voxels_[v].count;
      voxel_of_.push_back(v);
    }
    for (const IndexedPosition* i = begin; i != end; ++i) {
      Voxel& voxel = voxels_[voxel_of_[static_cast<std::size_t>(i - begin)]];
      const Eigen::Vector3d centroid = voxel.sum / static_cast<double>(voxel.count);
      const double squared = (positionOf(*i).cast<double>() - centroid).squaredNorm();
      if (squared < voxel.least) {
        voxel.least = squared;
        voxel.nearest = i->index;
      }
    }
    for (const Voxel& voxel : voxels_)
      kept[voxel.nearest] = 1;
  }

private:
  struct Voxel {
    std::uint64_t key;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::uint32_t count = 0, nearest = 0;
    double least = std::numeric_limits<double>::infinity(); ///< squared distance from the centroid
  };

  KeyTable table_;
  std::vector<Voxel> voxels_;
  std::vector<std::uint32_t> voxel_of_; ///< voxel of each point of the part
};

} // namespace

std::vector<std::uint32_t>
distinctPoints(const std::vector<Eigen::Vector3f>& points)
{
  const HashParts parts(points, hashOf);
  std::vector<std::uint8_t> kept(points.size(), 1);
#pragma omp parallel
  {
    KeyTable table;
    std::vector<Eigen::Vector3f> places;
#pragma omp for schedule(dynamic, 1)
    for (std::int64_t p = 0; p < static_cast<std::int64_t>(parts.count()); ++p) {
      table.reset(static_cast<std::size_t>(parts.end(p) - parts.begin(p)));
      places.clear();
      for (const IndexedPosition* i = parts.begin(p); i != parts.end(p); ++i) {
        const Eigen::Vector3f here = positionOf(*i);
        if (table.number(hashOf(here), [&](std::uint32_t n) { return places[n] == here; }) == places.size())
          places.push_back(here);
        else
          kept[i->index] = 0;
      }
    }
  }
  return indicesOf(kept);
}

std::vector<std::uint32_t>
statisticalInliers(const std::vector<Eigen::Vector3f>& points, int neighbours, double deviations)
{
  if (points.size() < 2)
    return allIndices(points.size());
  const auto others = static_cast<int>(std::min<std::size_t>(points.size() - 1, std::numeric_limits<int>::max() - 1));
  const std::vector<float> distance = meanDistances(points, std::min(neighbours, others));
  const double n = static_cast<double>(points.size());
  const double mean = std::accumulate(distance.begin(), distance.end(), 0.0) / n;
  double squares = 0.0;
  for (const float d : distance)
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
  const VoxelGrid grid(edge);
  if (!grid.holds(points))
    return {};
  const HashParts parts(points, [&](const Eigen::Vector3f& p) { return mixed(grid.key(p)); });
  std::vector<std::uint8_t> kept(points.size(), 0);
#pragma omp parallel
  {
    PartVoxels voxels;
#pragma omp for schedule(dynamic, 1)
    for (std::int64_t p = 0; p < static_cast<std::int64_t>(parts.count()); ++p)
      voxels.mark(grid, parts.begin(p), parts.end(p), kept);
  }
  return indicesOf(kept);
}

} // namespace pcl_spiral
