#include <pcl_spiral/core/self_crossing.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl_spiral {
namespace {

using Cell = std::array<std::int64_t, 3>;

struct Entry {
  Cell cell;
  std::size_t segment;
  bool operator<(const Entry& other) const { return cell < other.cell; }
};

/** Distance of \p c from the line a b, seen along \p n; positive on its left. */
double
sideOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& n)
{
  const double chord = (b - a).norm();
  return chord > 0.0 ? (b - a).cross(c - a).dot(n) / chord : 0.0;
}

bool
apart(double one, double other, double slack)
{
  return one * other < 0.0 && std::min(std::abs(one), std::abs(other)) > slack;
}

bool
cross(const Polyline& p, std::size_t i, std::size_t j, const Eigen::Vector3d& n, double slack)
{
  return apart(sideOf(p[i], p[i + 1], p[j], n), sideOf(p[i], p[i + 1], p[j + 1], n), slack) &&
         apart(sideOf(p[j], p[j + 1], p[i], n), sideOf(p[j], p[j + 1], p[i + 1], n), slack);
}

} // namespace

std::optional<std::size_t>
firstSelfCrossing(const Polyline& path, const std::vector<Eigen::Vector3d>& normals, double slack)
{
  if (path.size() < 4)
    return std::nullopt;
  const std::size_t segments = path.size() - 1;
  double longest = 0.0;
  for (std::size_t i = 0; i < segments; ++i)
    longest = std::max(longest, (path[i + 1] - path[i]).norm());
  if (!(longest > 0.0))
    return std::nullopt;
  const auto cellOf = [&](std::size_t i) {
    const Eigen::Vector3d middle = 0.5 * (path[i] + path[i + 1]) / longest;
    return Cell{std::int64_t(std::floor(middle.x())), std::int64_t(std::floor(middle.y())),
                std::int64_t(std::floor(middle.z()))};
  };
  std::vector<Entry> entries(segments);
  for (std::size_t i = 0; i < segments; ++i)
    entries[i] = {cellOf(i), i};
  std::stable_sort(entries.begin(), entries.end());

  std::size_t first = std::numeric_limits<std::size_t>::max();
  const auto count = static_cast<std::int64_t>(segments);
#pragma omp parallel for schedule(dynamic, 512) reduction(min : first)
  for (std::int64_t s = 0; s < count; ++s) {
    const auto i = static_cast<std::size_t>(s);
    const Cell own = cellOf(i);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const Entry low{{own[0] + dx, own[1] + dy, own[2] - 1}, 0}, high{{own[0] + dx, own[1] + dy, own[2] + 1}, 0};
        const auto begin = std::lower_bound(entries.begin(), entries.end(), low);
        const auto end = std::upper_bound(begin, entries.end(), high);
        for (auto e = begin; e != end; ++e)
          if (e->segment > i + 1 && cross(path, i, e->segment, normals[i], slack))
            first = std::min(first, i);
      }
  }
  return first < segments ? std::optional<std::size_t>(first) : std::nullopt;
}

} // namespace pcl_spiral
