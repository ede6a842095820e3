// SPDX-License-Identifier: BSD-3-Clause
#include "lowest_over.h"
#include "tangent_search.h"
#include <pcl_spiral/verify/impl/profile_sweep.h>

#include <pcl_spiral/machine/impl/tool_pose.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double least_bow = 1e-4; // mm: depths on a piece of a move are about concave to this
constexpr int most_rounds = 60;
constexpr double settled = 1e-8; // mm: entries nearer to each other are the same

/** The middle of the ball about a cutter of \p height. */
Polyline
middles(const Polyline& tips, const std::vector<Eigen::Vector3d>& axes, double height)
{
  Polyline result(tips.size());
  for (std::size_t i = 0; i < tips.size(); ++i)
    result[i] = tips[i] + 0.5 * height * axes[i];
  return result;
}

double
heightOf(const CutterShape& cutter)
{
  return std::max(CutterProfile(cutter).topHeight(), 2.0 * cutter.radius);
}

} // namespace

/** A part of a move with a small turn of the axis. */
struct ProfileSweep::Piece {
  Eigen::Vector3d tip, way, axis, turn; ///< at the share 0; what is added up to the share 1
  bool turns;                           ///< whether turn is not zero
};

ProfileSweep::ProfileSweep(const CutterShape& cutter, Polyline tips, std::vector<Eigen::Vector3d> axes,
                           const std::vector<std::size_t>& passes)
: CutterSweep(middles(tips, axes, heightOf(cutter)), std::hypot(cutter.radius, 0.5 * heightOf(cutter)), passes),
  profile_(CutterProfile(cutter)), height_(heightOf(cutter)), tips_(std::move(tips)), axes_(std::move(axes))
{}

/** How far the depth on a move is from a concave function, mm: a point of the cutter moves on an arc, and the way of the tip turns against
 *  the axis. */
double
ProfileSweep::bow(std::size_t move) const
{
  if (axes_[move] == axes_[move + 1])
    return 0.0;
  const double turn = (axes_[move + 1] - axes_[move]).norm(), way = (tips_[move + 1] - tips_[move]).norm();
  return turn * (2.0 * way + height_ * turn) / 8.0;
}

std::size_t
ProfileSweep::pieces(std::size_t move) const
{
  return static_cast<std::size_t>(std::max(1.0, std::ceil(std::sqrt(bow(move) / least_bow))));
}

ProfileSweep::Piece
ProfileSweep::piece(std::size_t move, std::size_t number, std::size_t count) const
{
  if (count == 1) // the whole move
    return {tips_[move], tips_[move + 1] - tips_[move], axes_[move], axes_[move + 1] - axes_[move], axes_[move] != axes_[move + 1]};
  const auto place = [&](std::size_t end) {
    const double f = static_cast<double>(end) / static_cast<double>(count);
    return std::pair(Eigen::Vector3d((1.0 - f) * tips_[move] + f * tips_[move + 1]), arcBetween(axes_[move], axes_[move + 1], f));
  };
  const auto [tip, axis] = place(number);
  const auto [end_tip, end_axis] = place(number + 1);
  return {tip, end_tip - tip, axis, end_axis - axis, true};
}

Tangent
ProfileSweep::depthAt(const Piece& piece, double f, const Eigen::Vector3d& x, const Eigen::Vector3d& n) const
{
  const Eigen::Vector3d w = x - piece.tip - f * piece.way;
  const Eigen::Vector3d axis = piece.turns ? Eigen::Vector3d((piece.axis + f * piece.turn).normalized()) : piece.axis;
  const double z = w.dot(axis), l = std::sqrt(std::max(0.0, w.squaredNorm() - z * z));
  ProfileDepth::Side side = profile_.at(l, z);
  if (height_ - z < side.depth)
    side = {height_ - z, 0.0, 1.0};
  const double outward = side.across / std::max(l, 1e-12);
  const Eigen::Vector3d normal = outward * (w - z * axis) + side.along * axis;
  double over_move = normal.dot(piece.way);
  if (piece.turns)
    over_move += (outward * z - side.along) * (w.dot(piece.turn) - z * axis.dot(piece.turn));
  return {side.depth, over_move, -normal.dot(n)};
}

/** The deepest place of \p x on the piece; a bound of it if that is not above \p least. */
Tangent
ProfileSweep::deepest(const Piece& piece, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double least) const
{
  return largestOf([&](double f) { return depthAt(piece, f, x, n); }, 0.0, 1.0, least, settled);
}

/** The first place of the ray behind \p low, which is outside, that is inside, before \p high; \p high if there is none. */
double
ProfileSweep::firstInside(const Piece& piece, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double low, double high) const
{
  for (int i = 0; i < most_rounds && low < high; ++i) {
    const Tangent below = deepest(piece, x + low * n, n, low - high); // depth changes by at most the way along the ray
    if (below.value > -settled)
      return low;
    if (below.value <= low - high || below.other <= 0.0)
      return high;
    low -= below.value / below.other; // not beyond the first place inside: the depth is concave
  }
  return high;
}

bool
ProfileSweep::enterPiece(const Piece& piece, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double& t) const
{
  const double last = t - settled, range = last + start;
  if (range <= 0.0)
    return false;
  const Tangent end = deepest(piece, x + last * n, n, -range);
  if (end.value <= -range || (end.value <= 0.0 && end.other >= 0.0))
    return false;
  const double first = firstInside(piece, x, n, -start, last);
  if (first >= last)
    return false;
  t = first;
  return true;
}

/** Whether the whole move as one piece stays outside by more than its bow. */
bool
ProfileSweep::staysOutside(std::size_t move, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double t) const
{
  const double least = -(t + start) - bow(move);
  const Tangent end = deepest(piece(move, 0, 1), x + t * n, n, least);
  return end.value <= least || (end.value <= -bow(move) && end.other >= 0.0);
}

bool
ProfileSweep::enter(std::size_t move, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double& t) const
{
  if (isLift(move) || -start >= t)
    return false;
  const std::size_t count = pieces(move);
  bool entered = false;
  if (count > 1 && staysOutside(move, x, n, start, t))
    return false;
  for (std::size_t i = 0; i < count; ++i)
    entered = enterPiece(piece(move, i, count), x, n, start, t) || entered;
  return entered;
}

double
ProfileSweep::depth(std::size_t move, const Eigen::Vector3d& x) const
{
  constexpr double none = -std::numeric_limits<double>::infinity();
  double most = none;
  if (isLift(move))
    return most;
  const std::size_t count = pieces(move);
  for (std::size_t i = 0; i < count; ++i)
    most = std::max(most, deepest(piece(move, i, count), x, Eigen::Vector3d::Zero(), none).value);
  return most;
}

SurfaceHeight
ProfileSweep::lowest(std::size_t move, double f, const SurfaceFoot& foot, double reach) const
{
  const Eigen::Vector3d tip = (1.0 - f) * tips_[move] + f * tips_[move + 1], axis = arcBetween(axes_[move], axes_[move + 1], f);
  return lowestOver(profile_, tip, axis, foot, reach);
}

} // namespace pcl_spiral
