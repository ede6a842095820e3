// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Eight floats at a time.
 */
#pragma once

#include <cstring>

namespace pcl_spiral {

/** Two SSE registers, or one of AVX. Sums over lanes have the same order on both, and the same bits. */
using Lanes = float __attribute__((vector_size(32)));
using LaneCounts = int __attribute__((vector_size(32)));

constexpr int lane_count = 8;

/** Number of entries when the last lanes are filled up. */
constexpr int
padded(int size)
{
  return (size + lane_count - 1) / lane_count * lane_count;
}

// Passed by reference: the compiler prints a note on the ABI if such types are passed by value.
inline __attribute__((always_inline)) void
load(Lanes& lanes, const float* from)
{
  std::memcpy(&lanes, from, sizeof lanes);
}

template <typename Vector>
inline __attribute__((always_inline)) auto
sum(const Vector& v)
{
  return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
}

} // namespace pcl_spiral
