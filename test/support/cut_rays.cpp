// SPDX-License-Identifier: BSD-3-Clause
#include "support/cut_rays.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral::test {

using Eigen::Vector3d;

double
RoundedCutter::distance(const TipAndAxis& place, const Vector3d& q) const
{
  const Vector3d from_tip = q - place.tip;
  const double along = from_tip.dot(place.axis);
  const double across = (from_tip - along * place.axis).norm() - (radius - corner);
  const double beyond = std::max({corner - along, along - (length - corner), 0.0});
  return std::hypot(std::max(across, 0.0), beyond) - corner;
}

CutRays::CutRays(const AnalyticSurface& surface, double spacing, double deepest, double reach)
: deepest_(deepest), lower_(surface.region().lower()), columns_(static_cast<int>((surface.region().upper().x() - lower_.x()) / cell) + 1),
  rows_(static_cast<int>((surface.region().upper().y() - lower_.y()) / cell) + 1), cells_(static_cast<std::size_t>(columns_) * rows_)
{
  constexpr double golden = 0.6180339887498949; // of a spacing from row to row: no line of rays follows a ridge
  double shift = 0.0;
  for (double v = lower_.y() + 0.5 * spacing; v < surface.region().upper().y(); v += spacing) {
    shift = std::fmod(shift + golden, 1.0);
    for (double u = lower_.x() + shift * spacing; u < surface.region().upper().x(); u += spacing)
      if (surface.region().contains({u, v})) {
        const Vector3d x = surface.lift({u, v});
        cells_[static_cast<std::size_t>(rowOf(v)) * columns_ + columnOf(u)].push_back(
            {x, surface.normal(x), reach, surface.rimDistance(x)});
      }
  }
}

int
CutRays::columnOf(double x) const
{
  return std::clamp(static_cast<int>((x - lower_.x()) / cell), 0, columns_ - 1);
}

int
CutRays::rowOf(double y) const
{
  return std::clamp(static_cast<int>((y - lower_.y()) / cell), 0, rows_ - 1);
}

void
CutRays::cut(const RoundedCutter& cutter, const TipAndAxis& place)
{
  const Vector3d top = place.tip + cutter.length * place.axis;
  const Vector3d low = place.tip.cwiseMin(top).array() - cutter.radius, high = place.tip.cwiseMax(top).array() + cutter.radius;
  for (int r = rowOf(low.y()); r <= rowOf(high.y()); ++r)
    for (int c = columnOf(low.x()); c <= columnOf(high.x()); ++c)
      for (Ray& ray : cells_[static_cast<std::size_t>(r) * columns_ + c])
        cutRay(cutter, place, ray);
}

/** Walks up the ray by the distance to the tool until it meets the tool or the end of the stock. */
void
CutRays::cutRay(const RoundedCutter& cutter, const TipAndAxis& place, Ray& ray) const
{
  constexpr double met = 1e-6;
  if (cutter.distance(place, ray.x) > std::max(deepest_, ray.stock))
    return;
  double h = -deepest_, free = cutter.distance(place, ray.x + h * ray.normal);
  while (free > met && h < ray.stock) {
    h += free;
    free = cutter.distance(place, ray.x + h * ray.normal);
  }
  ray.stock = std::min(ray.stock, h);
}

CutReport
CutRays::figures(double band) const
{
  CutReport f;
  std::vector<double> stock;
  for (const std::vector<Ray>& rays : cells_)
    for (const Ray& ray : rays) {
      f.gouge = std::max(f.gouge, -ray.stock);
      if (ray.rim < band)
        continue;
      stock.push_back(ray.stock);
    }
  f.rays = stock.size();
  if (stock.empty())
    return f;
  std::sort(stock.begin(), stock.end());
  f.most = stock.back();
  f.high = stock[static_cast<std::size_t>(0.98 * static_cast<double>(stock.size() - 1))];
  return f;
}

} // namespace pcl_spiral::test
