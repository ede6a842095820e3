// SPDX-License-Identifier: BSD-3-Clause
#include "ridge_edges.h"

#include "ridge_climb.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <utility>

namespace pcl_spiral {
namespace {

/** Change of the slope along an edge, in step-overs a step-over, above which a ridge crosses it: 2 sin 7 degrees, of fronts that meet at
 *  14 degrees across the edge. Measured: with 0.12 and 0.35 the table of outlines is the same to its third figure. */
constexpr double least_change = 0.2437;
/** Share of an edge within which its end stands for the crossing. Measured before there were nodes halfway: highest scallops of the table
 *  of outlines, in the mean, 1.127 h with 0.05, 1.132 with 0.1, 1.159 with 0.2. */
constexpr double at_node = 0.05;

using Triangle = Triangulation::Triangle;
constexpr std::uint32_t none = Triangulation::none;

/** Adds nodes on ridges, and cuts the triangles about them. */
class RidgeCutter {
public:
  RidgeCutter(StepOverMesh mesh, MarchedDistances& marched, std::vector<std::uint8_t>& may_cross)
  : mesh_(std::move(mesh)), marched_(marched), may_cross_(may_cross), is_crossed_(mesh_.triangles.triangleCount(), 0)
  {}

  StepOverMesh run()
  {
    const std::size_t before = mesh_.size();
    addCrossings();
    if (mesh_.size() == before)
      return std::move(mesh_);
    triangles_.reserve(mesh_.triangles.triangleCount() + 4 * (mesh_.size() - before));
    for (std::uint32_t i = 0; i < mesh_.triangles.triangleCount(); ++i)
      cut(i);
    mesh_.triangles = Triangulation(); // not beside the new one
    mesh_.triangles = Triangulation(mesh_.size(), std::move(triangles_));
    return std::move(mesh_);
  }

private:
  bool isOnRim(std::uint32_t v) const { return marched_.over[v][0] == none; }

  /** Gradient of the distance, a mm, in the triangle or along the edge through which the front came to node \p v. */
  Eigen::Vector3d frontAt(std::uint32_t v) const
  {
    const auto [i, j] = marched_.over[v];
    const Eigen::Vector3d a = mesh_.positions[v] - mesh_.positions[i];
    const double rise = marched_.distance[v] - marched_.distance[i];
    if (i == j) { // uphill in the metric G the gradient is along G a
      const Eigen::Vector3d g = between(mesh_.metric[i], mesh_.metric[v], 0.5).matrix() * a;
      return rise / a.dot(g) * g;
    }
    const Eigen::Vector3d side = mesh_.positions[j] - mesh_.positions[i], n = side.cross(a);
    return ((marched_.distance[j] - marched_.distance[i]) * a.cross(n) + rise * n.cross(side)) / n.squaredNorm();
  }

  void addCrossings()
  {
    const Triangulation& t = mesh_.triangles;
    constexpr std::uint32_t together = 1 << 14; // half-edges
    std::vector<std::vector<std::pair<std::uint32_t, double>>> found((t.halfEdgeCount() + together - 1) / together);
    const auto blocks = static_cast<std::int64_t>(found.size());
#pragma omp parallel for schedule(dynamic)
    for (std::int64_t block = 0; block < blocks; ++block) {
      const auto begin = static_cast<std::uint32_t>(block) * together;
      const auto end = static_cast<std::uint32_t>(std::min<std::size_t>(t.halfEdgeCount(), begin + std::size_t{together}));
      for (std::uint32_t h = begin; h < end; ++h)
        if (const std::uint32_t opposite = t.opposite(h); opposite != none && h < opposite)
          if (const double share = crossingOn(t.origin(h), t.target(h)); share > 0.0)
            found[block].emplace_back(h, share);
    }
    std::size_t crossings = 0;
    for (const auto& block : found)
      crossings += block.size();
    reserve(mesh_.size() + 3 * crossings); // each is in two triangles, which may have a middle each
    for (const auto& block : found)
      for (const auto& [h, share] : block) {
        const std::uint32_t a = t.origin(h), b = t.target(h);
        const double height = marched_.distance[a] + share * frontAt(a).dot(mesh_.positions[b] - mesh_.positions[a]);
        const double length = edgeLength(mesh_, a, b); // no front rises by more than it, whatever a thin triangle says
        const double most = std::min(marched_.distance[a] + share * length, marched_.distance[b] + (1.0 - share) * length);
        const std::uint32_t node = add(a, b, share, std::min(height, most));
        for (const std::uint32_t side : {h, t.opposite(h)}) {
          on_edge_.emplace_back(side, node);
          is_crossed_[side / 3] = 1;
        }
      }
    std::sort(on_edge_.begin(), on_edge_.end());
  }

  void reserve(std::size_t nodes)
  {
    mesh_.positions.reserve(nodes);
    mesh_.normals.reserve(nodes);
    mesh_.metric.reserve(nodes);
    marched_.distance.reserve(nodes);
    marched_.over.reserve(nodes);
    may_cross_.reserve(nodes);
  }

  /** Share of the edge from \p a to \p b at which the fronts of its ends are equally far; 0 if no ridge crosses it. */
  double crossingOn(std::uint32_t a, std::uint32_t b) const
  {
    if (!may_cross_[a] || !may_cross_[b] || isOnRim(a) || isOnRim(b)) // no front came to a rim
      return 0.0;
    const Eigen::Vector3d edge = mesh_.positions[b] - mesh_.positions[a];
    const double from_a = frontAt(a).dot(edge), from_b = frontAt(b).dot(edge), change = from_a - from_b;
    if (!(change > least_change * edgeLength(mesh_, a, b)))
      return 0.0;
    const double share = (marched_.distance[b] - from_b - marched_.distance[a]) / change;
    return share > at_node && share < 1.0 - at_node ? share : 0.0;
  }

  std::uint32_t add(std::uint32_t a, std::uint32_t b, double share, double distance)
  {
    const Eigen::Vector3d position = (1.0 - share) * mesh_.positions[a] + share * mesh_.positions[b];
    const auto w = static_cast<float>(share);
    const Eigen::Vector3f normal = ((1.0f - w) * mesh_.normals[a] + w * mesh_.normals[b]).normalized();
    const StepOverMetric metric = between(mesh_.metric[a], mesh_.metric[b], share);
    mesh_.positions.push_back(position);
    mesh_.normals.push_back(normal);
    mesh_.metric.push_back(metric);
    marched_.distance.push_back(distance);
    marched_.over.push_back({none, none}); // they are not marched on from
    may_cross_.push_back(1);
    return static_cast<std::uint32_t>(mesh_.size() - 1);
  }

  /** The node on half-edge \p h, or none. */
  std::uint32_t nodeOn(std::uint32_t h) const
  {
    const auto at = std::lower_bound(on_edge_.begin(), on_edge_.end(), std::make_pair(h, std::uint32_t{0}));
    return at != on_edge_.end() && at->first == h ? at->second : none;
  }

  /** The triangles in place of triangle \p i. */
  void cut(std::uint32_t i)
  {
    const Triangle c = mesh_.triangles.triangle(i);
    if (!is_crossed_[i])
      return triangles_.push_back(c);
    const std::array<std::uint32_t, 3> on{nodeOn(3 * i), nodeOn(3 * i + 1), nodeOn(3 * i + 2)};
    const auto crossings = 3 - std::count(on.begin(), on.end(), none);
    if (crossings == 3) // ridges meet
      triangles_.insert(triangles_.end(), {{c[0], on[0], on[2]}, {on[0], c[1], on[1]}, {on[2], on[1], c[2]}, {on[0], on[1], on[2]}});
    else if (crossings == 1)
      cutThroughCorner(c, on, static_cast<std::size_t>(std::find_if(on.begin(), on.end(), [](auto v) { return v != none; }) - on.begin()));
    else
      cutAcross(c, on, static_cast<std::size_t>(std::find(on.begin(), on.end(), none) - on.begin()));
  }

  /** A ridge that ends here, or runs through the corner that faces edge \p k. */
  void cutThroughCorner(const Triangle& c, const std::array<std::uint32_t, 3>& on, std::size_t k)
  {
    const std::uint32_t a = c[k], b = c[(k + 1) % 3], top = c[(k + 2) % 3], p = on[k], m = middle(p, top);
    triangles_.insert(triangles_.end(), {{a, p, m}, {a, m, top}, {p, b, m}, {m, b, top}});
  }

  /** A ridge across the two edges other than \p k. */
  void cutAcross(const Triangle& c, const std::array<std::uint32_t, 3>& on, std::size_t k)
  {
    const std::uint32_t a = c[(k + 2) % 3], b = c[k], d = c[(k + 1) % 3];
    const std::uint32_t p = on[(k + 2) % 3], q = on[(k + 1) % 3], m = middle(p, q);
    triangles_.insert(triangles_.end(), {{a, p, m}, {a, m, q}, {p, b, m}, {b, d, m}, {d, q, m}});
  }

  /** Added because uncovered places on a ridge, where the tool must be led, may be as short as an eighth of a step-over. */
  std::uint32_t middle(std::uint32_t a, std::uint32_t b)
  {
    return add(a, b, 0.5, 0.5 * (marched_.distance[a] + marched_.distance[b]));
  }

  StepOverMesh mesh_;
  MarchedDistances& marched_;
  std::vector<std::uint8_t>& may_cross_;
  std::vector<std::uint8_t> is_crossed_;                         ///< one a triangle
  std::vector<std::pair<std::uint32_t, std::uint32_t>> on_edge_; ///< half-edges with the nodes on them, ascending
  std::vector<Triangle> triangles_;
};

} // namespace

StepOverMesh
withRidgeEdges(StepOverMesh mesh, MarchedDistances& marched, std::vector<std::uint8_t>& may_cross)
{
  return RidgeCutter(std::move(mesh), marched, may_cross).run();
}

} // namespace pcl_spiral
