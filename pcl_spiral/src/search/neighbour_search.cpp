#include <pcl_spiral/search/neighbour_search.h>

#include <array>
#include <cstring>

namespace pcl_spiral {
namespace {

constexpr std::size_t lane = Neighbourhood::lanes; // arrays are padded to this, so that loops over them have no tail
constexpr int bucket_count = 32;

constexpr std::size_t
padded(std::size_t count)
{
  return (count + lane - 1) / lane * lane;
}

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

} // namespace

NeighbourSearch::NeighbourSearch(const PointBlocks& blocks, int k, float max_radius)
: blocks_(blocks), k_(std::min<int>(k, static_cast<int>(blocks.size()))), max_radius_(max_radius)
{
  const std::size_t room = padded(static_cast<std::size_t>(k_));
  for (auto* array : {&x_, &y_, &z_, &squared_distance_})
    array->resize(room);
  index_.resize(room);
}

void
NeighbourSearch::setRun(const Box& box)
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
NeighbourSearch::reserveCandidates(std::size_t count)
{
  if (count <= candidate_x_.size())
    return;
  for (auto* array : {&candidate_x_, &candidate_y_, &candidate_z_, &candidate_distance_})
    array->resize(2 * count);
  candidate_index_.resize(2 * count);
  near_.resize(2 * count);
}

void
NeighbourSearch::gather(float radius)
{
  gathered_radius_ = radius;
  const float squared_radius = radius * radius;
  const Box box = box_;
  const Eigen::Vector3f origin = origin_;
  std::size_t found = 0;
  blocks_.forBlocksNear(box, squared_radius, [&](std::size_t block) {
    reserveCandidates(found + PointBlocks::block_size + lane);
    float *x = candidate_x_.data(), *y = candidate_y_.data(), *z = candidate_z_.data();
    std::uint32_t* index = candidate_index_.data();
    const std::size_t end = blocks_.blockEnd(block);
    for (std::size_t i = blocks_.blockBegin(block); i < end; ++i) {
      const Eigen::Vector3f p = blocks_.point(i);
      x[found] = p.x() - origin.x();
      y[found] = p.y() - origin.y();
      z[found] = p.z() - origin.z();
      index[found] = static_cast<std::uint32_t>(i);
      found += box.squaredDistance(p.data()) <= squared_radius;
    }
  });
  reserveCandidates(found + lane);
  candidates_ = found;
  for (std::size_t i = candidates_; i < candidates_ + lane; ++i)
    candidate_x_[i] = candidate_y_[i] = candidate_z_[i] = 1e15f;
}

void
NeighbourSearch::measure(const Eigen::Vector3f& query)
{
  const float *x = candidate_x_.data(), *y = candidate_y_.data(), *z = candidate_z_.data();
  float* distance = candidate_distance_.data();
  const float qx = query.x(), qy = query.y(), qz = query.z();
  const std::size_t count = padded(candidates_);
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i) {
    const float dx = x[i] - qx, dy = y[i] - qy, dz = z[i] - qz;
    distance[i] = dx * dx + dy * dy + dz * dz;
  }
}

int
NeighbourSearch::collectWithin(float threshold)
{
  const float* distance = candidate_distance_.data();
  std::uint8_t* near = near_.data();
  const std::size_t count = padded(candidates_);
#pragma omp simd
  for (std::size_t i = 0; i < count; ++i)
    near[i] = distance[i] <= threshold;
  std::uint64_t* key = keys_.data();
  int found = 0;
  for (std::size_t first = 0; first < count; first += lane) {
    std::uint64_t marks; // a byte a candidate
    std::memcpy(&marks, near + first, lane);
    for (; marks != 0; marks &= marks - 1) {
      const std::size_t i = first + static_cast<std::size_t>(__builtin_ctzll(marks)) / 8;
      key[found++] = static_cast<std::uint64_t>(bitsOf(distance[i])) << 32 | i;
    }
  }
  return found;
}

int
NeighbourSearch::select(float squared_radius)
{
  if (keys_.size() < candidates_ + 1) {
    keys_.resize(2 * candidates_ + 64);
    sorted_.resize(keys_.size());
    bucket_.resize(keys_.size());
  }
  float threshold = threshold_ > 0.0f ? std::min(threshold_, squared_radius) : squared_radius;
  int count = collectWithin(threshold);
  while (count < k_ && threshold < squared_radius) {
    threshold = std::min(squared_radius, 1.6f * threshold);
    count = collectWithin(threshold);
  }
  sortSelected(count, threshold);
  return std::min(count, k_);
}

void
NeighbourSearch::sortSelected(int count, float threshold)
{
  // On a surface squared distances are spread evenly, so buckets of equal width hold about equally many.
  std::array<std::uint32_t, bucket_count + 1> start{};
  const float scale = threshold > 0.0f ? (bucket_count - 0.001f) / threshold : 0.0f;
  const std::uint64_t* key = keys_.data();
  std::uint64_t* sorted = sorted_.data();
  std::uint8_t* bucket = bucket_.data();
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
}

const Neighbourhood&
NeighbourSearch::find(const Eigen::Vector3d& query)
{
  const Eigen::Vector3f q = (query - origin_.cast<double>()).cast<float>();
  int found = 0;
  for (;;) {
    measure(q);
    found = select(gathered_radius_ * gathered_radius_);
    if (found == k_ || gathered_radius_ >= max_radius_)
      break;
    gather(std::min(1.4f * gathered_radius_, max_radius_));
  }
  for (int i = 0; i < found; ++i) {
    const auto c = static_cast<std::uint32_t>(sorted_[i]);
    x_[i] = candidate_x_[c] - q.x();
    y_[i] = candidate_y_[c] - q.y();
    z_[i] = candidate_z_[c] - q.z();
    squared_distance_[i] = candidate_distance_[c];
    index_[i] = candidate_index_[c];
  }
  for (std::size_t i = found; i < padded(found); ++i)
    x_[i] = y_[i] = z_[i] = 0.0f;
  if (found > 0) {
    usual_radius_ = std::max(usual_radius_, std::sqrt(squared_distance_[found - 1]));
    threshold_ = 1.35f * squared_distance_[found - 1];
  }
  result_ = {found, x_.data(), y_.data(), z_.data(), squared_distance_.data(), index_.data()};
  return result_;
}

} // namespace pcl_spiral
