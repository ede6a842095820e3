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
  Eigen::Vector3d middle;
  double half_length;
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
  std::vector<Entry> entries(segments);
  for (std::size_t i = 0; i < segments; ++i) {
    const Eigen::Vector3d middle = 0.5 * (path[i] + path[i + 1]);
    Cell cell;
    for (int axis = 0; axis < 3; ++axis)
      cell[axis] = static_cast<std::int64_t>(std::floor(middle[axis] / longest));
    entries[i] = {cell, i, middle, 0.5 * (path[i + 1] - path[i]).norm()};
  }
  std::stable_sort(entries.begin(), entries.end());
  std::vector<std::size_t> cells; // where each begins
  for (std::size_t e = 0; e < segments; ++e)
    if (e == 0 || entries[e - 1].cell != entries[e].cell)
      cells.push_back(e);
  cells.push_back(segments);

  std::size_t first = std::numeric_limits<std::size_t>::max();
  const auto count = static_cast<std::int64_t>(cells.size()) - 1;
#pragma omp parallel for schedule(dynamic, 128) reduction(min : first)
  for (std::int64_t c = 0; c < count; ++c) {
    const Cell own = entries[cells[c]].cell;
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const Entry low{{own[0] + dx, own[1] + dy, own[2] - 1}, 0, {}, 0.0};
        const Entry high{{own[0] + dx, own[1] + dy, own[2] + 1}, 0, {}, 0.0};
        const auto begin = std::lower_bound(entries.begin(), entries.end(), low);
        const auto end = std::upper_bound(begin, entries.end(), high);
        for (std::size_t k = cells[c]; k < cells[c + 1]; ++k) {
          const Entry& one = entries[k];
          for (auto other = begin; other != end; ++other) {
            const double reach = one.half_length + other->half_length;
            if (other->segment > one.segment + 1 && (other->middle - one.middle).squaredNorm() <= reach * reach &&
                cross(path, one.segment, other->segment, normals[one.segment], slack))
              first = std::min(first, one.segment);
          }
        }
      }
  }
  return first < segments ? std::optional<std::size_t>(first) : std::nullopt;
}

} // namespace pcl_spiral
