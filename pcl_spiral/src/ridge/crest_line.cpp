// SPDX-License-Identifier: BSD-3-Clause
#include "crest_line.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;
constexpr double none = -1e30;

/** Curvature of each foot, one row a section, weighted to prefer the crest nearer to the middle. */
class CrestMap {
public:
  CrestMap(const Surface& surface, const ScanSections& sections)
  : width_(static_cast<std::size_t>(2 * sections.most + 1)), values_(sections.feet.size(), none)
  {
    const MlsSurface& fit = surface.fit();
    const double radius = surface.spacing() * std::sqrt(fit.neighbours() / pi);
    const int rim = static_cast<int>(std::ceil(0.5 * radius / sections.step));
    for (std::size_t i = 0; i < sections.size(); ++i) {
      const int right = sections.reach(i, -1), left = sections.reach(i, 1);
      const int low = right < sections.most ? rim - right : -right, high = left < sections.most ? left - rim : left;
      for (int k = low; k <= high; ++k) {
        const double off = static_cast<double>(k) / (sections.most + 1);
        if (sections.foot(i, k).valid)
          values_[sections.slot(i, k)] = sections.foot(i, k).curvature1 * (1.0 - off * off);
      }
    }
  }

  std::size_t width() const { return width_; }
  std::size_t rows() const { return values_.size() / width_; }
  double at(std::size_t row, std::size_t column) const { return values_[row * width_ + column]; }

private:
  std::size_t width_;
  std::vector<double> values_;
};

/** The way of the largest sum from row to row; if \p first is within the row, it begins and ends there. */
std::vector<std::size_t>
bestWay(const CrestMap& map, std::size_t first)
{
  const std::size_t width = map.width(), rows = map.rows();
  std::vector<double> sum(width * rows, none);
  std::vector<std::size_t> from(width * rows, 0);
  for (std::size_t j = 0; j < width; ++j)
    sum[j] = first >= width || j == first ? std::max(map.at(0, j), -1e20) : none;
  for (std::size_t i = 1; i < rows; ++i)
    for (std::size_t j = 0; j < width; ++j) {
      std::size_t best = j;
      for (std::size_t k = j > 0 ? j - 1 : 0; k <= std::min(j + 1, width - 1); ++k)
        if (sum[(i - 1) * width + k] > sum[(i - 1) * width + best])
          best = k;
      from[i * width + j] = best;
      sum[i * width + j] = sum[(i - 1) * width + best] + std::max(map.at(i, j), -1e20);
    }
  const auto last = sum.begin() + static_cast<std::ptrdiff_t>((rows - 1) * width);
  std::vector<std::size_t> way(rows);
  way.back() = static_cast<std::size_t>(std::max_element(last, sum.end()) - last);
  if (first < width)
    way.back() = first;
  for (std::size_t i = rows - 1; i > 0; --i)
    way[i - 1] = from[i * width + way[i]];
  return way;
}

/** The top of the parabola through \p column and its neighbours, in columns from \p column. */
double
topBeside(const CrestMap& map, std::size_t row, std::size_t column)
{
  if (column == 0 || column + 1 == map.width())
    return 0.0;
  const double a = map.at(row, column - 1), b = map.at(row, column), c = map.at(row, column + 1);
  const double bend = a - 2.0 * b + c;
  return std::min(a, c) > 0.5 * none && bend < 0.0 ? std::clamp(0.5 * (a - c) / bend, -1.0, 1.0) : 0.0;
}

} // namespace

Polyline
crestOf(const Surface& surface, const ScanSections& sections, bool closed)
{
  const CrestMap map(surface, sections);
  std::vector<std::size_t> way = bestWay(map, map.width());
  if (closed) // once more, back to where it begins
    way = bestWay(map, way.front());
  Polyline crest;
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (map.at(i, way[i]) < 0.5 * none)
      continue; // the section has no foot there
    const int k = static_cast<int>(way[i]) - sections.most;
    const double off = topBeside(map, i, way[i]);
    const SurfaceFoot& foot = sections.foot(i, k);
    const int beside = std::clamp(k + (off < 0.0 ? -1 : 1), -sections.most, sections.most);
    const SurfaceFoot& next = sections.foot(i, beside);
    crest.push_back(next.valid ? Vector3d(foot.position + std::abs(off) * (next.position - foot.position)) : foot.position);
  }
  return crest;
}

double
bendOf(const ScanSections& sections, std::size_t section, int steps, const Vector3d& tangent)
{
  const Vector3d right = sections.foot(section, -std::min(steps, sections.reach(section, -1))).normal;
  const Vector3d left = sections.foot(section, std::min(steps, sections.reach(section, 1))).normal;
  return std::atan2(left.cross(right).dot(tangent), left.dot(right) - left.dot(tangent) * right.dot(tangent)) * 180.0 / pi;
}

} // namespace pcl_spiral
