// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/search/impl/gabriel_edges.h>

#include "all_neighbourhoods.h"

#include <omp.h>

#include <cmath>

namespace pcl_spiral {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/** With a = |x-p|^2, b = |x-q|^2, l = |p-q|^2: (a+b)/2 - l/4 - (1-alpha^2)(a-b)^2/(4l) < alpha^2 l/4, times
 * 4l. */
bool
blocks(double a, double b, double l, double alpha2)
{
  return 2.0 * l * (a + b) - l * l - (1.0 - alpha2) * (a - b) * (a - b) < alpha2 * l * l * (1.0 - 1e-12);
}

/** Finds the edges that start in the points of one block after the other; one object per thread. */
class EdgeFinder {
public:
  EdgeFinder(const PointBlocks& blocks, const std::vector<Eigen::Vector3f>& normals, const std::vector<float>& spacing,
             const GabrielOptions& options)
  : blocks_(blocks), normals_(normals), spacing_(spacing), options_(options), search_(blocks, options.candidates + 1),
    gate_(options.max_normal_angle > 0.0), least_cosine_(std::cos(options.max_normal_angle))
  {}

  void find(std::size_t block, std::vector<Edge>& edges)
  {
    search_.setRun(blocks_.blockBox(block));
    for (std::size_t i = blocks_.blockBegin(block); i < blocks_.blockEnd(block); ++i)
      findFrom(static_cast<std::uint32_t>(i), edges);
  }

private:
  bool meet(std::uint32_t i, std::uint32_t j) const
  {
    return !gate_ ||
           normals_[blocks_.originalIndex(i)].cast<double>().dot(normals_[blocks_.originalIndex(j)].cast<double>()) >= least_cosine_;
  }

  void findFrom(std::uint32_t i, std::vector<Edge>& edges)
  {
    const Neighbourhood& near = search_.find(blocks_.position(i));
    const Eigen::Vector3d p = blocks_.position(i);
    nearer_.clear();
    for (int k = 0; k < near.size; ++k) {
      const std::uint32_t j = near.index[k];
      if (j == i || !meet(i, j))
        continue;
      const Eigen::Vector3d q = blocks_.position(j);
      const double l = (q - p).squaredNorm();
      const double longest = options_.max_edge * std::max(spacing_[i], spacing_[j]);
      if ((options_.max_edge == 0.0 || l <= longest * longest) && isFree(j, q, l))
        edges.emplace_back(blocks_.originalIndex(i), blocks_.originalIndex(j));
      nearer_.push_back({q, l, j});
    }
  }

  bool isFree(std::uint32_t j, const Eigen::Vector3d& q, double l) const
  {
    for (const Nearer& x : nearer_)
      if (blocks(x.squared_distance, (x.position - q).squaredNorm(), l, options_.alpha * options_.alpha) && meet(x.index, j))
        return false;
    return true;
  }

  struct Nearer {
    Eigen::Vector3d position;
    double squared_distance;
    std::uint32_t index;
  };

  const PointBlocks& blocks_;
  const std::vector<Eigen::Vector3f>& normals_;
  const std::vector<float>& spacing_;
  GabrielOptions options_;
  NeighbourSearch search_;
  bool gate_;
  double least_cosine_;
  std::vector<Nearer> nearer_;
};

/** Spacing at each point, in the order of the blocks, as if its candidates were spread evenly over a disc. */
std::vector<float>
localSpacings(const PointBlocks& blocks, int candidates, int threads)
{
  std::vector<float> spacing(blocks.size());
  forNeighbourhoods(blocks, candidates + 1, threads, [&](std::size_t i, const Neighbourhood& near) {
    spacing[i] = std::sqrt(near.squared_distance[near.size - 1] * static_cast<float>(pi) / static_cast<float>(near.size));
  });
  return spacing;
}

} // namespace

bool
blocksEdge(const Eigen::Vector3d& x, const Eigen::Vector3d& p, const Eigen::Vector3d& q, double alpha)
{
  return blocks((x - p).squaredNorm(), (x - q).squaredNorm(), (q - p).squaredNorm(), alpha * alpha);
}

NeighbourLists
ellipticGabrielEdges(const std::vector<Eigen::Vector3f>& points, const std::vector<Eigen::Vector3f>& normals, const GabrielOptions& options)
{
  if (points.empty())
    return {};
  const PointBlocks blocks(points);
  const int threads = options.threads > 0 ? static_cast<int>(options.threads) : omp_get_max_threads();
  const std::vector<float> spacing =
      options.max_edge > 0.0 ? localSpacings(blocks, options.candidates, threads) : std::vector<float>(points.size());
  const auto count = static_cast<std::int64_t>(blocks.blockCount());
  std::vector<std::vector<Edge>> found(blocks.blockCount());
#pragma omp parallel num_threads(threads)
  {
    EdgeFinder finder(blocks, normals, spacing, options);
#pragma omp for schedule(dynamic, 16)
    for (std::int64_t b = 0; b < count; ++b)
      finder.find(static_cast<std::size_t>(b), found[b]);
  }
  std::vector<Edge> edges;
  for (const std::vector<Edge>& part : found)
    edges.insert(edges.end(), part.begin(), part.end());
  return NeighbourLists(points.size(), edges);
}

} // namespace pcl_spiral
