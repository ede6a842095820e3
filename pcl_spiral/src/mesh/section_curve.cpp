// SPDX-License-Identifier: BSD-3-Clause
#include "section_curve.h"

#include <pcl_spiral/core/impl/parabola_edge.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

using Eigen::Vector3d;

namespace {

constexpr double same_place = 1e-6; // mm

} // namespace

SectionCurve::SectionCurve(const SurfaceMesh& mesh, const SectionSettings& settings, const Vector3d& normal,
                           const std::vector<double>& distances)
: mesh_(mesh), settings_(settings), normal_(normal), distances_(distances)
{}

/** Barycentric coordinates, in its face, of the place where the edge's parabola crosses the plane. */
Vector3d
SectionCurve::atCrossing(std::uint32_t h, double level) const
{
  const Triangulation& mesh = mesh_.triangles();
  const double u = parabolaCrossing(distances_[mesh.origin(h)], distances_[mesh.target(h)], normal_.dot(mesh_.bow(h)), level);
  Vector3d b = Vector3d::Zero();
  b[h % 3] = 1.0 - u;
  b[(h + 1) % 3] = u;
  return b;
}

/** The contact there, its normal blended from both ends and across the parabola. */
DrivePoint
SectionCurve::onEdge(std::uint32_t h, const Vector3d& b) const
{
  const MeshPatch patch = mesh_.patch(h / 3);
  const int i = h % 3, j = (h + 1) % 3;
  const Vector3d tangent = patch.corners.col(j) - patch.corners.col(i) - patch.bows.col(i) * (b[i] - b[j]);
  const Vector3d blend = patch.normals * b;
  DrivePoint point{patch.position(b), settings_.axis.normalized(), blend};
  if (tangent.squaredNorm() > 0.0)
    point.normal -= tangent * (tangent.dot(blend) / tangent.squaredNorm());
  point.normal.normalize();
  return point;
}

/** Barycentric coordinates of the place of the curved surface in the plane, between the crossings \p from and \p to: from the
 *  straight way towards the corner that lies alone on its side of the plane, a quadratic equation. If that is not within the
 *  face, the nearest place that is. */
Vector3d
SectionCurve::inPlane(const MeshPatch& patch, const Chord& chord, double share, double level) const
{
  const Vector3d b = (1.0 - share) * chord.from + share * chord.to;
  Vector3d w = Vector3d::Constant(-0.5);
  w[chord.apex] = 1.0;
  const auto value = [&](double s) { return normal_.dot(patch.position(b + s * w)) - level; };
  const double q0 = value(0.0), plus = value(1.0), minus = value(-1.0);
  const double q1 = 0.5 * (plus - minus), q2 = 0.5 * (plus + minus) - q0;
  const double discriminant = q1 * q1 - 4.0 * q2 * q0;
  const double q = q1 + std::copysign(std::sqrt(std::max(0.0, discriminant)), q1);
  const double others = std::min(b[(chord.apex + 1) % 3], b[(chord.apex + 2) % 3]);
  const double low = -b[chord.apex], high = 2.0 * std::max(0.0, others);
  const double near = discriminant < 0.0 ? -0.5 * q1 / q2 : q != 0.0 ? -2.0 * q0 / q : 0.0; // to the straight way, or to the plane
  const double far = q2 != 0.0 && discriminant >= 0.0 ? -0.5 * q / q2 : near;
  const bool is_far = (near < low || near > high) && far >= low && far <= high;
  return b + (is_far ? far : std::clamp(near, low, high)) * w;
}

void
SectionCurve::add(const DrivePoint& point, DrivePass& pass) const
{
  constexpr double same_normal = 1e-8; // squared
  if (!pass.points.empty() && (point.position - pass.points.back().position).norm() < same_place &&
      (point.normal - pass.points.back().normal).squaredNorm() < same_normal)
    return;
  pass.points.push_back(point);
}

void
SectionCurve::addInside(std::uint32_t face, const Chord& chord, double level, DrivePass& pass) const
{
  const MeshPatch patch = mesh_.patch(face);
  const Vector3d begin = patch.position(chord.from), end = patch.position(chord.to);
  double parts = 1.0;
  if (mesh_.sag(face) > 0.0) {
    const Vector3d middle = patch.position(inPlane(patch, chord, 0.5, level));
    // The section is nearly a parabola, so the error of its chords falls with the square of their number.
    parts = std::sqrt((middle - 0.5 * (begin + end)).norm() / settings_.chord_error);
  }
  if (settings_.point_spacing > 0.0)
    parts = std::max(parts, (end - begin).norm() / settings_.point_spacing);
  const int count = static_cast<int>(std::ceil(parts - 1e-9));
  for (int k = 1; k < count; ++k) {
    const Vector3d b = inPlane(patch, chord, static_cast<double>(k) / count, level);
    add({patch.position(b), settings_.axis.normalized(), patch.normal(b)}, pass);
  }
}

DrivePass
SectionCurve::contacts(const LevelLine& line, double level, std::size_t& inside) const
{
  DrivePass pass;
  pass.closed = line.closed;
  const Triangulation& mesh = mesh_.triangles();
  const std::size_t n = line.crossings.size(), faces = line.closed ? n : n - 1;
  for (std::size_t i = 0; i < faces; ++i) {
    const std::uint32_t in = i == 0 ? line.crossings[0].half_edge : mesh.opposite(line.crossings[i].half_edge);
    const std::uint32_t out = i + 1 < n ? line.crossings[i + 1].half_edge : mesh.opposite(line.crossings[0].half_edge);
    const Vector3d from = atCrossing(in, level), to = atCrossing(out, level);
    add(onEdge(in, from), pass);
    const std::size_t before = pass.points.size();
    // The corner alone on its side of the plane belongs to both edges.
    const int apex = static_cast<int>(in % 3 == out % 3 || in % 3 == (out + 1) % 3 ? in % 3 : (in + 1) % 3);
    addInside(in / 3, {from, to, apex}, level, pass);
    inside += pass.points.size() - before;
    add(onEdge(out, to), pass);
  }
  if (pass.closed && pass.points.size() > 1 && (pass.points.front().position - pass.points.back().position).norm() < same_place)
    pass.points.pop_back();
  return pass;
}

} // namespace pcl_spiral
