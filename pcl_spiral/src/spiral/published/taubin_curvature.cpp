// SPDX-License-Identifier: BSD-3-Clause
#include "taubin_curvature.h"

#include <pcl_spiral/core/impl/frame.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** Curvature along a direction of the tangent plane. */
struct Section {
  Eigen::Vector2d along; ///< to the neighbour
  double angle, curvature;
  double weight = 0.0;
};

/** The area of the triangle between each section and the next counts for both. \return the sum of the
 *  weights. */
double
weigh(std::vector<Section>& sections)
{
  double whole = 0.0;
  for (std::size_t j = 0; j < sections.size(); ++j) {
    Section &a = sections[j], &b = sections[(j + 1) % sections.size()];
    const double twice = a.along.x() * b.along.y() - a.along.y() * b.along.x(); // not positive across half a turn
    if (twice <= 0.0)
      continue;
    a.weight += twice;
    b.weight += twice;
    whole += 2.0 * twice;
  }
  return whole;
}

} // namespace

std::optional<PrincipalCurvatures>
taubinCurvatures(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, const Polyline& neighbours)
{
  Eigen::Vector3d e1, e2;
  tangentFrame(normal, e1, e2);
  std::vector<Section> sections;
  for (const Eigen::Vector3d& p : neighbours) {
    const Eigen::Vector3d d = p - point;
    const Eigen::Vector2d along(d.dot(e1), d.dot(e2));
    if (!along.isZero(0.0))
      sections.push_back({along, std::atan2(along.y(), along.x()), -2.0 * normal.dot(d) / d.squaredNorm()});
  }
  std::sort(sections.begin(), sections.end(), [](const Section& a, const Section& b) { return a.angle < b.angle; });
  const double whole = weigh(sections);
  if (sections.size() < 3 || !(whole > 0.0))
    return std::nullopt;
  double m11 = 0.0, m12 = 0.0, m22 = 0.0; // of M
  for (const Section& section : sections) {
    const double c = std::cos(section.angle), s = std::sin(section.angle);
    const double weighted = section.weight / whole * section.curvature;
    m11 += weighted * c * c;
    m12 += weighted * c * s;
    m22 += weighted * s * s;
  }
  const double middle = 0.5 * (m11 + m22), half = 0.5 * (m11 - m22), spread = std::hypot(half, m12);
  const double m1 = middle + spread, m2 = middle - spread, angle = spread > 0.0 ? 0.5 * std::atan2(m12, half) : 0.0;
  return PrincipalCurvatures{3.0 * m1 - m2, 3.0 * m2 - m1, std::cos(angle) * e1 + std::sin(angle) * e2}; // (12)
}

std::optional<PrincipalCurvatures>
taubinCurvatures(const SurfaceGraph& graph, const NeighbourLists& edges, std::uint32_t i)
{
  Polyline neighbours;
  for (const std::uint32_t j : edges[i])
    neighbours.push_back(graph.position(j));
  return taubinCurvatures(graph.position(i), graph.normal(i), neighbours);
}

} // namespace pcl_spiral
