// SPDX-License-Identifier: BSD-3-Clause
#include "path_match.h"

#include "support/move_tree.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl_spiral::acceptance {

namespace {

/** The point of \p a farthest from the polyline \p b. */
test::Place
farthest(const test::CheckedPath& a, const test::MoveTree& b)
{
  test::Place place;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = b.nearest(a.contacts[i]).first;
    if (!(d <= place.value)) // NaN is the farthest of all
      place = {d, a.contacts[i], 0.0, a.turn(i), i};
  }
  return place;
}

/** The axis of \p path after \p share of its length; \p from: a point before it, set to the last point before it. */
Eigen::Vector3d
axisAt(const Path& path, double share, std::size_t& from)
{
  const double gone = share * path.back().arc_length;
  while (from + 2 < path.size() && path[from + 1].arc_length < gone)
    ++from;
  const ToolpathPoint &a = path[from], &b = path[from + 1];
  const double width = b.arc_length - a.arc_length;
  const double t = width > 0.0 ? std::clamp((gone - a.arc_length) / width, 0.0, 1.0) : 0.0;
  return (1.0 - t) * a.getAxisVector3fMap().cast<double>() + t * b.getAxisVector3fMap().cast<double>();
}

double
degreesBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / M_PI;
}

} // namespace

bool
sameBytes(const Path& a, const Path& b)
{
  const auto same = [](const ToolpathPoint& p, const ToolpathPoint& q) {
    return std::memcmp(p.data, q.data, 3 * sizeof(float)) == 0 && std::memcmp(p.normal, q.normal, 3 * sizeof(float)) == 0 &&
           std::memcmp(p.axis, q.axis, 3 * sizeof(float)) == 0 && std::memcmp(&p.arc_length, &q.arc_length, sizeof(double)) == 0 &&
           std::memcmp(&p.turn, &q.turn, sizeof(float)) == 0;
  };
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same);
}

Path
mapped(const Path& path, const Eigen::Affine3d& map)
{
  const Eigen::Matrix3d turn = map.linear() / std::cbrt(std::abs(map.linear().determinant()));
  Path result = path;
  for (ToolpathPoint& p : result) {
    p.getVector3fMap() = (map * p.getVector3fMap().cast<double>()).cast<float>();
    p.getNormalVector3fMap() = (turn * p.getNormalVector3fMap().cast<double>()).cast<float>();
    p.getAxisVector3fMap() = (turn * p.getAxisVector3fMap().cast<double>()).cast<float>();
  }
  return result;
}

PathMatch
matched(const Path& a, const Path& b)
{
  const test::CheckedPath first = test::fromToolpath(a), second = test::fromToolpath(b);
  const test::MoveTree first_moves(first.contacts), second_moves(second.contacts);
  PathMatch match;
  match.off = farthest(first, second_moves);
  match.missed = farthest(second, first_moves);
  match.start = (first.contacts.front() - second.contacts.front()).norm();
  match.end = (first.contacts.back() - second.contacts.back()).norm();
  std::size_t from = 0;
  for (const ToolpathPoint& p : a) {
    const Eigen::Vector3d axis = axisAt(b, p.arc_length / a.back().arc_length, from);
    const double angle = degreesBetween(p.getAxisVector3fMap().cast<double>(), axis);
    match.axis = angle <= match.axis ? match.axis : angle;
  }
  return match;
}

} // namespace pcl_spiral::acceptance
