#include <pcl_spiral/search/candidate_run.h>

#include <pcl_spiral/core/lanes.h>
#include <pcl_spiral/core/simd_clones.h>

#include <algorithm>
#include <cmath>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace pcl_spiral {
namespace {

/** Write the places of those of four values that are at most \p limit, counted from \p first; returns how many. Always
 *  writes four: no branch depends on the values, which are as likely in as out. */
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
pickWithin(const float* x, const float* y, const float* z, int size, const float* q, float limit, float* distance,
           std::uint32_t* picked)
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

/** How far a coordinate lies outside an interval. */
float
outside(float low, float value, float high)
{
  const float below = low - value, above = value - high, most = below > above ? below : above;
  return most > 0.0f ? most : 0.0f;
}

} // namespace

CandidateRun::CandidateRun(const PointBlocks& blocks, int k, float max_radius)
: blocks_(blocks), k_(std::min<int>(k, static_cast<int>(blocks.size()))), max_radius_(max_radius)
{
}

void
CandidateRun::setRun(const Box& box)
{
  box_ = box;
  for (int d = 0; d < 3; ++d)
    origin_[d] = 0.5f * (box.low[d] + box.high[d]);
  // Without experience: a block holds 32 points on a patch about as wide as its diagonal.
  const float guess = usual_radius_ > 0.0f
                          ? 1.1f * usual_radius_
                          : 0.12f * std::sqrt(static_cast<float>(k_)) * std::max(box.diagonal(), 1e-12f);
  gather(std::min(guess, max_radius_));
  usual_radius_ = 0.0f;
}

void
CandidateRun::reserve(std::size_t candidates)
{
  if (candidates <= x_.size())
    return;
  for (auto* array : {&x_, &y_, &z_, &distance_})
    array->resize(2 * candidates);
  for (auto* array : {&point_, &picked_})
    array->resize(2 * candidates);
}

void
CandidateRun::gather(float radius)
{
  gathered_radius_ = radius;
  const float limit = radius * radius;
  const Box box = box_;
  const Eigen::Vector3f origin = origin_;
  std::size_t count = 0;
  blocks_.forBlocksNear(box, limit, [&](std::size_t block) {
    reserve(count + PointBlocks::block_size + lane_count);
    float *x = x_.data(), *y = y_.data(), *z = z_.data();
    std::uint32_t* point = point_.data();
    const std::size_t end = blocks_.blockEnd(block);
    for (std::size_t i = blocks_.blockBegin(block); i < end; ++i) {
      const Eigen::Vector3f& p = blocks_.point(i);
      const float dx = outside(box.low[0], p[0], box.high[0]), dy = outside(box.low[1], p[1], box.high[1]);
      const float dz = outside(box.low[2], p[2], box.high[2]);
      x[count] = p[0] - origin[0];
      y[count] = p[1] - origin[1];
      z[count] = p[2] - origin[2];
      point[count] = static_cast<std::uint32_t>(i);
      count += dx * dx + dy * dy + dz * dz <= limit;
    }
  });
  reserve(count + lane_count);
  std::fill_n(x_.begin() + static_cast<std::ptrdiff_t>(count), lane_count, 1e15f); // nothing picks these
  candidates_ = count;
}

int
CandidateRun::pick()
{
  const float all = gathered_radius_ * gathered_radius_;
  float limit = threshold_ > 0.0f ? std::min(threshold_, all) : all;
  for (;; limit = std::min(all, 1.6f * limit)) {
    const int count = pickWithin(x_.data(), y_.data(), z_.data(), padded(static_cast<int>(candidates_)), query_.data(),
                                 limit, distance_.data(), picked_.data());
    if (count >= k_ || limit >= all)
      return count;
  }
}

int
CandidateRun::find(const Eigen::Vector3d& query)
{
  query_ = (query - origin_.cast<double>()).cast<float>();
  int count = pick();
  while (count < k_ && gathered_radius_ < max_radius_) {
    gather(std::min(1.4f * gathered_radius_, max_radius_));
    count = pick();
  }
  return count;
}

void
CandidateRun::learn(float squared_distance)
{
  usual_radius_ = std::max(usual_radius_, std::sqrt(squared_distance));
  threshold_ = 1.25f * squared_distance;
}

} // namespace pcl_spiral
