// SPDX-License-Identifier: BSD-3-Clause
#include "neighbour_search.h"

#include "core/lanes.h"
#include "core/simd_clones.h"

#include <array>
#include <cstring>

namespace pcl_spiral {
namespace {

constexpr int bucket_count = 32;
constexpr int few = 96; // values are ranked by comparing all pairs: no branch to predict

std::uint32_t
bitsOf(float value)
{
  std::uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

float
distanceOf(std::uint64_t key)
{
  const auto bits = static_cast<std::uint32_t>(key >> 32);
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

/** How many values come before each one in ascending order; equal ones keep their order. Both arrays are filled up
 *  to whole lanes, \p value with anything. */
PCL_SPIRAL_SIMD_CLONES void
rank(const float* value, int count, std::int32_t* ranks)
{
  const LaneCounts lane = {0, 1, 2, 3, 4, 5, 6, 7};
  for (int begin = 0; begin < count; begin += lane_count) {
    Lanes own;
    load(own, value + begin);
    LaneCounts before = {};
    const int end = begin + lane_count < count ? begin + lane_count : count;
#pragma GCC unroll 4
    for (int j = 0; j < begin; ++j)
      before -= value[j] <= own;
    for (int j = begin; j < end; ++j)
      before -= (value[j] < own) | ((value[j] == own) & (lane > j - begin));
#pragma GCC unroll 4
    for (int j = end; j < count; ++j)
      before -= value[j] < own;
    std::memcpy(ranks + begin, &before, sizeof before);
  }
}

} // namespace

NeighbourSearch::NeighbourSearch(const PointBlocks& blocks, int k, float max_radius) : run_(blocks, k, max_radius)
{
  const auto room = static_cast<std::size_t>(padded(run_.k()));
  for (auto* array : {&x_, &y_, &z_, &squared_distance_})
    array->resize(room);
  index_.resize(room);
}

void
NeighbourSearch::sortPicked(int count)
{
  if (sorted_.size() < run_.room()) {
    for (auto* array : {&sorted_, &rank_})
      array->resize(run_.room());
    near_.resize(run_.room());
  }
  const std::uint32_t* picked = run_.picked();
  if (count > few) {
    sortByBuckets(count);
    return;
  }
  const float* distance = run_.squaredDistances();
  float* near = near_.data();
  for (int i = 0; i < count; ++i)
    near[i] = distance[picked[i]];
  rank(near, count, rank_.data());
  for (int i = 0; i < count; ++i)
    sorted_[rank_[i]] = static_cast<std::int32_t>(picked[i]);
}

void
NeighbourSearch::sortByBuckets(int count)
{
  key_.resize(run_.room());
  sorted_key_.resize(run_.room());
  bucket_.resize(run_.room());
  const std::uint32_t* picked = run_.picked();
  const float* distance = run_.squaredDistances();
  std::uint64_t *key = key_.data(), *sorted = sorted_key_.data();
  std::uint8_t* bucket = bucket_.data();
  float farthest = 0.0f;
  for (int i = 0; i < count; ++i) {
    farthest = std::max(farthest, distance[picked[i]]);
    key[i] = static_cast<std::uint64_t>(bitsOf(distance[picked[i]])) << 32 | picked[i];
  }
  // On a surface squared distances are spread evenly, so buckets of equal width hold about equally many.
  std::array<std::uint32_t, bucket_count + 1> start{};
  const float scale = farthest > 0.0f ? (bucket_count - 0.001f) / farthest : 0.0f;
  for (int i = 0; i < count; ++i) {
    bucket[i] = static_cast<std::uint8_t>(distanceOf(key[i]) * scale);
    ++start[bucket[i] + 1];
  }
  for (int b = 0; b < bucket_count; ++b)
    start[b + 1] += start[b];
  for (int i = 0; i < count; ++i)
    sorted[start[bucket[i]]++] = key[i];
  for (int i = 1; i < count; ++i) {
    const std::uint64_t own = sorted[i];
    int j = i;
    for (; j > 0 && sorted[j - 1] > own; --j)
      sorted[j] = sorted[j - 1];
    sorted[j] = own;
  }
  for (int i = 0; i < count; ++i)
    sorted_[i] = static_cast<std::int32_t>(sorted[i]);
}

const Neighbourhood&
NeighbourSearch::find(const Eigen::Vector3d& query)
{
  const int count = run_.find(query), found = std::min(count, run_.k());
  sortPicked(count);
  for (int i = 0; i < found; ++i) {
    const auto c = static_cast<std::uint32_t>(sorted_[i]);
    x_[i] = run_.offsetX(c);
    y_[i] = run_.offsetY(c);
    z_[i] = run_.offsetZ(c);
    squared_distance_[i] = run_.squaredDistances()[c];
    index_[i] = run_.point(c);
  }
  for (int i = found; i < padded(found); ++i)
    x_[i] = y_[i] = z_[i] = 0.0f;
  if (found > 0)
    run_.learn(squared_distance_[found - 1]);
  result_ = {found, x_.data(), y_.data(), z_.data(), squared_distance_.data(), index_.data()};
  return result_;
}

} // namespace pcl_spiral
