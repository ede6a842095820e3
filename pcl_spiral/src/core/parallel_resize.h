// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Large arrays made by all threads.
 */
#pragma once

#include <cstddef>
#include <cstdint>

namespace pcl_spiral {

/** \p vector.resize(\p size). The system provides a page of memory when it is first written, which takes longer than writing it: here all
 *  threads do. */
template <typename Vector>
void
resizeInParallel(Vector& vector, std::size_t size)
{
  constexpr std::size_t page = 4096; // bytes
  constexpr std::int64_t few = 64;   // pages
  using Value = typename Vector::value_type;
  vector.reserve(size);
  const std::size_t begin = vector.size() * sizeof(Value), end = size * sizeof(Value);
  const auto pages = end > begin ? static_cast<std::int64_t>((end - begin) / page) : 0;
  auto* const bytes = reinterpret_cast<volatile unsigned char*>(vector.data());
#pragma omp parallel for schedule(static) if (pages > few)
  for (std::int64_t i = 0; i < pages; ++i)
    bytes[begin + static_cast<std::size_t>(i) * page] = 0; // beyond the values: nothing is there yet
  vector.resize(size);
}

} // namespace pcl_spiral
