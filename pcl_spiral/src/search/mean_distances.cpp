// SPDX-License-Identifier: BSD-3-Clause
#include "mean_distances.h"

#include "all_neighbourhoods.h"

#include <omp.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

std::vector<float>
meanDistances(const std::vector<Eigen::Vector3f>& points, int neighbours)
{
  const PointBlocks blocks(points);
  std::vector<float> mean(points.size(), 0.0f);
  forNeighbourhoods(blocks, neighbours + 1, omp_get_max_threads(), [&](std::size_t i, const Neighbourhood& near) {
    double sum = 0.0;
    for (int k = 1; k < near.size; ++k)
      sum += std::sqrt(static_cast<double>(near.squared_distance[k]));
    mean[blocks.originalIndex(i)] = static_cast<float>(sum / std::max(1, near.size - 1));
  });
  return mean;
}

} // namespace pcl_spiral
