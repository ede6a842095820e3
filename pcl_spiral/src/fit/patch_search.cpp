// SPDX-License-Identifier: BSD-3-Clause
#include "patch_search.h"

#include "core/lanes.h"
#include "core/simd_clones.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr int inner_points = 12;

/** The \p k-th smallest of the values, by counting; \p most is the largest. Padded with ones above it. */
PCL_SPIRAL_SIMD_CLONES float
kthSmallest(const float* values, int size, int k, float most)
{
  const int whole = padded(size);
  float low = 0.0f, high = most;
  int below = 0, above = size;
  for (int round = 1; above > k; ++round) {
    // Squared distances on a surface are spread evenly; every third step takes the middle, in case they are not.
    const float share = round % 3 ? static_cast<float>(k - below) / static_cast<float>(above - below) : 0.5f;
    float t = low + share * (high - low);
    if (!(t > low && t < high))
      t = 0.5f * (low + high);
    if (!(t > low && t < high))
      return high; // equal values
    LaneCounts counts = {};
    for (int i = 0; i < whole; i += lane_count) {
      Lanes v;
      load(v, values + i);
      counts -= v <= t;
    }
    const int count = sum(counts);
    if (count >= k) {
      high = t;
      above = count;
    }
    else {
      low = t;
      below = count;
    }
  }
  Lanes largest = {};
  for (int i = 0; i < whole; i += lane_count) {
    Lanes v;
    load(v, values + i);
    v = v <= high ? v : Lanes{};
    largest = v > largest ? v : largest;
  }
  float kth = 0.0f;
  for (int l = 0; l < lane_count; ++l)
    kth = largest[l] > kth ? largest[l] : kth;
  return kth;
}

} // namespace

PatchSearch::PatchSearch(const PointBlocks& blocks, int k, float max_radius) : run_(blocks, k, max_radius) {}

const Patch&
PatchSearch::find(const Eigen::Vector3d& query)
{
  result_ = Patch();
  const int count = run_.find(query), k = run_.k();
  if (count == 0)
    return result_;
  if (distance_.size() < run_.room()) {
    for (auto* array : {&distance_, &x_, &y_, &z_})
      array->resize(run_.room());
    inner_.resize(run_.room());
  }
  const std::uint32_t* picked = run_.picked();
  const float* all = run_.squaredDistances();
  float* distance = distance_.data();
  float least = std::numeric_limits<float>::max(), most = 0.0f;
  for (int i = 0; i < count; ++i) {
    distance[i] = all[picked[i]];
    least = distance[i] < least ? distance[i] : least;
    most = distance[i] > most ? distance[i] : most;
  }
  std::fill_n(distance + count, lane_count, std::numeric_limits<float>::max());
  const float bound = count > k ? kthSmallest(distance, count, k, most) : most;
  const float inner_bound = least + (bound - least) * inner_points / static_cast<float>(std::min(count, k));
  float *x = x_.data(), *y = y_.data(), *z = z_.data();
  std::uint32_t* inner = inner_.data();
  int size = 0, inner_size = 0, nearest = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint32_t c = picked[i];
    const float d = distance[i];
    x[size] = run_.offsetX(c);
    y[size] = run_.offsetY(c);
    z[size] = run_.offsetZ(c);
    inner[inner_size] = run_.point(c);
    nearest = d == least ? i : nearest;
    size += d <= bound;
    inner_size += d <= inner_bound;
  }
  for (float* array : {x, y, z})
    std::fill_n(array + size, lane_count, 0.0f);
  run_.learn(bound);
  result_ = {size, x, y, z, bound, inner_size, inner, run_.point(picked[nearest]), least};
  return result_;
}

} // namespace pcl_spiral
