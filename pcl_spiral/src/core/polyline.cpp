// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/polyline.h>

#include <algorithm>
#include <cstdint>

namespace pcl_spiral {
namespace {

constexpr std::int64_t alone = 4096; // so many moves take less time than a team of threads

} // namespace

std::vector<double>
arcLengths(const Polyline& line, bool closed)
{
  const std::size_t n = line.size();
  if (n == 0)
    return {};
  std::vector<double> s(closed ? n + 1 : n, 0.0);
  const auto moves = static_cast<std::int64_t>(s.size()) - 1;
#pragma omp parallel for schedule(static) if (moves > alone)
  for (std::int64_t i = 0; i < moves; ++i)
    s[i + 1] = (line[(i + 1) % n] - line[i]).norm();
  for (std::size_t i = 1; i < s.size(); ++i)
    s[i] += s[i - 1];
  return s;
}

double
length(const Polyline& line, bool closed)
{
  const std::vector<double> s = arcLengths(line, closed);
  return s.empty() ? 0.0 : s.back();
}

Polyline
resampled(const Polyline& line, std::size_t count, bool closed)
{
  if (line.size() < 2 || count < 2)
    return line;
  const std::vector<double> s = arcLengths(line, closed);
  const double step = s.back() / static_cast<double>(closed ? count : count - 1);
  Polyline result(count);
  std::size_t j = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double at = step * static_cast<double>(i);
    while (j + 2 < s.size() && s[j + 1] < at)
      ++j;
    const double ds = s[j + 1] - s[j];
    const double f = ds > 0.0 ? std::min(1.0, (at - s[j]) / ds) : 0.0;
    result[i] = (1.0 - f) * line[j] + f * line[(j + 1) % line.size()];
  }
  if (!closed)
    result.back() = line.back();
  return result;
}

} // namespace pcl_spiral
