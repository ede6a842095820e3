#include <pcl_spiral/search/neighbour_search.h>

#include <cstring>

namespace pcl_spiral {
namespace {

constexpr std::size_t lane = 8; // candidates are padded to this, so that the distance loop has no tail
constexpr int bucket_count = 64;

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
  const std::size_t room = static_cast<std::size_t>(k_) + 1;
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
NeighbourSearch::gather(float radius)
{
  gathered_radius_ = radius;
  candidates_ = 0;
  const float squared_radius = radius * radius;
  blocks_.forBlocksNear(box_, squared_radius, [&](std::size_t block) {
    const std::size_t needed = candidates_ + PointBlocks::block_size + lane;
    if (needed > candidate_x_.size()) {
      for (auto* array : {&candidate_x_, &candidate_y_, &candidate_z_, &candidate_distance_})
        array->resize(2 * needed);
      candidate_index_.resize(2 * needed);
    }
    for (std::size_t i = blocks_.blockBegin(block); i < blocks_.blockEnd(block); ++i) {
      const Eigen::Vector3f& p = blocks_.point(i);
      candidate_x_[candidates_] = p.x() - origin_.x();
      candidate_y_[candidates_] = p.y() - origin_.y();
      candidate_z_[candidates_] = p.z() - origin_.z();
      candidate_index_[candidates_] = static_cast<std::uint32_t>(i);
      candidates_ += box_.squaredDistance(p.data()) <= squared_radius;
    }
  });
  if (candidate_x_.size() < candidates_ + lane) {
    for (auto* array : {&candidate_x_, &candidate_y_, &candidate_z_, &candidate_distance_})
      array->resize(candidates_ + lane);
    candidate_index_.resize(candidates_ + lane);
  }
  for (std::size_t i = candidates_; i < candidates_ + lane; ++i)
    candidate_x_[i] = candidate_y_[i] = candidate_z_[i] = 1e15f;
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
  int count = 0;
  for (;;) {
    count = 0;
    for (std::size_t i = 0; i < candidates_; ++i) {
      keys_[count] = static_cast<std::uint64_t>(bitsOf(candidate_distance_[i])) << 32 | i;
      count += candidate_distance_[i] <= threshold;
    }
    if (count >= k_ || threshold >= squared_radius)
      break;
    threshold = std::min(squared_radius, 1.6f * threshold);
  }
  sortSelected(count, threshold);
  return std::min(count, k_);
}

void
NeighbourSearch::sortSelected(int count, float threshold)
{
  // On a surface squared distances are spread evenly, so buckets of equal width hold about equally many.
  std::uint32_t start[bucket_count + 1] = {};
  const float scale = threshold > 0.0f ? (bucket_count - 0.001f) / threshold : 0.0f;
  for (int i = 0; i < count; ++i) {
    bucket_[i] = static_cast<std::uint8_t>(distanceOf(keys_[i]) * scale);
    ++start[bucket_[i] + 1];
  }
  for (int b = 0; b < bucket_count; ++b)
    start[b + 1] += start[b];
  for (int i = 0; i < count; ++i)
    sorted_[start[bucket_[i]]++] = keys_[i];
  for (int i = 1; i < count; ++i) {
    const std::uint64_t key = sorted_[i];
    int j = i;
    for (; j > 0 && sorted_[j - 1] > key; --j)
      sorted_[j] = sorted_[j - 1];
    sorted_[j] = key;
  }
}

const Neighbourhood&
NeighbourSearch::find(const Eigen::Vector3d& query)
{
  const Eigen::Vector3f q = (query - origin_.cast<double>()).cast<float>();
  int found = 0;
  for (;;) {
    const std::size_t padded = (candidates_ + lane - 1) / lane * lane;
    const float *cx = candidate_x_.data(), *cy = candidate_y_.data(), *cz = candidate_z_.data();
    float* distance = candidate_distance_.data();
#pragma omp simd
    for (std::size_t i = 0; i < padded; ++i) {
      const float dx = cx[i] - q.x(), dy = cy[i] - q.y(), dz = cz[i] - q.z();
      distance[i] = dx * dx + dy * dy + dz * dz;
    }
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
  if (found > 0) {
    usual_radius_ = std::max(usual_radius_, std::sqrt(squared_distance_[found - 1]));
    threshold_ = 1.35f * squared_distance_[found - 1];
  }
  result_ = {found, x_.data(), y_.data(), z_.data(), squared_distance_.data(), index_.data()};
  return result_;
}

} // namespace pcl_spiral
