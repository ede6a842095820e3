// SPDX-License-Identifier: BSD-3-Clause
#include "swept_strip.h"

#include <pcl_spiral/core/impl/frame.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double no_way = 1e-12; // mm across the axis: a shorter move runs along it

/** Share of the way from \p a to \p b nearest to the origin; outside of 0 to 1, or not a number, if it has no foot. */
double
footShare(const Vector2d& a, const Vector2d& b)
{
  return a.dot(a - b) / (b - a).squaredNorm();
}

double
gap(double low, double high, double x)
{
  return std::max({low - x, x - high, 0.0});
}

} // namespace

SweptStrip::SweptStrip(const Vector3d& from, const Vector3d& to, const Vector3d& axis) : origin_(from)
{
  const Vector3d way = to - from;
  Vector3d across = way - way.dot(axis) * axis, side;
  length_ = across.norm();
  rise_ = way.dot(axis);
  if (length_ > no_way)
    across /= length_;
  else {
    length_ = 0.0;
    tangentFrame(axis, across, side);
  }
  axes_ << across.transpose(), axis.cross(across).transpose(), axis.transpose();
  turned_ = axes_.cwiseAbs();
  const double squared = length_ * length_ + rise_ * rise_;
  per_squared_ = squared > 0.0 ? 1.0 / squared : 0.0;
}

/** From (\p x, \p z) in the plane of the strip. */
double
SweptStrip::inPlane(double x, double z) const
{
  if (x >= 0.0 && x <= length_ && z * length_ >= rise_ * x && z >= std::min(0.0, rise_))
    return 0.0;
  const double t = std::clamp((x * length_ + z * rise_) * per_squared_, 0.0, 1.0);
  const double dx = x - t * length_, dz = z - t * rise_;
  double best = dx * dx + dz * dz;
  if (z >= 0.0)
    best = std::min(best, x * x);
  if (z >= rise_)
    best = std::min(best, (x - length_) * (x - length_));
  return best;
}

double
SweptStrip::toPlace(const Vector3d& p) const
{
  return p.y() * p.y() + inPlane(p.x(), p.z());
}

double
SweptStrip::toTurnedBox(const Box& box) const
{
  const Vector3d low(box.low[0], box.low[1], box.low[2]), high(box.high[0], box.high[1], box.high[2]);
  const Vector3d middle = axes_ * (0.5 * (low + high) - origin_), half = turned_ * (0.5 * (high - low));
  return toBox(middle - half, middle + half);
}

/** The strip has no upper end, so the nearest place is on the upper side of the box: an end, or below or beside a corner. */
double
SweptStrip::toBox(const Vector3d& low, const Vector3d& high) const
{
  const double off = gap(low.y(), high.y(), 0.0), z = high.z();
  if (z >= std::max(0.0, rise_)) {
    const double beside = std::max({low.x() - length_, -high.x(), 0.0});
    return off * off + beside * beside;
  }
  double best = std::min(inPlane(low.x(), z), inPlane(high.x(), z));
  for (const Vector2d& corner : {Vector2d(0.0, 0.0), Vector2d(length_, rise_)}) {
    const double dx = gap(low.x(), high.x(), corner.x()), dz = std::max(0.0, corner.y() - z);
    best = std::min(best, dx * dx + dz * dz);
  }
  return off * off + best;
}

double
SweptStrip::toPlane(const Matrix3d& corners, const Matrix3d& bows) const
{
  const Vector3d origin = corners.col(0);
  Vector3d normal = (corners.col(1) - origin).cross(corners.col(2) - origin);
  if (normal.z() < 0.0) // upwards the strip has no end
    normal = -normal;
  const double lowest = std::min(0.0, length_ * normal.x() + rise_ * normal.z()) - normal.dot(origin);
  const double off = lowest - std::max(0.0, -(normal.transpose() * bows).minCoeff()) / 3.0;
  return off > 0.0 ? off * off / normal.squaredNorm() : 0.0;
}

/** Whether the way between two places of its plane meets the strip: the way is clipped by the three lines that bound the strip. */
bool
SweptStrip::meetsInPlane(const Vector2d& from, const Vector2d& to) const
{
  const auto above = [&](const Vector2d& p) { return length_ > 0.0 ? p.y() * length_ - rise_ * p.x() : p.y() - std::min(0.0, rise_); };
  const double sides[3][2] = {{from.x(), to.x()}, {length_ - from.x(), length_ - to.x()}, {above(from), above(to)}};
  double first = 0.0, last = 1.0;
  for (const auto& side : sides) {
    if (side[0] < 0.0 && side[1] < 0.0)
      return false;
    if (side[0] < 0.0)
      first = std::max(first, side[0] / (side[0] - side[1]));
    else if (side[1] < 0.0)
      last = std::min(last, side[0] / (side[0] - side[1]));
  }
  return first <= last;
}

bool
SweptStrip::meets(const Matrix3d& corners) const
{
  Vector2d cuts[2];
  int found = 0;
  for (int k = 0; k < 3 && found < 2; ++k) {
    const Vector3d a = corners.col(k), b = corners.col((k + 1) % 3);
    if ((a.y() < 0.0) == (b.y() < 0.0))
      continue;
    const Vector3d cut = a + a.y() / (a.y() - b.y()) * (b - a);
    cuts[found++] = {cut.x(), cut.z()};
  }
  return found == 2 && meetsInPlane(cuts[0], cuts[1]);
}

/** Least squared distance from the edges of the strip to the way from \p from to \p to, if it is between the ends of both. */
double
SweptStrip::toEdge(const Vector3d& from, const Vector3d& to) const
{
  double best = infinity;
  const auto look = [&](const Vector2d& a, const Vector2d& b, const auto& passes) {
    if (const double t = footShare(a, b); t > 0.0 && t < 1.0 && passes(t))
      best = std::min(best, (a + t * (b - a)).squaredNorm());
  };
  for (const Vector2d& corner : {Vector2d(0.0, 0.0), Vector2d(length_, rise_)})
    look({from.x() - corner.x(), from.y()}, {to.x() - corner.x(), to.y()},
         [&](double t) { return from.z() + t * (to.z() - from.z()) >= corner.y(); });
  const double lower = std::hypot(length_, rise_), c = length_ / lower, s = rise_ / lower;
  look({c * from.z() - s * from.x(), from.y()}, {c * to.z() - s * to.x(), to.y()}, [&](double t) {
    const double along = c * from.x() + s * from.z() + t * (c * (to.x() - from.x()) + s * (to.z() - from.z()));
    return along >= 0.0 && along <= lower;
  });
  return best;
}

double
SweptStrip::toTriangle(const Matrix3d& corners) const
{
  if (meets(corners))
    return 0.0;
  double best = infinity;
  for (int k = 0; k < 3; ++k)
    best = std::min({best, toPlace(corners.col(k)), toEdge(corners.col(k), corners.col((k + 1) % 3))});
  for (const Vector3d& corner : {Vector3d(0.0, 0.0, 0.0), Vector3d(length_, 0.0, rise_)})
    best = std::min(best, (corners * nearestOnTriangle(corners, corner) - corner).squaredNorm());
  return best;
}

} // namespace pcl_spiral
