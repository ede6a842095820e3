// SPDX-License-Identifier: BSD-3-Clause
#include "candidate_run.h"

#include "core/lanes.h"
#include "core/simd_clones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace pcl_spiral {
namespace {

/** Write the places of those of four values that are at most \p limit, counted from \p first; returns how many. Always
 *  writes four: no branch depends on the values, which cannot be predicted. */
inline __attribute__((always_inline)) int
pickFour(const float* values, float limit, std::uint32_t first, std::uint32_t* picked)
{
#ifdef __SSE2__
  alignas(16) static constexpr std::int32_t places[16][4] = {
      {0, 0, 0, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {2, 0, 0, 0}, {0, 2, 0, 0}, {1, 2, 0, 0}, {0, 1, 2, 0},
      {3, 0, 0, 0}, {0, 3, 0, 0}, {1, 3, 0, 0}, {0, 1, 3, 0}, {2, 3, 0, 0}, {0, 2, 3, 0}, {1, 2, 3, 0}, {0, 1, 2, 3}};
  static constexpr std::uint8_t counts[16] = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};
  const int inside = _mm_movemask_ps(_mm_cmple_ps(_mm_loadu_ps(values), _mm_set1_ps(limit)));
  const __m128i place = _mm_load_si128(reinterpret_cast<const __m128i*>(places[inside]));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(picked), _mm_add_epi32(place, _mm_set1_epi32(static_cast<int>(first))));
  return counts[inside];
#else
  int count = 0;
  for (std::uint32_t i = 0; i < 4; ++i) {
    picked[count] = first + i;
    count += values[i] <= limit;
  }
  return count;
#endif
}

/** Squared distances of the points from \p q, and which are at most \p limit; returns how many. \p size is a multiple
 *  of eight. */
PCL_SPIRAL_SIMD_CLONES int
pickWithin(const float* x, const float* y, const float* z, int size, const float* q, float limit, float* distance, std::uint32_t* picked)
{
  int count = 0;
  for (int i = 0; i < size; i += lane_count) {
    Lanes dx, dy, dz;
    load(dx, x + i);
    load(dy, y + i);
    load(dz, z + i);
    dx -= q[0];
    dy -= q[1];
    dz -= q[2];
    const Lanes d = dx * dx + dy * dy + dz * dz;
    std::memcpy(distance + i, &d, sizeof d);
    count += pickFour(distance + i, limit, static_cast<std::uint32_t>(i), picked + count);
    count += pickFour(distance + i + 4, limit, static_cast<std::uint32_t>(i) + 4, picked + count);
  }
  return count;
}

constexpr int block_coordinates = 3 * PointBlocks::block_size; // x y z x y z ...

/** Box and origin repeated for every point of a block, so that all its coordinates are handled alike. */
struct BoxPattern {
  std::array<float, block_coordinates> low, high, origin;
};

/** The coordinates of a block relative to the origin, and the squares of how far they lie outside the box. */
PCL_SPIRAL_SIMD_CLONES void
compare(const float* coordinate, int count, const BoxPattern& pattern, float* offset, float* squared_outside)
{
#pragma omp simd
  for (int c = 0; c < count; ++c) {
    const float below = pattern.low[c] - coordinate[c], above = coordinate[c] - pattern.high[c];
    const float most = below > above ? below : above, outside = most > 0.0f ? most : 0.0f;
    offset[c] = coordinate[c] - pattern.origin[c];
    squared_outside[c] = outside * outside;
  }
}

} // namespace

CandidateRun::CandidateRun(const PointBlocks& blocks, int k, float max_radius)
: blocks_(blocks), k_(std::min<int>(k, static_cast<int>(blocks.size()))), max_radius_(max_radius)
{}

float
CandidateRun::firstRadius(const Box& box) const
{
  // For the first query: assume that a block holds 32 points on a patch about as wide as its diagonal.
  const float guess =
      usual_radius_ > 0.0f ? 1.1f * usual_radius_ : 0.12f * std::sqrt(static_cast<float>(k_)) * std::max(box.diagonal(), 1e-12f);
  return std::min(guess, max_radius_);
}

void
CandidateRun::setRun(const Box& box)
{
  constexpr float widest = 64.0f; // in usual blocks
  if (largest_radius_ > 0.0f)
    usual_radius_ = largest_radius_;
  largest_radius_ = 0.0f;
  wide_queries_ = 0;
  stretched_ = box.diagonal() > widest * blocks_.usualDiagonal() && blocks_.usualDiagonal() > 0.0f;
  for (int d = 0; d < 3; ++d)
    origin_[d] = 0.5f * (box.low[d] + box.high[d]);
  if (!stretched_)
    gather(run_, box, firstRadius(box));
}

void
CandidateRun::Candidates::reserve(std::size_t candidates)
{
  if (candidates <= x.size())
    return;
  for (auto* array : {&x, &y, &z})
    array->resize(2 * candidates);
  point.resize(2 * candidates);
}

void
CandidateRun::gather(Candidates& into, const Box& box, float radius)
{
  into.box = box;
  into.radius = radius;
  // Slightly more than asked for: rounding must not leave out what the radius holds.
  const float largest = std::max(std::max({std::abs(box.low[0]), std::abs(box.low[1]), std::abs(box.low[2])}),
                                 std::max({std::abs(box.high[0]), std::abs(box.high[1]), std::abs(box.high[2])}));
  const float generous = 1.0001f * radius + 1e-6f * largest, limit = generous * generous;
  BoxPattern pattern;
  for (int c = 0; c < block_coordinates; ++c) {
    pattern.low[c] = box.low[c % 3];
    pattern.high[c] = box.high[c % 3];
    pattern.origin[c] = origin_[c % 3];
  }
  std::array<float, block_coordinates> offset, squared;
  std::size_t count = 0;
  blocks_.forBlocksNear(box, limit, [&](std::size_t block) {
    into.reserve(count + PointBlocks::block_size + lane_count);
    float *x = into.x.data(), *y = into.y.data(), *z = into.z.data();
    std::uint32_t* point = into.point.data();
    const std::size_t begin = blocks_.blockBegin(block);
    const int coordinates = 3 * static_cast<int>(blocks_.blockEnd(block) - begin);
    compare(blocks_.point(begin).data(), coordinates, pattern, offset.data(), squared.data());
    for (int c = 0; c < coordinates; c += 3) {
      x[count] = offset[c];
      y[count] = offset[c + 1];
      z[count] = offset[c + 2];
      point[count] = static_cast<std::uint32_t>(begin) + static_cast<std::uint32_t>(c / 3);
      count += squared[c] + squared[c + 1] + squared[c + 2] <= limit;
    }
  });
  into.reserve(count + lane_count);
  std::fill_n(into.x.begin() + static_cast<std::ptrdiff_t>(count), lane_count, std::numeric_limits<float>::infinity());
  into.count = count;
  if (distance_.size() < into.x.size()) {
    distance_.resize(into.x.size());
    picked_.resize(into.x.size());
  }
}

int
CandidateRun::pick(const Candidates& from)
{
  looked_at_ = &from;
  const float all = from.radius * from.radius;
  float limit = threshold_ > 0.0f ? std::min(threshold_, all) : all;
  for (;; limit = std::min(all, 1.6f * limit)) {
    const int count = pickWithin(from.x.data(), from.y.data(), from.z.data(), padded(static_cast<int>(from.count)), query_.data(), limit,
                                 distance_.data(), picked_.data());
    if (count >= k_ || limit >= all)
      return count;
  }
}

int
CandidateRun::findAlone(const Eigen::Vector3d& query)
{
  Box box;
  const Eigen::Vector3f position = query.cast<float>();
  box.extend(position.data());
  if (stretched_)
    origin_ = position;
  query_ = (query - origin_.cast<double>()).cast<float>();
  for (float radius = stretched_ ? firstRadius(box) : std::min(1.4f * run_.radius, max_radius_);;
       radius = std::min(1.4f * radius, max_radius_)) {
    gather(alone_, box, radius);
    const int count = pick(alone_);
    if (count >= k_ || radius >= max_radius_)
      return count;
  }
}

int
CandidateRun::find(const Eigen::Vector3d& query)
{
  constexpr float much_farther = 2.0f;
  constexpr int most_wide = 4; // more: the points lie farther apart here
  if (stretched_)
    return findAlone(query);
  query_ = (query - origin_.cast<double>()).cast<float>();
  const int count = pick(run_);
  if (count >= k_ || run_.radius >= max_radius_)
    return count;
  const int found = findAlone(query);
  if (usual_radius_ == 0.0f || alone_.radius <= much_farther * run_.radius || ++wide_queries_ > most_wide) {
    gather(run_, run_.box, alone_.radius); // the others will have to look as far
    return pick(run_);
  }
  return found;
}

void
CandidateRun::learn(float squared_distance)
{
  if (looked_at_ == &alone_ && !stretched_)
    return;
  largest_radius_ = std::max(largest_radius_, std::sqrt(squared_distance));
  threshold_ = 1.25f * squared_distance;
}

} // namespace pcl_spiral
