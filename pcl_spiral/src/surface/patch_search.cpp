#include "patch_search.h"

#include "lanes.h"

#include <pcl_spiral/core/simd_clones.h>

#include <algorithm>
#include <cmath>
#include <limits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace pcl_spiral {
namespace {

constexpr int inner_points = 12;

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

/** The \p k-th smallest of the values, by counting; \p most is the largest. Padded with ones above it. */
PCL_SPIRAL_SIMD_CLONES float
kthSmallest(const float* values, int size, int k, float most)
{
  const int whole = padded(size);
  float low = 0.0f, high = most;
  int below = 0, above = size;
  for (int round = 1; above > k; ++round) {
    // Squared distances on a surface are spread evenly; now and then the middle, for where they are not.
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

/** How far a coordinate lies outside an interval. */
float
outside(float low, float value, float high)
{
  const float below = low - value, above = value - high, most = below > above ? below : above;
  return most > 0.0f ? most : 0.0f;
}

} // namespace

PatchSearch::PatchSearch(const PointBlocks& blocks, int k, float max_radius)
: blocks_(blocks), k_(std::min<int>(k, static_cast<int>(blocks.size()))), max_radius_(max_radius)
{
}

void
PatchSearch::setRun(const Box& box)
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
PatchSearch::gather(float radius)
{
  gathered_radius_ = radius;
  candidates_ = 0;
  const float limit = radius * radius;
  const Box box = box_;
  const Eigen::Vector3f origin = origin_;
  blocks_.forBlocksNear(box_, limit, [&](std::size_t block) {
    const std::size_t needed = candidates_ + PointBlocks::block_size + lane_count;
    if (needed > candidate_x_.size()) {
      for (auto* array : {&candidate_x_, &candidate_y_, &candidate_z_, &candidate_distance_})
        array->resize(2 * needed);
      candidate_index_.resize(2 * needed);
    }
    float *x = candidate_x_.data(), *y = candidate_y_.data(), *z = candidate_z_.data();
    std::uint32_t* index = candidate_index_.data();
    int count = candidates_;
    for (std::size_t i = blocks_.blockBegin(block); i < blocks_.blockEnd(block); ++i) {
      const Eigen::Vector3f& p = blocks_.point(i);
      const float dx = outside(box.low[0], p[0], box.high[0]), dy = outside(box.low[1], p[1], box.high[1]);
      const float dz = outside(box.low[2], p[2], box.high[2]);
      x[count] = p[0] - origin[0];
      y[count] = p[1] - origin[1];
      z[count] = p[2] - origin[2];
      index[count] = static_cast<std::uint32_t>(i);
      count += dx * dx + dy * dy + dz * dz <= limit;
    }
    candidates_ = count;
  });
  const std::size_t room = candidates_ + lane_count;
  if (candidate_x_.size() < room) {
    for (auto* array : {&candidate_x_, &candidate_y_, &candidate_z_, &candidate_distance_})
      array->resize(room);
    candidate_index_.resize(room);
  }
  std::fill_n(candidate_x_.begin() + candidates_, lane_count, 1e15f);
  if (near_.size() < room) {
    for (auto* array : {&near_distance_, &x_, &y_, &z_})
      array->resize(2 * room);
    for (auto* array : {&near_, &inner_})
      array->resize(2 * room);
  }
}

int
PatchSearch::pick(const Eigen::Vector3f& query)
{
  const float all = gathered_radius_ * gathered_radius_;
  float limit = threshold_ > 0.0f ? std::min(threshold_, all) : all;
  for (;; limit = std::min(all, 1.6f * limit)) {
    const int count = pickWithin(candidate_x_.data(), candidate_y_.data(), candidate_z_.data(), padded(candidates_),
                                 query.data(), limit, candidate_distance_.data(), near_.data());
    if (count >= k_ || limit >= all)
      return count;
  }
}

void
PatchSearch::collect(int count, const Eigen::Vector3f& query)
{
  result_ = Patch();
  if (count == 0)
    return;
  float* distance = near_distance_.data();
  float least = std::numeric_limits<float>::max(), most = 0.0f;
  for (int i = 0; i < count; ++i) {
    distance[i] = candidate_distance_[near_[i]];
    least = distance[i] < least ? distance[i] : least;
    most = distance[i] > most ? distance[i] : most;
  }
  std::fill_n(distance + count, lane_count, std::numeric_limits<float>::max());
  const float bound = count > k_ ? kthSmallest(distance, count, k_, most) : most;
  const float inner_bound = least + (bound - least) * inner_points / static_cast<float>(std::max(1, std::min(count, k_)));
  const std::uint32_t *near = near_.data(), *id = candidate_index_.data();
  const float *cx = candidate_x_.data(), *cy = candidate_y_.data(), *cz = candidate_z_.data();
  const float qx = query.x(), qy = query.y(), qz = query.z();
  float *x = x_.data(), *y = y_.data(), *z = z_.data();
  std::uint32_t* inner = inner_.data();
  int size = 0, inner_size = 0, nearest = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint32_t c = near[i];
    const float d = distance[i];
    x[size] = cx[c] - qx;
    y[size] = cy[c] - qy;
    z[size] = cz[c] - qz;
    inner[inner_size] = id[c];
    nearest = d == least ? i : nearest;
    size += d <= bound;
    inner_size += d <= inner_bound;
  }
  for (float* array : {x, y, z})
    std::fill_n(array + size, lane_count, 0.0f);
  result_ = {size, x, y, z, bound, inner_size, inner, id[near[nearest]], least};
}

const Patch&
PatchSearch::find(const Eigen::Vector3d& query)
{
  const Eigen::Vector3f q = (query - origin_.cast<double>()).cast<float>();
  int count = pick(q);
  while (count < k_ && gathered_radius_ < max_radius_) {
    gather(std::min(1.4f * gathered_radius_, max_radius_));
    count = pick(q);
  }
  collect(count, q);
  if (count > 0) {
    usual_radius_ = std::max(usual_radius_, std::sqrt(result_.squared_radius));
    threshold_ = 1.25f * result_.squared_radius;
  }
  return result_;
}

} // namespace pcl_spiral
