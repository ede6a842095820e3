#include "taubin_curvature.h"

#include <pcl_spiral/core/frame.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** Curvature along a direction of the tangent plane. */
struct Section {
  double angle, curvature;
};

/** The angle each section stands for, as a share of the whole: sections are in order of their angles. */
double
weight(const std::vector<Section>& sections, std::size_t j)
{
  const std::size_t n = sections.size();
  const double before = j > 0 ? sections[j - 1].angle : sections[n - 1].angle - 2.0 * M_PI;
  const double after = j + 1 < n ? sections[j + 1].angle : sections[0].angle + 2.0 * M_PI;
  return (after - before) / (4.0 * M_PI);
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
    const double x = d.dot(e1), y = d.dot(e2);
    if (x != 0.0 || y != 0.0)
      sections.push_back({std::atan2(y, x), -2.0 * normal.dot(d) / d.squaredNorm()});
  }
  if (sections.size() < 3)
    return std::nullopt;
  std::sort(sections.begin(), sections.end(), [](const Section& a, const Section& b) { return a.angle < b.angle; });
  double m11 = 0.0, m12 = 0.0, m22 = 0.0; // of M
  for (std::size_t j = 0; j < sections.size(); ++j) {
    const double c = std::cos(sections[j].angle), s = std::sin(sections[j].angle);
    const double weighted = weight(sections, j) * sections[j].curvature;
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
