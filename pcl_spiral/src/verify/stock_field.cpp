// SPDX-License-Identifier: BSD-3-Clause
#include "stock_field.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double same_height = 1e-7; // mm: two moves meet there
constexpr double met = 3e-8;         // mm: difference of heights where they do; a sweep is known to 1e-8

} // namespace

SurfacePlace
placeAt(const SurfaceFoot& foot, const Eigen::Vector3d& d)
{
  const Eigen::Vector3d e2 = foot.normal.cross(foot.direction1);
  const double a = d.dot(foot.direction1), b = d.dot(e2);
  const double ka = foot.curvature1 * a, kb = foot.curvature2 * b;
  const double root = 1.0 / std::sqrt(1.0 + ka * ka + kb * kb);
  return {foot.position + a * foot.direction1 + b * e2 - 0.5 * (ka * a + kb * b) * foot.normal,
          root * (foot.normal + ka * foot.direction1 + kb * e2)};
}

SurfaceFoot
shifted(const SurfaceFoot& foot, const Eigen::Vector3d& d)
{
  SurfaceFoot moved = foot;
  const SurfacePlace place = placeAt(foot, d);
  moved.position = place.position;
  moved.normal = place.normal;
  moved.direction1 = (foot.direction1 - foot.direction1.dot(place.normal) * place.normal).normalized();
  return moved;
}

Stock
StockField::cast(const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, std::size_t guess) const
{
  Stock stock;
  stock.height = reach_;
  if (guess < sweep_.moves() && sweep_.enter(guess, x, n, start, stock.height)) {
    stock.move = guess;
    stock.met = true;
  }
  sweep_.enterAny(x, n, start, stock);
  return stock;
}

Stock
StockField::at(const Eigen::Vector3d& x, const Eigen::Vector3d& n, std::size_t guess) const
{
  constexpr double deeper = 8.0;
  const double deepest = 2.0 * sweep_.boundingRadius();
  for (double start = std::min(shallow_, deepest);; start = std::min(deeper * start, deepest)) {
    const Stock stock = cast(x, n, start, guess);
    if (!stock.met || stock.height > -start || start == deepest)
      return stock;
    guess = stock.move;
  }
}

Eigen::Vector3d
StockField::across(const SurfaceFoot& foot, std::size_t move) const
{
  const Eigen::Vector3d w = foot.normal.cross(sweep_.centres()[move + 1] - sweep_.centres()[move]);
  const double norm = w.norm();
  return norm > 1e-9 ? Eigen::Vector3d(w / norm) : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

double
StockField::under(std::size_t move, const SurfacePlace& place) const
{
  const double deepest = 2.0 * sweep_.boundingRadius(), highest = std::min(2.0 * reach_, deepest);
  double height = highest;
  if (sweep_.enter(move, place.position, place.normal, shallow_, height) && height == -shallow_)
    sweep_.enter(move, place.position, place.normal, deepest, height);
  return height;
}

double
StockField::meeting(const SurfaceFoot& foot, const Eigen::Vector3d& w, std::size_t first, std::size_t second, double low, double high) const
{
  constexpr int rounds = 40;
  const auto excess = [&](double d) {
    const SurfacePlace place = placeAt(foot, d * w);
    return under(first, place) - under(second, place) - 0.5 * same_height; // flats of one height meet where the first one ends
  };
  double below = excess(low), above = excess(high), d = high, before = 0.0;
  for (int i = 0; i < rounds && high - low > 1e-12; ++i) { // regula falsi, Illinois
    d = above > below ? low - below * (high - low) / (above - below) : 0.5 * (low + high);
    const double value = excess(d);
    if (std::abs(value) < met)
      break;
    if (value < 0.0) {
      low = d;
      below = value;
      above *= before < 0.0 ? 0.5 : 1.0; // an end that stays twice is taken for nearer
    }
    else {
      high = d;
      above = value;
      below *= before > 0.0 ? 0.5 : 1.0;
    }
    before = value;
  }
  return d;
}

Ridge
StockField::climbed(const SurfaceFoot& foot, const Stock& from, const Eigen::Vector3d& w, double step, double limit) const
{
  constexpr int most_cells = 64;
  Ridge ridge;
  if (!from.met || w.isZero(0.0))
    return ridge;
  std::size_t current = from.move;
  double low = 0.0;
  for (int cell = 0; cell < most_cells && low < limit; ++cell) {
    // Walk until another move cuts deeper than the current one.
    Stock other;
    double high = low;
    for (bool lower = false; !lower;) {
      if (high >= limit)
        return ridge;
      high = std::min(limit, high + step);
      const SurfacePlace place = placeAt(foot, high * w);
      other = at(place.position, place.normal, current);
      if (!other.met)
        return ridge;
      lower = other.move != current && other.height < under(current, place) - same_height;
    }
    // Go back to the place where the current one ends.
    double d = high;
    SurfacePlace place;
    for (int i = 0; i < most_cells; ++i) {
      d = meeting(foot, w, current, other.move, low, high);
      place = placeAt(foot, d * w);
      const Stock least = at(place.position, place.normal, current);
      const double here = under(current, place);
      ridge.height = std::min(here, least.height);
      if (!least.met || least.move == other.move || least.height >= here - same_height)
        break;
      other = least;
      high = d;
    }
    // A top, or the same slope continues under the next move of the pass.
    const double beyond = 0.01 * step;
    if (under(other.move, placeAt(foot, (d + beyond) * w)) < ridge.height - same_height) {
      ridge.position = place.position;
      ridge.move = current;
      ridge.found = true;
      return ridge;
    }
    current = other.move;
    low = d;
  }
  return ridge;
}

Ridge
StockField::climbed(const SurfaceFoot& foot, const Stock& from, double step, double limit) const
{
  if (!from.met)
    return {};
  const Eigen::Vector3d w = across(foot, from.move);
  const double beside = 0.01 * step;
  const bool rises = under(from.move, placeAt(foot, beside * w)) >= under(from.move, placeAt(foot, -beside * w));
  return climbed(foot, from, rises ? w : Eigen::Vector3d(-w), step, limit);
}

} // namespace pcl_spiral
