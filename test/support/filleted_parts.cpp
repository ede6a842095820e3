// SPDX-License-Identifier: BSD-3-Clause
#include "support/filleted_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

double
cross(const Vector2d& a, const Vector2d& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/** The arc of \p radius that touches both lines of the corner \p at. */
RoundedProfile::Piece
arcAt(const Vector2d& before, const Vector2d& at, const Vector2d& after, double radius, double facet)
{
  const Vector2d u = (before - at).normalized(), v = (after - at).normalized();
  const double half = 0.5 * std::acos(u.dot(v)), tangent = radius / std::tan(half);
  RoundedProfile::Piece arc;
  arc.is_arc = true;
  arc.radius = radius;
  arc.centre = at + radius / std::sin(half) * (u + v).normalized();
  const Vector2d from = at + tangent * u - arc.centre, to = at + tangent * v - arc.centre;
  const double turn = std::atan2(cross(from, to), from.dot(to));
  const int count = std::max(1, static_cast<int>(std::ceil(std::abs(turn) / (facet * M_PI / 180.0) - 1e-6)));
  for (int i = 0; i <= count; ++i)
    arc.points.push_back(arc.centre + Eigen::Rotation2Dd(turn * i / count) * from);
  return arc;
}

double
distanceToArc(const RoundedProfile::Piece& arc, const Vector2d& at)
{
  const Vector2d from = arc.points.front() - arc.centre, to = arc.points.back() - arc.centre, p = at - arc.centre;
  const double side = cross(from, to) > 0.0 ? 1.0 : -1.0;
  if (side * cross(from, p) >= 0.0 && side * cross(p, to) >= 0.0)
    return std::abs(p.norm() - arc.radius);
  return std::min((p - from).norm(), (p - to).norm());
}

/** \p open: the ends of the line that go on. */
double
distanceToLine(const Vector2d& from, const Vector2d& to, const Vector2d& at, bool open_begin, bool open_end)
{
  const Vector2d d = to - from;
  double u = (at - from).dot(d) / d.squaredNorm();
  if (!open_begin)
    u = std::max(0.0, u);
  if (!open_end)
    u = std::min(1.0, u);
  return (from + u * d - at).norm();
}

/** Stations of the guide: a place on it and the direction in which r is measured. */
std::vector<std::pair<Vector2d, Vector2d>>
stationsOf(const SweepGuide& guide)
{
  std::vector<std::pair<Vector2d, Vector2d>> stations;
  if (guide.form == SweepGuide::Form::Line) {
    for (int i = 0; i <= guide.parts; ++i)
      stations.push_back({Vector2d(0.0, guide.half.y() * (2.0 * i / guide.parts - 1.0)), Vector2d::UnitX()});
    return stations;
  }
  const int count = static_cast<int>(std::lround(90.0 / guide.facet));
  const bool circle = guide.half.isZero();
  for (int quarter = 0; quarter < 4; ++quarter)
    for (int i = 0; i <= (circle ? count - 1 : count); ++i) {
      const double angle = 0.5 * M_PI * (quarter + static_cast<double>(i) / count);
      const Vector2d sign(quarter == 0 || quarter == 3 ? 1.0 : -1.0, quarter < 2 ? 1.0 : -1.0);
      stations.push_back({sign.cwiseProduct(guide.half), Vector2d(std::cos(angle), std::sin(angle))});
    }
  return stations;
}

} // namespace

RoundedProfile::RoundedProfile(const std::vector<Corner>& corners, double facet)
{
  Vector2d end = corners.front().at;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    Piece arc, line;
    if (i + 1 < corners.size())
      arc = arcAt(corners[i - 1].at, corners[i].at, corners[i + 1].at, corners[i].radius, facet);
    const Vector2d to = i + 1 < corners.size() ? arc.points.front() : corners[i].at;
    if ((to - end).norm() > 1e-6) { // none where two arcs meet
      line.points = {end, to};
      pieces_.push_back(line);
    }
    if (i + 1 < corners.size()) {
      end = arc.points.back();
      pieces_.push_back(arc);
    }
  }
}

double
RoundedProfile::distance(const Vector2d& at) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces_)
    least = std::min(least, piece.is_arc ? distanceToArc(piece, at)
                                         : distanceToLine(piece.points.front(), piece.points.back(), at, &piece == &pieces_.front(),
                                                          &piece == &pieces_.back()));
  return least;
}

double
FilletedPart::distance(const Vector3d& at) const
{
  const Vector3d p = placed.inverse() * at;
  if (guide.form == SweepGuide::Form::Line)
    return profile.distance({p.x(), p.z()});
  const Vector2d q = p.head<2>().cwiseAbs() - guide.half;
  const double r = q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
  return profile.distance({r, p.z()});
}

FilletedPart
sweptPart(const RoundedProfile& profile, const SweepGuide& guide)
{
  FilletedPart part{{}, {}, profile, guide};
  const auto stations = stationsOf(guide);
  const bool closed = guide.form == SweepGuide::Form::Rectangle;
  std::vector<Vector2d> points{profile.pieces().front().points.front()};
  std::vector<const RoundedProfile::Piece*> pieces;
  for (const auto& piece : profile.pieces())
    for (std::size_t i = 1; i < piece.points.size(); ++i) {
      points.push_back(piece.points[i]);
      pieces.push_back(&piece);
    }
  const auto rows = static_cast<std::uint32_t>(points.size()), columns = static_cast<std::uint32_t>(stations.size());
  for (const auto& [place, direction] : stations)
    for (const Vector2d& p : points) {
      const Vector2d plan = place + p.x() * direction;
      part.mesh.vertices.push_back({plan.x(), plan.y(), p.y()});
    }
  for (std::uint32_t c = 0; c + (closed ? 0 : 1) < columns; ++c)
    for (std::uint32_t i = 0; i + 1 < rows; ++i) {
      const std::uint32_t c1 = (c + 1) % columns, a = c * rows + i, b = c1 * rows + i;
      const RoundedProfile::Piece& piece = *pieces[i];
      const bool level = std::abs(piece.points.front().y() - piece.points.back().y()) < 1e-9;
      const bool straight = stations[c].second.dot(stations[c1].second) > 1.0 - 1e-12;
      part.mesh.faces.push_back({a, a + 1, b + 1});
      part.mesh.faces.push_back({a, b + 1, b});
      part.is_flat.insert(part.is_flat.end(), 2, !piece.is_arc && (level || straight));
    }
  if (closed) { // the floor or top inside of the first point
    const auto middle = static_cast<std::uint32_t>(part.mesh.vertices.size());
    if (guide.split_floor)
      part.mesh.vertices.push_back({0.0, 0.0, points.front().y()});
    for (std::uint32_t c = guide.split_floor ? 0 : 1; c + (guide.split_floor ? 0 : 1) < columns; ++c) {
      part.mesh.faces.push_back({guide.split_floor ? middle : 0, c * rows, (c + 1) % columns * rows});
      part.is_flat.push_back(1);
    }
  }
  return part;
}

FilletedPart
placedPart(FilletedPart part, const Eigen::Isometry3d& by)
{
  for (Vector3d& v : part.mesh.vertices)
    v = by * v;
  part.placed = by * part.placed;
  return part;
}

} // namespace pcl_spiral::test
