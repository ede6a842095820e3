#include "mean_distances.h"

#include <pcl_spiral/search/neighbour_search.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

std::vector<float>
meanDistances(const std::vector<Eigen::Vector3f>& points, int neighbours)
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

} // namespace pcl_spiral
