// SPDX-License-Identifier: BSD-3-Clause
#include "lowest_over.h"
#include "sweep_tree.h"
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

/** A depth, with the outward normal of the side that is nearest. */
struct ProfileSweep::Depth {
  double depth, z;       ///< mm; height above the tip
  double outward, along; ///< the normal: times the way from the axis, and along the axis
  Eigen::Vector3d normal(const Eigen::Vector3d& w, const Eigen::Vector3d& axis) const { return outward * (w - z * axis) + along * axis; }
};

/** A part of a move. */
struct ProfileSweep::Piece {
  Eigen::Vector3d tip, way, axis, turn; ///< at the share 0; what is added up to the share 1
  double angle;                         ///< by which the axis turns, radians
};

ProfileSweep::ProfileSweep(const CutterShape& cutter, Polyline tips, std::vector<Eigen::Vector3d> axes,
                           const std::vector<std::size_t>& passes)
: CutterSweep(middles(tips, axes, heightOf(cutter)), std::hypot(cutter.radius, 0.5 * heightOf(cutter)), passes),
  profile_(CutterProfile(cutter)), height_(heightOf(cutter)), tips_(std::move(tips)), axes_(std::move(axes)),
  tree_(std::make_unique<SweepTree>(tips_, axes_, passes))
{}

ProfileSweep::~ProfileSweep() = default;

ProfileSweep::Piece
ProfileSweep::whole(std::size_t move) const
{
  const Eigen::Vector3d turn = axes_[move + 1] - axes_[move];
  return {tips_[move], tips_[move + 1] - tips_[move], axes_[move], turn, 2.0 * std::asin(std::min(1.0, 0.5 * turn.norm()))};
}

ProfileSweep::Piece
ProfileSweep::half(const Piece& piece, bool second) const
{
  const Eigen::Vector3d end = piece.axis + piece.turn, sum = piece.axis + end, way = 0.5 * piece.way;
  const Eigen::Vector3d middle = sum.norm() > 1e-9 ? Eigen::Vector3d(sum.normalized()) : piece.axis;
  if (second)
    return {piece.tip + way, way, middle, end - middle, 0.5 * piece.angle};
  return {piece.tip, way, piece.axis, middle - piece.axis, 0.5 * piece.angle};
}

/** How far the depth on a piece is from a concave function, mm: a point of the cutter moves on an arc, and the way of the tip turns
 *  against the axis. Half of the piece has a quarter of it. */
double
ProfileSweep::bow(const Piece& piece) const
{
  return piece.angle > 0.0 ? piece.angle * (2.0 * piece.way.norm() + height_ * piece.angle) / 8.0 : 0.0;
}

/** Depth of a place at \p w from the tip. */
ProfileSweep::Depth
ProfileSweep::depthOf(const Eigen::Vector3d& w, const Eigen::Vector3d& axis) const
{
  const double z = w.dot(axis), l = std::sqrt(std::max(0.0, w.squaredNorm() - z * z));
  ProfileDepth::Side side = profile_.at(l, z);
  if (height_ - z < side.depth)
    side = {height_ - z, 0.0, 1.0};
  return {side.depth, z, side.across / std::max(l, 1e-12), side.along};
}

Tangent
ProfileSweep::depthAt(const Piece& piece, double f, const Eigen::Vector3d& x, const Eigen::Vector3d& n) const
{
  const Eigen::Vector3d w = x - piece.tip - f * piece.way;
  const bool turns = piece.angle > 0.0;
  const Eigen::Vector3d axis = turns ? Eigen::Vector3d((piece.axis + f * piece.turn).normalized()) : piece.axis;
  const Depth depth = depthOf(w, axis);
  const Eigen::Vector3d normal = depth.normal(w, axis);
  double over_move = normal.dot(piece.way);
  if (turns)
    over_move += (depth.outward * depth.z - depth.along) * (w.dot(piece.turn) - depth.z * axis.dot(piece.turn));
  return {depth.depth, over_move, -normal.dot(n)};
}

/** Not less than the depth, at any of \p places, of \p x or of any place from there up to \p down away. The depth is concave, so it is
 *  below its tangent plane over all ways of the tip; turning the axis moves a point of the cutter by the angle times its distance. */
double
ProfileSweep::bound(const SweptPlaces& places, const Eigen::Vector3d& x, const Eigen::Vector3d& down) const
{
  const Eigen::Vector3d w = x - places.tip;
  const Depth depth = depthOf(w, places.axis);
  const Eigen::Vector3d normal = depth.normal(w, places.axis);
  const double way = (places.sides.transpose() * normal).cwiseAbs().dot(places.half) + std::max(0.0, -normal.dot(down));
  if (places.turn == 0.0)
    return depth.depth + way;
  const double off = places.half.norm() + down.norm();
  return depth.depth + way + places.turn * (w.cross(normal).norm() + off) + 0.5 * places.turn * places.turn * (w.norm() + off);
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

/** Not less than the depth on \p piece of any place from x + t n down to \p range below. The depth is below its tangent plane at \p middle
 *  but for the bow, for what the turn adds on the way down, and for its slope with the angle in place of the chord, which is less than
 *  the bow again. */
double
ProfileSweep::highest(const Piece& piece, const Tangent& middle, double range) const
{
  return middle.value + 0.5 * std::abs(middle.slope) + std::max(0.0, -middle.other * range) + 2.0 * bow(piece) + 0.5 * piece.angle * range;
}

/** Halves the piece until the depth on it is about concave, and takes the more promising half first. */
bool
ProfileSweep::enterPart(const Piece& part, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double& t) const
{
  if (bow(part) <= least_bow)
    return enterPiece(part, x, n, start, t);
  const Tangent middle = depthAt(part, 0.5, x + t * n, n);
  if (highest(part, middle, t + start) <= 0.0)
    return false;
  const bool second = middle.slope > 0.0, entered = enterPart(half(part, second), x, n, start, t);
  return enterPart(half(part, !second), x, n, start, t) || entered;
}

bool
ProfileSweep::enter(std::size_t move, const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, double& t) const
{
  return !isLift(move) && -start < t && enterPart(whole(move), x, n, start, t);
}

/** Raises \p most to the largest depth of \p x on the part. */
void
ProfileSweep::deepen(const Piece& part, const Eigen::Vector3d& x, double& most) const
{
  const Eigen::Vector3d any = Eigen::Vector3d::Zero();
  if (bow(part) <= least_bow) {
    most = std::max(most, deepest(part, x, any, -std::numeric_limits<double>::infinity()).value);
    return;
  }
  const Tangent middle = depthAt(part, 0.5, x, any);
  if (highest(part, middle, 0.0) <= most)
    return;
  const bool second = middle.slope > 0.0;
  deepen(half(part, second), x, most);
  deepen(half(part, !second), x, most);
}

double
ProfileSweep::depth(std::size_t move, const Eigen::Vector3d& x) const
{
  double most = -std::numeric_limits<double>::infinity();
  if (!isLift(move))
    deepen(whole(move), x, most);
  return most;
}

void
ProfileSweep::enterAny(const Eigen::Vector3d& x, const Eigen::Vector3d& n, double start, Stock& stock) const
{
  const auto lower = [&](const SweptPlaces& places) {
    const double last = stock.height - settled;
    return bound(places, x + last * n, -(last + start) * n);
  };
  tree_->search(lower, [&](std::size_t move) { take(move, x, n, start, stock); });
}

double
ProfileSweep::deepest(const Eigen::Vector3d& x) const
{
  double most = 0.0;
  const auto deeper = [&](const SweptPlaces& places) { return bound(places, x, Eigen::Vector3d::Zero()) - most; };
  tree_->search(deeper, [&](std::size_t move) { deepen(whole(move), x, most); });
  return most;
}

SurfaceHeight
ProfileSweep::lowest(std::size_t move, double f, const SurfaceFoot& foot, double reach) const
{
  const Eigen::Vector3d tip = (1.0 - f) * tips_[move] + f * tips_[move + 1], axis = arcBetween(axes_[move], axes_[move + 1], f);
  return lowestOver(profile_, tip, axis, foot, reach);
}

} // namespace pcl_spiral
