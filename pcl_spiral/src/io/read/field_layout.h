// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Typed fields of binary point records.
 */
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace pcl_spiral {

/** A number in a record. */
struct FieldType {
  char kind = 'F'; ///< F real, I signed, U unsigned
  int size = 4;    ///< bytes
};

template <typename T>
double
loadAs(const char* at)
{
  T value;
  std::memcpy(&value, at, sizeof(T));
  return static_cast<double>(value);
}

/** The number at \p at, in this computer's byte order unless \p swapped. */
inline double
loadField(const char* at, FieldType type, bool swapped = false)
{
  char bytes[8];
  std::memcpy(bytes, at, static_cast<std::size_t>(type.size));
  if (swapped)
    std::reverse(bytes, bytes + type.size);
  switch (type.kind) {
  case 'F':
    return type.size == 8 ? loadAs<double>(bytes) : loadAs<float>(bytes);
  case 'I':
    return type.size == 1   ? loadAs<std::int8_t>(bytes)
           : type.size == 2 ? loadAs<std::int16_t>(bytes)
           : type.size == 4 ? loadAs<std::int32_t>(bytes)
                            : loadAs<std::int64_t>(bytes);
  default:
    return type.size == 1   ? loadAs<std::uint8_t>(bytes)
           : type.size == 2 ? loadAs<std::uint16_t>(bytes)
           : type.size == 4 ? loadAs<std::uint32_t>(bytes)
                            : loadAs<std::uint64_t>(bytes);
  }
}

} // namespace pcl_spiral
