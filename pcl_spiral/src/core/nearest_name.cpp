// SPDX-License-Identifier: BSD-3-Clause
#include "nearest_name.h"

#include <algorithm>
#include <numeric>

namespace pcl_spiral {
namespace {

/** Least number of letters to change, add or drop (Levenshtein 1966). */
std::size_t
editDistance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

} // namespace

std::string
nearestName(const std::string& name, const std::vector<std::string>& names)
{
  std::string nearest;
  std::size_t least = std::max<std::size_t>(3, name.size() / 2);
  for (const std::string& one : names) {
    const bool begins = name.size() >= 3 && one.rfind(name, 0) == 0;
    const std::size_t distance = begins ? 0 : editDistance(name, one);
    if (distance < least) {
      least = distance;
      nearest = one;
    }
  }
  return nearest;
}

} // namespace pcl_spiral
