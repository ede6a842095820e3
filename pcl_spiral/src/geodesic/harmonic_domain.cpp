// SPDX-License-Identifier: BSD-3-Clause
#include "harmonic_domain.h"

#include "centre_disc.h"

#include <algorithm>
#include <unordered_map>

namespace pcl_spiral {
namespace {

using Edge = HarmonicDomain::Edge;
using Loops = std::vector<std::vector<std::uint32_t>>;
constexpr double pocket_in_spacings = 12.0; // longest perimeter of a gap that lines cross straight

std::vector<std::uint8_t>
marked(std::size_t size, const std::vector<std::uint32_t>& which)
{
  std::vector<std::uint8_t> mark(size, 0);
  for (const std::uint32_t i : which)
    mark[i] = 1;
  return mark;
}

/** The loop with most of the marked points; none if it has less than half of them. */
std::size_t
loopOf(const Triangulation& mesh, const Loops& loops, const std::vector<std::uint32_t>& points, const std::vector<std::uint8_t>& mark)
{
  std::size_t best = loops.size(), most = 0;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const auto count = std::count_if(loops[l].begin(), loops[l].end(), [&](auto h) { return mark[mesh.origin(h)]; });
    if (count > static_cast<std::ptrdiff_t>(most)) {
      most = static_cast<std::size_t>(count);
      best = l;
    }
  }
  return 2 * most >= points.size() ? best : loops.size();
}

double
perimeter(const SurfaceGraph& graph, const std::vector<std::uint32_t>& loop)
{
  double sum = 0.0;
  for (const std::uint32_t h : loop)
    sum += (graph.position(graph.triangulation().target(h)) - graph.position(graph.triangulation().origin(h))).norm();
  return sum;
}

/** The boundary loops, split where they touch themselves: a pocket at the rim is a gap of its own. */
Loops
simpleLoops(const Triangulation& mesh)
{
  Loops result;
  std::unordered_map<std::uint32_t, std::size_t> place;
  for (const auto& loop : mesh.boundaryLoops()) {
    std::vector<std::uint32_t> open;
    place.clear();
    for (const std::uint32_t h : loop) {
      const auto seen = place.find(mesh.origin(h));
      if (seen != place.end() && seen->second < open.size() && mesh.origin(open[seen->second]) == mesh.origin(h)) {
        result.emplace_back(open.begin() + static_cast<std::ptrdiff_t>(seen->second), open.end());
        open.resize(seen->second);
      }
      place[mesh.origin(h)] = open.size();
      open.push_back(h);
    }
    result.push_back(open);
  }
  return result;
}

/** Cut the surface along the shortest row of triangles from \p starts to the rim. A start is a triangle, entered through
 *  the half-edge beside it, or none for the triangle about the centre. */
bool
cutToRim(const Triangulation& mesh, const std::vector<std::uint32_t>& starts, std::uint32_t start_triangle, HarmonicDomain& domain)
{
  constexpr std::uint32_t unseen = Triangulation::none, root = Triangulation::none - 1;
  std::vector<std::uint32_t> from(mesh.triangleCount(), unseen), queue; // half-edge a triangle was entered through
  const auto enter = [&](std::uint32_t t, std::uint32_t through) {
    if (from[t] != unseen)
      return;
    from[t] = through;
    queue.push_back(t);
  };
  if (start_triangle != Triangulation::none)
    enter(start_triangle, root);
  for (const std::uint32_t h : starts)
    enter(h / 3, h);
  domain.cut.assign(mesh.halfEdgeCount(), 0);
  for (std::size_t at = 0; at < queue.size(); ++at) {
    const std::uint32_t t = queue[at];
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      if (mesh.opposite(h) != Triangulation::none) {
        enter(mesh.opposite(h) / 3, mesh.opposite(h));
        continue;
      }
      if (domain.kind[h] != Edge::Rim)
        continue;
      for (std::uint32_t out = h;;) { // back along the row to the start
        domain.cut[out] = 1;
        const std::uint32_t in = from[out / 3];
        if (in == root)
          return true;
        domain.cut[in] = -1;
        out = mesh.opposite(in);
        if (out == Triangulation::none)
          return true;
      }
    }
  }
  return false;
}

/** Sort the loops into rim, inner and gaps. */
Status
classify(const SurfaceGraph& graph, const std::vector<std::uint32_t>& inner_points, const std::vector<std::uint32_t>& rim_points,
         HarmonicDomain& domain, std::vector<std::uint32_t>& inner)
{
  const Triangulation& mesh = graph.triangulation();
  for (const auto* points : {&inner_points, &rim_points})
    for (const std::uint32_t i : *points)
      if (i >= graph.size())
        return {StatusCode::InvalidArgument, Diagnostic("point ", i, " of a boundary is outside the cloud of ", graph.size(), " points")};
  const Loops loops = simpleLoops(mesh);
  const auto on_rim = marked(graph.size(), rim_points), on_inner = marked(graph.size(), inner_points);
  const std::size_t rim = loopOf(mesh, loops, rim_points, on_rim);
  if (rim_points.size() < 3 || rim == loops.size())
    return {StatusCode::InvalidArgument, Diagnostic("the ", rim_points.size(),
                                                    " rim points are not the points of one boundary loop of the surface: "
                                                    "give the points of the outer loop, in the order of the graph")};
  const std::size_t hole = inner_points.empty() ? loops.size() : loopOf(mesh, loops, inner_points, on_inner);
  if (!inner_points.empty() && (hole == loops.size() || hole == rim))
    return {StatusCode::InvalidArgument, Diagnostic("the ", inner_points.size(),
                                                    " inner points are not the points of one inner loop of the surface: "
                                                    "give the points of the inner loop, in the order of the graph")};
  std::vector<std::size_t> sizes;
  const auto part = mesh.parts(sizes);
  const std::uint32_t own = part[loops[rim][0] / 3];
  domain.kind.assign(mesh.halfEdgeCount(), Edge::Elsewhere);
  domain.edges.clear();
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    if (part[h / 3] == own) {
      domain.kind[h] = Edge::Inside;
      if (mesh.opposite(h) == Triangulation::none || h < mesh.opposite(h))
        domain.edges.push_back(h);
    }
  domain.rim = loops[rim];
  domain.gaps.clear();
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (part[loops[l][0] / 3] != own)
      continue;
    Edge kind = l == rim ? Edge::Rim : l == hole ? Edge::Inner : Edge::Gap;
    if (kind == Edge::Gap && perimeter(graph, loops[l]) < pocket_in_spacings * graph.spacing()) {
      kind = Edge::Pocket;
      for (std::size_t k = 0; k < loops[l].size(); ++k)
        domain.after[loops[l][k]] = loops[l][(k + 1) % loops[l].size()];
    }
    if (kind == Edge::Gap)
      domain.gaps.push_back(loops[l]);
    for (const std::uint32_t h : loops[l])
      domain.kind[h] = kind;
  }
  inner = hole < loops.size() ? loops[hole] : std::vector<std::uint32_t>();
  return Status::success();
}

const Status apart(StatusCode::Failed, "the surface between the middle and the rim is in several parts that do not "
                                       "touch: close the gaps, or thin less");

} // namespace

Status
makeDomain(const SurfaceGraph& graph, const Eigen::Vector3d& centre, const std::vector<std::uint32_t>& rim_points, HarmonicDomain& domain)
{
  std::vector<std::uint32_t> inner;
  const Status status = classify(graph, {}, rim_points, domain, inner);
  if (!status.ok())
    return status;
  domain.centre = centre;
  const std::uint32_t triangle = triangleAt(graph, centre);
  if (triangle == Triangulation::none || domain.kind[3 * triangle] == Edge::Elsewhere)
    return {StatusCode::InvalidArgument, "the centre is not on the surface inside the rim: move it there, "
                                         "away from gaps"};
  return cutToRim(graph.triangulation(), {}, triangle, domain) ? makeCentreDisc(graph, triangle, domain) : apart;
}

Status
makeDomain(const SurfaceGraph& graph, const std::vector<std::uint32_t>& inner_points, const std::vector<std::uint32_t>& rim_points,
           HarmonicDomain& domain)
{
  std::vector<std::uint32_t> inner;
  if (inner_points.empty())
    return {StatusCode::InvalidArgument, "no inner points were given: give the points of the inner loop, or a centre"};
  const Status status = classify(graph, inner_points, rim_points, domain, inner);
  if (!status.ok())
    return status;
  domain.in_disc.assign(graph.size(), 0);
  return cutToRim(graph.triangulation(), inner, Triangulation::none, domain) ? Status::success() : apart;
}

} // namespace pcl_spiral
