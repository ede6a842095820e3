// SPDX-License-Identifier: BSD-3-Clause
#include "support/stock.h"

#include "support/checked_path.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace pcl_spiral::test {

bool
StockField::main(const Eigen::Vector3d& x) const
{
  return surface_.contains(x) && surface_.rimDistance(x) >= band_;
}

StockSample
StockField::at(const Eigen::Vector3d& x) const
{
  const Eigen::Vector3d n = surface_.normal(x);
  // A short ray is fast; a ray that starts inside the cut is repeated from deeper.
  const double start = 0.2 * h_;
  MoveTree::Entry entry = tree_.entry(x, n, radius_, start, 20.0 * h_);
  if (entry.met && entry.t <= -start)
    entry = tree_.entry(x, n, radius_, radius_, 20.0 * h_);
  return {x, entry.t, entry.move, entry.met};
}

StockSample
StockField::off(const StockSample& from, const Eigen::Vector3d& w, double d, bool near_rim) const
{
  const Eigen::Vector3d x = surface_.pulled(from.x + d * w);
  return near_rim && !main(x) ? StockSample{x} : at(x);
}

Eigen::Vector3d
StockField::across(const StockSample& s) const
{
  const Eigen::Vector3d n = surface_.normal(s.x);
  const Eigen::Vector3d feed = tree_.points()[s.move + 1] - tree_.points()[s.move];
  const Eigen::Vector3d w = n.cross(feed);
  return w.norm() > 1e-12 ? Eigen::Vector3d(w.normalized()) : Eigen::Vector3d(n.unitOrthogonal());
}

double
StockField::pitch(const StockSample& s, const Eigen::Vector3d& w) const
{
  return exactStepOver(radius_, h_, surface_.normalCurvature(s.x, w));
}

StockSample
StockField::golden(const StockSample& from, const Eigen::Vector3d& w, double lo, double hi, bool near_rim, int rounds) const
{
  constexpr double g = 0.6180339887498949;
  double a = hi - g * (hi - lo), b = lo + g * (hi - lo);
  StockSample fa = off(from, w, a, near_rim), fb = off(from, w, b, near_rim);
  for (int i = 0; i < rounds; ++i)
    if (fa.stock > fb.stock) {
      hi = b;
      b = a;
      fb = fa;
      a = hi - g * (hi - lo);
      fa = off(from, w, a, near_rim);
    }
    else {
      lo = a;
      a = b;
      fa = fb;
      b = lo + g * (hi - lo);
      fb = off(from, w, b, near_rim);
    }
  return fa.stock > fb.stock ? fa : fb;
}

StockSample
StockField::climbed(const StockSample& start) const
{
  if (!start.met)
    return start;
  Eigen::Vector3d w = across(start);
  const double s = pitch(start, w), step = 0.1 * s;
  const bool near_rim = surface_.rimDistance(start.x) < band_ + 1.5 * s;
  StockSample best = off(start, w, step, near_rim);
  const StockSample back = off(start, w, -step, near_rim);
  if (back.stock > best.stock) {
    w = -w;
    best = back;
  }
  double d = best.stock > start.stock ? step : 0.0;
  for (int i = 0; d > 0.0 && i < 12; ++i) {
    const StockSample next = off(start, w, d + step, near_rim);
    if (next.stock <= best.stock)
      break;
    best = next;
    d += step;
  }
  const StockSample top = golden(start, w, d - step, d + step, near_rim, 15);
  return top.stock > std::max(best.stock, start.stock) ? top : best.stock > start.stock ? best : start;
}

StockSample
StockField::followed(const StockSample& ridge) const
{
  if (!ridge.met)
    return ridge;
  const Eigen::Vector3d w = across(ridge), along = w.cross(surface_.normal(ridge.x));
  const double s = pitch(ridge, w);
  const double reach = (tree_.points()[ridge.move + 1] - tree_.points()[ridge.move]).norm();
  const auto top = [&](double d) {
    const StockSample moved = off(ridge, along, d, true);
    return moved.stock == StockSample::not_counted ? moved : golden(moved, w, -0.2 * s, 0.2 * s, true, 14);
  };
  StockSample best = ridge;
  double at = 0.0;
  for (double step = reach / 4.0; step > reach / 200.0; step /= 4.0) {
    const double centre = at;
    for (int k = -4; k <= 4; ++k) {
      const StockSample candidate = top(centre + k * step);
      if (candidate.stock > best.stock) {
        best = candidate;
        at = centre + k * step;
      }
    }
  }
  return best;
}

} // namespace pcl_spiral::test
