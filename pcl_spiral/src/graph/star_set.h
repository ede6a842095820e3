// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The stars of all points. Private.
 */
#pragma once

#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Stars in one array: the spokes of point i are in slots begin[i] to begin[i + 1], counter-clockwise about its normal. */
struct StarSet {
  static constexpr std::uint32_t triangle_flag = 0x80000000u; ///< there is a triangle between this spoke and the next
  static constexpr std::uint32_t none = 0xffffffffu;

  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> spokes;

  static std::uint32_t neighbour(std::uint32_t spoke) { return spoke & ~triangle_flag; }
  std::size_t size() const { return begin.size() - 1; }
  bool hasTriangle(std::uint32_t slot) const { return (spokes[slot] & triangle_flag) != 0; }
  std::uint32_t neighbourAt(std::uint32_t slot) const { return neighbour(spokes[slot]); }
  /** The slots next to one of point \p v, counter-clockwise and clockwise. */
  std::uint32_t slotAfter(std::uint32_t v, std::uint32_t slot) const { return slot + 1 == begin[v + 1] ? begin[v] : slot + 1; }
  std::uint32_t slotBefore(std::uint32_t v, std::uint32_t slot) const { return (slot == begin[v] ? begin[v + 1] : slot) - 1; }

  /** The slot of \p v at which its star has the triangle (v, a, b), or none. */
  std::uint32_t slotOf(std::uint32_t v, std::uint32_t a, std::uint32_t b) const;

  /** Reverse the star of point \p i, after its normal was flipped. */
  void reverse(std::size_t i);
};

} // namespace pcl_spiral
