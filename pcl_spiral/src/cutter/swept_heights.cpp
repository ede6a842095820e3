// SPDX-License-Identifier: BSD-3-Clause
#include "swept_heights.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr int thirds = 24, halvings = 24;
constexpr double cell_radii = 1.5; // a tip is nearer to what its cutter leaves

} // namespace

std::size_t
SweptHeights::CellHash::operator()(const Cell& cell) const
{
  std::size_t hash = 0;
  for (const std::int64_t part : cell)
    hash = hash * 1000003U ^ static_cast<std::size_t>(part);
  return hash;
}

SweptHeights::Cell
SweptHeights::cellOf(const Vector3d& x) const
{
  const Vector3d cell = (x / cell_).array().floor();
  return {static_cast<std::int64_t>(cell.x()), static_cast<std::int64_t>(cell.y()), static_cast<std::int64_t>(cell.z())};
}

SweptHeights::SweptHeights(const CutterProfile& profile, double length, const std::vector<std::vector<CutterPlace>>& passes)
: profile_(profile), length_(length)
{
  double longest = 0.0;
  for (const std::vector<CutterPlace>& pass : passes)
    for (std::size_t i = 0; i + 1 < pass.size(); ++i) {
      moves_.push_back({pass[i], pass[i + 1]});
      longest = std::max(longest, (pass[i + 1].tip - pass[i].tip).norm());
    }
  cell_ = cell_radii * profile.radius() + 0.5 * longest;
  for (std::size_t i = 0; i < moves_.size(); ++i)
    cells_[cellOf(0.5 * (moves_[i].from.tip + moves_[i].to.tip))].push_back(static_cast<std::uint32_t>(i));
}

/** The height of the cutter above \p x is convex along a move with a fixed axis: sought by thirds where the axis is within the
 *  cutter's radius. */
bool
SweptHeights::cuts(const Move& move, const Vector3d& x) const
{
  const Vector3d d = move.to.tip - move.from.tip, p = x - move.from.tip, mean = (move.from.axis + move.to.axis).normalized();
  const double rise = d.dot(mean), up = p.dot(mean), radius = profile_.radius();
  const Vector3d d_beside = d - rise * mean, p_beside = p - up * mean;
  const double length2 = d_beside.squaredNorm(), nearest = length2 > 0.0 ? p_beside.dot(d_beside) / length2 : 0.5;
  const double least2 = (p_beside - std::clamp(nearest, 0.0, 1.0) * d_beside).squaredNorm();
  const bool turns = move.from.axis != move.to.axis;
  if (up - std::max(0.0, rise) > length_) // beyond the end of the tool all the way
    return false;
  if (!turns && (least2 > radius * radius || profile_.height(std::sqrt(least2)) > up - std::min(0.0, rise)))
    return false;
  const double apart2 = (p_beside - nearest * d_beside).squaredNorm();
  const double half = length2 > 0.0 ? std::sqrt(std::max(0.0, radius * radius - apart2) / length2) : 1.0;
  double low = turns ? 0.0 : std::clamp(nearest - half, 0.0, 1.0), high = turns ? 1.0 : std::clamp(nearest + half, 0.0, 1.0);
  const auto above = [&](double s) { // of the cutter over x
    const Vector3d axis = turns ? Vector3d((move.from.axis + s * (move.to.axis - move.from.axis)).normalized()) : mean;
    const Vector3d y = p - s * d;
    const double z = y.dot(axis);
    return profile_.height(std::min((y - z * axis).norm(), radius)) - z;
  };
  const auto inReach = [&](double s) { return turns && (p - s * d).cross(mean).norm() > radius * (1.0 + 1e-6); };
  for (int k = 0; k < thirds; ++k) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0, at_a = above(a), at_b = above(b);
    if ((at_a < 0.0 && !inReach(a)) || (at_b < 0.0 && !inReach(b)))
      return true;
    (at_a < at_b ? high : low) = at_a < at_b ? b : a;
  }
  return false;
}

template <typename Visit>
void
SweptHeights::visitNear(const Vector3d& x, const Visit& visit) const
{
  const Cell middle = cellOf(x);
  for (std::int64_t i = 0; i < 27; ++i)
    if (const auto cell = cells_.find({middle[0] + i % 3 - 1, middle[1] + i / 3 % 3 - 1, middle[2] + i / 9 - 1}); cell != cells_.end())
      for (const std::uint32_t m : cell->second)
        visit(moves_[m]);
}

double
SweptHeights::over(const Vector3d& x, const Vector3d& normal, double most) const
{
  double least = most;
  visitNear(x, [&](const Move& move) {
    if (!cuts(move, x + least * normal))
      return;
    double low = -most, high = least;
    for (int k = 0; k < halvings; ++k) {
      const double height = 0.5 * (low + high);
      (cuts(move, x + height * normal) ? high : low) = height;
    }
    least = high;
  });
  return least;
}

/** The distance of a place from a cutter that moves straight is convex along the move: sought by thirds. */
double
SweptHeights::distance(const Move& move, const Vector3d& x) const
{
  const auto at = [&](double s) {
    const Vector3d axis = (move.from.axis + s * (move.to.axis - move.from.axis)).normalized();
    const CutterTouch touch = profile_.touchAt(move.from.tip + s * (move.to.tip - move.from.tip), axis, x, Vector3d::Zero());
    return (touch.place - x).dot(touch.normal);
  };
  double low = 0.0, high = 1.0;
  for (int k = 0; k < thirds; ++k) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    const bool nearer = at(a) < at(b);
    (nearer ? high : low) = nearer ? b : a;
  }
  return std::max(0.0, std::min({at(0.0), at(0.5 * (low + high)), at(1.0)}));
}

double
SweptHeights::distance(const Vector3d& x, double most) const
{
  double least = most;
  visitNear(x, [&](const Move& move) { least = std::min(least, distance(move, x)); });
  return least;
}

} // namespace pcl_spiral
