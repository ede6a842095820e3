/** \file
 *  Numbers with a fixed count of decimals, fast.
 */
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace pcl_spiral {

/** Room that one number can take: the largest double has 309 digits before the point. */
constexpr int fixed_point_room = 340;

/** Write \p value with \p Decimals decimals at \p out and return the end. Rounds half away from zero; within
 * one unit in the last place of a double times 10^Decimals this is what printf writes, at a twentieth of its
 * time. Values beyond 9e15 10^-Decimals, infinities and not-a-number go through std::to_chars. Zero has no
 * sign. */
template <int Decimals>
char*
writeFixed(char* out, double value)
{
  static_assert(Decimals > 0 && Decimals <= 9, "scale must be exact");
  constexpr std::array<double, 10> powers{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
  const double scaled = std::abs(value) * powers[Decimals];
  if (!(scaled < 9e15))
    return std::to_chars(out, out + fixed_point_room, value, std::chars_format::fixed, Decimals).ptr;
  auto units = static_cast<std::uint64_t>(scaled + 0.5);
  if (value < 0.0 && units != 0)
    *out++ = '-';
  char digits[24];
  char* first = digits + sizeof(digits);
  for (int i = 0; i < Decimals; ++i, units /= 10)
    *--first = static_cast<char>('0' + units % 10);
  *--first = '.';
  do {
    *--first = static_cast<char>('0' + units % 10);
    units /= 10;
  } while (units != 0);
  while (first != digits + sizeof(digits))
    *out++ = *first++;
  return out;
}

} // namespace pcl_spiral
