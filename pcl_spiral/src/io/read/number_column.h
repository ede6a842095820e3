// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Columns of numbers where they stand in memory: of a file that was read, or of a caller's array.
 */
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <vector>

namespace pcl_spiral {

/** Numbers at equal distances in memory, which belongs to somebody else; they need not be aligned. */
class NumberColumn {
public:
  NumberColumn() = default;
  NumberColumn(const std::vector<double>& values) : NumberColumn(values.data(), sizeof(double), values.size(), false) {}
  /** \p stride: bytes from one number to the next. \p is_single: they are float, else double. */
  NumberColumn(const void* first, std::ptrdiff_t stride, std::size_t size, bool is_single)
  : first_(static_cast<const char*>(first)), stride_(stride), size_(size), is_single_(is_single)
  {}

  std::size_t size() const { return size_; }
  double operator[](std::size_t i) const
  {
    const char* const place = first_ + static_cast<std::ptrdiff_t>(i) * stride_;
    return is_single_ ? static_cast<double>(read<float>(place)) : read<double>(place);
  }

private:
  template <typename Number>
  static Number read(const char* place)
  {
    Number number;
    std::memcpy(&number, place, sizeof number);
    return number;
  }

  const char* first_ = nullptr;
  std::ptrdiff_t stride_ = 0;
  std::size_t size_ = 0;
  bool is_single_ = false;
};

/** x y z, of the same length. */
using PointColumns = std::array<NumberColumn, 3>;

} // namespace pcl_spiral
