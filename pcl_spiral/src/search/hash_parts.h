// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Points grouped by a hash, so that equal ones can be found in small parts, in parallel. Private.
 */
#pragma once

#include <pcl_spiral/search/impl/point_blocks.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Spread the bits of a key over all of them (the finaliser of SplitMix64; Steele, Lea, Flood 2014). */
inline std::uint64_t
mixed(std::uint64_t key)
{
  key = (key ^ key >> 30) * 0xbf58476d1ce4e5b9u;
  key = (key ^ key >> 27) * 0x94d049bb133111ebu;
  return key ^ key >> 31;
}

/** Points in parts by the upper bits of a hash of their position, in their order within each part. Equal keys share a
 *  part, which is small enough to stay in the cache. Independent of the number of threads. */
class HashParts {
public:
  template <typename Hash>
  HashParts(const std::vector<Eigen::Vector3f>& points, Hash hash) : points_(points.size())
  {
    constexpr std::size_t wanted = std::size_t(1) << 15, chunks = 64;
    const std::size_t n = points.size();
    int bits = 0;
    while (bits < 10 && (n >> bits) > wanted)
      ++bits;
    const std::size_t parts = std::size_t(1) << bits;
    const auto partOf = [&](std::size_t i) { return bits ? hash(points[i]) >> (64 - bits) : 0; };
    std::vector<std::size_t> place(chunks * parts, 0);
#pragma omp parallel for schedule(static)
    for (std::int64_t c = 0; c < static_cast<std::int64_t>(chunks); ++c)
      for (std::size_t i = n * c / chunks; i < n * (c + 1) / chunks; ++i)
        ++place[c * parts + partOf(i)];
    begin_.assign(1, 0);
    for (std::size_t p = 0; p < parts; ++p) {
      std::size_t at = begin_.back();
      for (std::size_t c = 0; c < chunks; ++c) {
        const std::size_t count = place[c * parts + p];
        place[c * parts + p] = at;
        at += count;
      }
      begin_.push_back(at);
    }
#pragma omp parallel for schedule(static)
    for (std::int64_t c = 0; c < static_cast<std::int64_t>(chunks); ++c)
      for (std::size_t i = n * c / chunks; i < n * (c + 1) / chunks; ++i)
        points_[place[c * parts + partOf(i)]++] = {points[i].x(), points[i].y(), points[i].z(), static_cast<std::uint32_t>(i)};
  }

  std::size_t count() const
  {
    return begin_.size() - 1;
  }
  const IndexedPosition* begin(std::size_t part) const
  {
    return points_.data() + begin_[part];
  }
  const IndexedPosition* end(std::size_t part) const
  {
    return points_.data() + begin_[part + 1];
  }

private:
  std::vector<IndexedPosition> points_;
  std::vector<std::size_t> begin_;
};

/** Numbers of the different keys of one part, in the order of their first appearance: open addressing. */
class KeyTable {
public:
  static constexpr std::uint32_t none = 0xffffffffu;

  void reset(std::size_t most_keys)
  {
    std::size_t size = 16;
    while (size < 2 * most_keys)
      size *= 2;
    slots_.assign(size, 0);
    keys_ = 0;
  }
  /** The number of the key with \p hash for which isSame(number) holds. If there is none, a new one: the count so far. */
  template <typename IsSame>
  std::uint32_t number(std::uint64_t hash, IsSame isSame)
  {
    const std::size_t mask = slots_.size() - 1;
    std::size_t slot = hash & mask;
    for (; slots_[slot] != 0; slot = (slot + 1) & mask)
      if (isSame(slots_[slot] - 1))
        return slots_[slot] - 1;
    slots_[slot] = ++keys_;
    return keys_ - 1;
  }
  /** The same, or none. */
  template <typename IsSame>
  std::uint32_t find(std::uint64_t hash, IsSame isSame) const
  {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = hash & mask; slots_[slot] != 0; slot = (slot + 1) & mask)
      if (isSame(slots_[slot] - 1))
        return slots_[slot] - 1;
    return none;
  }

private:
  std::vector<std::uint32_t> slots_; ///< number + 1, or 0 when empty
  std::uint32_t keys_ = 0;
};

} // namespace pcl_spiral
