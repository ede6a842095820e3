// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/machine/tool_frames.h>

#include <pcl_spiral/core/impl/frame.h>

#include "core/angle_between.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/** The moves that are on the path: from the one whose end is its first pose to the last cut. */
std::pair<std::size_t, std::size_t>
pathOf(const ToolMoves& moves)
{
  const auto cuts = [](const ToolMove& move) { return move.section == BlockSection::Cut; };
  const auto comes = [](const ToolMove& move) { return move.section == BlockSection::LeadIn; };
  const auto first = std::find_if(moves.begin(), moves.end(), cuts);
  if (first == moves.end()) { // a path of one pose
    const auto last = std::find_if(moves.rbegin(), moves.rend(), comes);
    const std::size_t at = last == moves.rend() ? 0 : static_cast<std::size_t>(moves.rend() - last) - 1;
    return {at, at};
  }
  const auto last = std::find_if(moves.rbegin(), moves.rend(), cuts);
  const auto begin = static_cast<std::size_t>(first - moves.begin());
  return {begin == 0 ? 0 : begin - 1, static_cast<std::size_t>(moves.rend() - last) - 1};
}

/** A tip is that of a contact and a normal in floats: a way shorter than this has no sure direction. Each of them is rounded by up to 2^-24
 *  of itself; over sixteen times as much, the direction is sure to about seven degrees. */
double
leastWay(const ToolMoves& moves, std::size_t first, std::size_t last)
{
  double largest = 0.0;
  for (std::size_t i = first; i <= last; ++i)
    largest = std::max({largest, moves[i].pose.tip.cwiseAbs().maxCoeff(), moves[i].pose.contact.cwiseAbs().maxCoeff()});
  return 16.0 * std::ldexp(largest, -24);
}

/** Direction from each place of the path, \p first to \p last, to the next one; at the end, from the one before. Zero if the tip never
 *  moves. */
std::vector<Vector3d>
travelOf(const ToolMoves& moves, std::size_t first, std::size_t last)
{
  const double least = leastWay(moves, first, last);
  std::vector<Vector3d> travel(last - first + 1, Vector3d::Zero());
  std::size_t from = first;
  for (std::size_t i = first + 1; i <= last; ++i) {
    const Vector3d way = moves[i].pose.tip - moves[from].pose.tip;
    if (!(way.norm() > least))
      continue;
    for (; from < i; ++from)
      travel[from - first] = way.normalized();
  }
  for (; from <= last && from > first; ++from)
    travel[from - first] = travel[from - first - 1];
  return travel;
}

double
largestTurn(const std::vector<Vector3d>& directions)
{
  double largest = 0.0;
  for (std::size_t i = 1; i < directions.size(); ++i)
    largest = std::max(largest, angleBetween(directions[i - 1], directions[i]));
  return largest;
}

/** \p travel square to \p z, unit; zero if the travel is along z. */
Vector3d
squareTo(const Vector3d& z, const Vector3d& travel)
{
  const Vector3d x = travel - travel.dot(z) * z;
  return x.norm() > 1e-9 ? Vector3d(x.normalized()) : Vector3d::Zero();
}

Matrix3d
frameOf(const Vector3d& z, const Vector3d& x)
{
  Matrix3d frame;
  frame << x, z.cross(x), z;
  return frame;
}

/** The frame after \p before: \p before turned by the shortest way to \p z, then about z towards \p travel, by \p most. */
Matrix3d
nextFrame(const Matrix3d& before, const Vector3d& z, const Vector3d& travel, double most)
{
  const Vector3d carried = Eigen::Quaterniond::FromTwoVectors(before.col(2), z) * before.col(0);
  const Vector3d x = (carried - carried.dot(z) * z).normalized(), wanted = squareTo(z, travel);
  if (wanted.isZero())
    return frameOf(z, x);
  const double turn = std::atan2(x.cross(wanted).dot(z), x.dot(wanted));
  return frameOf(z, std::abs(turn) <= most ? wanted : Vector3d(Eigen::AngleAxisd(std::copysign(most, turn), z) * x));
}

} // namespace

std::vector<Matrix3d>
toolFrames(const ToolMoves& moves, RobotZ z)
{
  if (moves.empty())
    return {};
  const auto [first, last] = pathOf(moves);
  const auto zOf = [&, z](std::size_t i) { return (z == RobotZ::Axis ? moves[i].pose.axis : moves[i].pose.normal).normalized(); };
  const std::vector<Vector3d> travel = travelOf(moves, first, last);
  const double most = largestTurn(travel);
  // The first frame along the first travel that is not along z.
  Vector3d x = Vector3d::Zero(), y;
  for (std::size_t i = first; i <= last && x.isZero(); ++i)
    x = squareTo(zOf(first), travel[i - first]);
  if (x.isZero())
    tangentFrame(zOf(first), x, y);
  std::vector<Matrix3d> frames(moves.size());
  frames[first] = frameOf(zOf(first), x);
  for (std::size_t i = first + 1; i <= last; ++i)
    frames[i] = nextFrame(frames[i - 1], zOf(i), travel[i - first], most);
  std::fill(frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(first), frames[first]);
  std::fill(frames.begin() + static_cast<std::ptrdiff_t>(last) + 1, frames.end(), frames[last]);
  return frames;
}

FrameTurn
largestFrameTurn(const std::vector<ToolMoves>& passes, RobotZ z)
{
  FrameTurn largest;
  for (const ToolMoves& moves : passes) {
    const std::vector<Matrix3d> frames = toolFrames(moves, z);
    for (std::size_t i = 1; i < frames.size(); ++i)
      if (const double angle = angleBetween(frames[i - 1].col(0), frames[i].col(0)); angle > largest.angle)
        largest = {angle, moves[i].pose.tip};
  }
  return largest;
}

} // namespace pcl_spiral
