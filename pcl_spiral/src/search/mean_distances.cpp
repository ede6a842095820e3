#include "mean_distances.h"

#include "nested_cells.h"

#include <pcl_spiral/search/neighbour_search.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl_spiral {
namespace {

/** Mean distance of each point to its nearest, by a tree of boxes. */
std::vector<float>
meansByBlocks(const std::vector<Eigen::Vector3f>& points, int neighbours)
{
  const PointBlocks blocks(points);
  std::vector<float> mean(points.size(), 0.0f);
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
        mean[blocks.originalIndex(i)] = static_cast<float>(sum / std::max(1, near.size - 1));
      }
    }
  }
  return mean;
}

/** The points about a cell, and the mean distance of a point to its nearest among them. */
class CellSearch {
public:
  CellSearch(const NestedCells& cells, int neighbours) : cells_(cells), k_(static_cast<std::size_t>(neighbours)) {}

  /** Look about \p p, in cells of 2^up times the edge. */
  void
  gather(const IndexedPosition& p, int up)
  {
    up_ = up;
    std::size_t count = 0;
    cells_.forRunsAbout(p, up, [&](const IndexedPosition* first, const IndexedPosition* last) {
      const auto more = static_cast<std::size_t>(last - first);
      for (auto* values : {&x_, &y_, &z_})
        if (values->size() < count + more)
          values->resize(2 * (count + more));
      for (std::size_t i = 0; i < more; ++i, ++count) {
        x_[count] = first[i].x;
        y_[count] = first[i].y;
        z_[count] = first[i].z;
      }
    });
    count_ = count;
    for (auto* values : {&squared_, &chosen_})
      if (values->size() < count + 1)
        values->resize(2 * count + 1);
  }

  /** Mean distance of \p p to its nearest; nothing where some of these may lie farther than was looked. */
  std::optional<float>
  meanDistance(const IndexedPosition& p)
  {
    if (count_ <= k_)
      return std::nullopt;
    const std::size_t n = count_;
    const float *x = x_.data(), *y = y_.data(), *z = z_.data();
    float *squared = squared_.data(), *chosen = chosen_.data();
#pragma omp simd
    for (std::size_t i = 0; i < n; ++i) {
      const float dx = x[i] - p.x, dy = y[i] - p.y, dz = z[i] - p.z;
      squared[i] = dx * dx + dy * dy + dz * dz;
    }
    // Of those about as near as the last point's nearest, if they are enough.
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; ++i) {
      chosen[count] = squared[i];
      count += squared[i] <= expected_;
    }
    if (count <= k_) {
      std::copy(squared, squared + n, chosen);
      count = n;
    }
    float* const kth = chosen + k_;
    std::nth_element(chosen, kth, chosen + count);
    const double sure = 0.9999 * cells_.edge(up_);
    if (*kth > sure * sure && up_ < cells_.highest())
      return std::nullopt;
    expected_ = 1.8f * *kth;
    double sum = 0.0;
    for (std::size_t i = 0; i <= k_; ++i) // the point itself counts nothing
      sum += std::sqrt(chosen[i]);
    return static_cast<float>(sum / static_cast<double>(k_));
  }

private:
  const NestedCells& cells_;
  std::size_t k_, count_ = 0;
  int up_ = 0;
  float expected_ = 0.0f;
  std::vector<float> x_, y_, z_, squared_, chosen_;
};

} // namespace

std::vector<float>
meanDistances(const std::vector<Eigen::Vector3f>& points, int neighbours)
{
  constexpr std::size_t few = 1000;
  const auto k = static_cast<std::size_t>(neighbours);
  if (points.size() < few + k)
    return meansByBlocks(points, neighbours);
  const NestedCells cells(points, k / 3 + 2);
  if (!cells.usable())
    return meansByBlocks(points, neighbours);
  std::vector<float> mean(points.size(), 0.0f);
#pragma omp parallel
  {
    CellSearch search(cells, neighbours), wider(cells, neighbours);
#pragma omp for schedule(dynamic, 64)
    for (std::int64_t c = 0; c < static_cast<std::int64_t>(cells.cellCount()); ++c) {
      search.gather(*cells.begin(c), 0);
      for (const IndexedPosition* p = cells.begin(c); p != cells.end(c); ++p) {
        std::optional<float> found = search.meanDistance(*p);
        for (int up = 1; !found; ++up) {
          wider.gather(*p, up);
          found = wider.meanDistance(*p);
        }
        mean[p->index] = *found;
      }
    }
  }
  return mean;
}

} // namespace pcl_spiral
