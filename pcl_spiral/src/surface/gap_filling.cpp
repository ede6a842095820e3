// SPDX-License-Identifier: BSD-3-Clause
#include "gap_filling.h"

#include "core/cubic_terms.h"
#include <pcl_spiral/core/impl/frame.h>

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

/** A gap's own frame: origin at its centre, third axis along the mean normal of its rim. */
struct GapFrame {
  Eigen::Vector3d origin, e1, e2, up;
  double radius;

  Eigen::Vector3d local(const Eigen::Vector3d& p) const
  {
    const Eigen::Vector3d d = p - origin;
    return {d.dot(e1), d.dot(e2), d.dot(up)};
  }
};

GapFrame
frameOf(const SurfaceGraph& graph, const Polyline& loop)
{
  GapFrame frame;
  frame.origin.setZero();
  const double around = length(loop, true);
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < loop.size(); ++k) { // by length, because the points of the loop are not evenly spread
    const Eigen::Vector3d &p = loop[k], &next = loop[(k + 1) % loop.size()];
    frame.origin += 0.5 * (p + next) * ((next - p).norm() / around);
    normal += graph.normal(graph.blocks().nearest(p));
  }
  frame.up = normal.normalized();
  tangentFrame(frame.up, frame.e1, frame.e2);
  frame.radius = 0.0;
  for (const Eigen::Vector3d& p : loop)
    frame.radius = std::max(frame.radius, (p - frame.origin).norm());
  return frame;
}

/** The cloud around the gap, in the gap's frame. */
std::vector<Eigen::Vector3d>
pointsAbout(const SurfaceGraph& graph, const GapFrame& frame)
{
  const double reach = 2.0 * frame.radius + 4.0 * graph.spacing();
  Box box;
  const Eigen::Vector3f centre = frame.origin.cast<float>();
  box.extend(centre.data());
  std::vector<Eigen::Vector3d> about;
  graph.blocks().forBlocksNear(box, static_cast<float>(reach * reach), [&](std::size_t block) {
    for (std::size_t i = graph.blocks().blockBegin(block); i < graph.blocks().blockEnd(block); ++i)
      if ((graph.position(i) - frame.origin).norm() <= reach && graph.normal(i).dot(frame.up) > 0.0)
        about.push_back(frame.local(graph.position(i)));
  });
  return about;
}

bool
insidePolygon(const std::vector<Eigen::Vector3d>& polygon, double u, double v)
{
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Eigen::Vector3d &a = polygon[i], &b = polygon[j];
    if ((a.y() > v) != (b.y() > v) && u < a.x() + (b.x() - a.x()) * (v - a.y()) / (b.y() - a.y()))
      inside = !inside;
  }
  return inside;
}

double
distanceTo(const std::vector<Eigen::Vector3d>& polygon, const Eigen::Vector2d& p)
{
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Eigen::Vector2d a = polygon[j].head<2>(), d = polygon[i].head<2>() - a;
    const double share = d.squaredNorm() > 0.0 ? std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0.0;
    least = std::min(least, (a + share * d - p).norm());
  }
  return least;
}

} // namespace

std::size_t
pointsInside(const SurfaceGraph& graph, const Polyline& loop)
{
  constexpr double depth = 1.5; // spacings from the loop
  if (loop.size() < 3)
    return 0;
  const GapFrame frame = frameOf(graph, loop);
  std::vector<Eigen::Vector3d> polygon;
  for (const Eigen::Vector3d& p : loop)
    polygon.push_back(frame.local(p));
  const std::vector<Eigen::Vector3d> about = pointsAbout(graph, frame);
  return static_cast<std::size_t>(std::count_if(about.begin(), about.end(), [&](const Eigen::Vector3d& p) {
    return insidePolygon(polygon, p.x(), p.y()) && distanceTo(polygon, p.head<2>()) > depth * graph.spacing();
  }));
}

GapFill
fillGap(const SurfaceGraph& graph, const Polyline& loop)
{
  GapFill fill;
  if (loop.size() < 3)
    return fill;
  const GapFrame frame = frameOf(graph, loop);
  fill.centre = frame.origin;
  for (const Eigen::Vector3d& p : loop)
    for (const Eigen::Vector3d& q : loop)
      fill.width = std::max(fill.width, (p - q).norm());
  const std::vector<Eigen::Vector3d> about = pointsAbout(graph, frame);
  if (about.size() < 3 * cubic_term_count)
    return fill;
  Eigen::MatrixXd matrix(about.size(), cubic_term_count);
  Eigen::VectorXd height(about.size());
  for (std::size_t i = 0; i < about.size(); ++i) {
    matrix.row(i) = cubicTerms(about[i].x() / frame.radius, about[i].y() / frame.radius);
    height[i] = about[i].z();
  }
  const Eigen::VectorXd coefficients = matrix.colPivHouseholderQr().solve(height);
  fill.residual = std::sqrt((matrix * coefficients - height).squaredNorm() / static_cast<double>(about.size()));

  std::vector<Eigen::Vector3d> polygon;
  for (const Eigen::Vector3d& p : loop)
    polygon.push_back(frame.local(p));
  // An equilateral lattice with the density of the cloud, away from the points of the gap.
  const double pitch = graph.spacing() * std::sqrt(2.0 / std::sqrt(3.0)), row = pitch * std::sqrt(3.0) / 2.0;
  const int rows = static_cast<int>(std::ceil(frame.radius / row));
  const int columns = static_cast<int>(std::ceil(frame.radius / pitch)) + 1;
  for (int j = -rows; j <= rows; ++j)
    for (int i = -columns; i <= columns; ++i) {
      const double u = (i + 0.5 * (j & 1)) * pitch, v = j * row;
      if (!insidePolygon(polygon, u, v))
        continue;
      const bool clear = std::all_of(polygon.begin(), polygon.end(),
                                     [&](const Eigen::Vector3d& p) { return std::hypot(p.x() - u, p.y() - v) > 0.5 * pitch; });
      if (!clear)
        continue;
      const double w = (cubicTerms(u / frame.radius, v / frame.radius) * coefficients)(0);
      fill.points.push_back((frame.origin + u * frame.e1 + v * frame.e2 + w * frame.up).cast<float>());
    }
  return fill;
}

} // namespace pcl_spiral
