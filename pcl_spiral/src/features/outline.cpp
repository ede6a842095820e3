// SPDX-License-Identifier: BSD-3-Clause
#include "outline.h"

#include "corner_choice.h"
#include "near_points.h"

#include "core/self_crossing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr int most_draws = 12;     // steps by which a node outside the known surface is drawn back
constexpr double draw_step = 0.25; // spacings

/** Whether the surface is known at \p foot and around it, so that it is known between such places too: fits reach 1.25
 *  spacings beyond the outermost points. */
bool
isWellKnown(const SurfaceGraph& graph, const SurfaceFoot& foot)
{
  constexpr double farthest = 1.1; // spacings there
  return foot.valid && foot.overhang <= farthest * graph.spacing(graph.blocks().nearest(foot.position));
}

/** Move a corner in to \p position and leave out the nodes of its sides that now lie beyond it. */
void
drawIn(OutlineDraft& draft, std::size_t c, const Eigen::Vector3d& position, const Eigen::Vector3d& outward)
{
  Corner& corner = draft.corners[c];
  corner.position = position;
  const auto beyond = [&](const Eigen::Vector3d& node) { return (node - position).dot(outward) > 0.0; };
  const Polyline &before = draft.sides[draft.preceding(c)].side.nodes, &after = draft.sides[c].side.nodes;
  while (corner.cut_before < before.size() / 2 && beyond(before[before.size() - 1 - corner.cut_before]))
    ++corner.cut_before;
  while (corner.cut_after < after.size() / 2 && beyond(after[corner.cut_after]))
    ++corner.cut_after;
}

/** Draw corners far beyond the outermost points back between their sides. Sides that curve towards a rounded tip, fitted
 *  less sharply, meet beyond it. */
void
drawInCorners(OutlineDraft& draft)
{
  constexpr double farthest = 1.6; // spacings past the outermost point
  std::vector<Eigen::Vector3d> outward(draft.corners.size());
  Polyline queries;
  for (std::size_t c = 0; c < draft.corners.size(); ++c) {
    const Polyline before = draft.trimmed(draft.preceding(c)).nodes, after = draft.trimmed(c).nodes;
    const std::size_t k = std::min<std::size_t>(4, std::min(before.size(), after.size()) - 1);
    const Eigen::Vector3d inner = 0.5 * (before[before.size() - 1 - k] + after[k]), tip = draft.corners[c].position;
    outward[c] = (tip - inner).normalized();
    for (int i = 0; i <= most_draws; ++i)
      queries.push_back(tip - i * draw_step * draft.spacing() * outward[c]);
  }
  std::vector<SurfaceFoot> feet;
  draft.surface().project(queries, feet);
  for (std::size_t c = 0; c < draft.corners.size(); ++c) {
    const auto begin = feet.begin() + static_cast<std::ptrdiff_t>(c * (most_draws + 1)), end = begin + most_draws + 1;
    const auto known = std::find_if(begin, end, [&](const SurfaceFoot& foot) {
      return isWellKnown(draft.surface().graph(), foot) && foot.overhang <= farthest * draft.spacing();
    });
    if (known == begin)
      draft.corners[c].position = known->position;
    else if (known != end)
      drawIn(draft, c, known->position, outward[c]);
  }
}

/** Put nodes on the surface. Draw back those outside the known surface: inwards, or, if that does not lead back to it
 *  (a side that runs off), towards the nearest point of the cloud. */
void
fallBack(const MlsSurface& surface, EdgeSide& side)
{
  const SurfaceGraph& graph = surface.graph();
  const double step = draw_step * graph.spacing();
  std::vector<std::size_t> open(side.nodes.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  const auto draw = [&](const auto& place) { // in up to most_draws steps, to the first place that is known
    for (int k = 0; k <= most_draws && !open.empty(); ++k) {
      Polyline queries;
      for (const std::size_t i : open)
        queries.push_back(place(i, k));
      std::vector<SurfaceFoot> feet;
      surface.project(queries, feet);
      std::vector<std::uint8_t> known(open.size());
#pragma omp parallel for schedule(static)
      for (std::int64_t j = 0; j < static_cast<std::int64_t>(open.size()); ++j)
        known[j] = isWellKnown(graph, feet[j]);
      std::vector<std::size_t> still_open;
      for (std::size_t j = 0; j < open.size(); ++j)
        if (known[j])
          side.nodes[open[j]] = feet[j].position;
        else
          still_open.push_back(open[j]);
      open.swap(still_open);
    }
  };
  draw([&](std::size_t i, int k) { return Eigen::Vector3d(side.nodes[i] - k * step * side.outward[i]); });
  draw([&](std::size_t i, int k) {
    const Eigen::Vector3d nearest = graph.position(graph.blocks().nearest(side.nodes[i]));
    return Eigen::Vector3d(side.nodes[i] + k / static_cast<double>(most_draws) * (nearest - side.nodes[i]));
  });
}

/** The side after the corner nearest to the start of the ring. The next one along the ring would differ on a mirrored part. */
std::size_t
firstSide(const OutlineDraft& draft)
{
  const auto distance = [&](const Corner& corner) { return (corner.position - draft.points().front()).squaredNorm(); };
  const auto nearest = std::min_element(draft.corners.begin(), draft.corners.end(),
                                        [&](const Corner& a, const Corner& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - draft.corners.begin());
}

Outline
assembled(const OutlineDraft& draft)
{
  Outline outline;
  const std::size_t count = draft.sides.size(), first = firstSide(draft);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t s = (first + k) % count;
    EdgeSide side = draft.corners.empty() ? draft.sides[s].side : draft.trimmed(s);
    fallBack(draft.surface(), side);
    if (!side.closed)
      outline.corners.push_back(outline.curve.size());
    outline.curve.insert(outline.curve.end(), side.nodes.begin(), side.nodes.end() - (side.closed ? 0 : 1));
  }
  return outline;
}

/** Whether \p holds is true for every point. */
template <typename Holds>
bool
allOf(const Polyline& points, Holds holds)
{
  bool all = true;
#pragma omp parallel for schedule(static) reduction(&& : all)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(points.size()); ++i)
    all = all && holds(points[i]);
  return all;
}

/** Whether there is no point of the cloud in the middle between two places. */
bool
isOpenBetween(const SurfaceGraph& graph, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  constexpr double open = 1.2; // spacings; among points the nearest one is rarely farther than one
  const Eigen::Vector3d middle = 0.5 * (a + b);
  return (graph.position(graph.blocks().nearest(middle)) - middle).norm() > open * graph.spacing();
}

/** Whether the outline follows the ring it was fitted to and stays near it, or, if the ring spans a notch, near the points
 *  in the notch: the longest edge of the ring is six spacings, and may span a notch of that depth. */
bool
staysByRing(const OutlineDraft& draft, const Outline& outline)
{
  constexpr double farthest = 3.5, farthest_within = 1.5, farthest_of_ring = 3.0; // spacings
  const Polyline& ring = draft.points();
  const std::size_t n = ring.size();
  const double spacing = draft.spacing();
  Polyline edge, middles;
  for (const EdgePoint& e : draft.edge())
    edge.push_back(e.position);
  double longest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    middles.push_back(0.5 * (ring[i] + ring[(i + 1) % n]));
    longest = std::max(longest, (ring[(i + 1) % n] - ring[i]).norm());
  }
  const NearPoints by_middle(middles), by_edge(edge), by_curve(outline.curve);
  const auto isNear = [](const NearPoints& points, const Eigen::Vector3d& p, double reach) {
    return points.any(p, reach, [&](const Eigen::Vector3d& q, std::size_t) { return (q - p).norm() < reach; });
  };
  const auto inNotch = [&](const Eigen::Vector3d& p) {
    if (!isNear(by_edge, p, farthest_within * spacing))
      return false;
    Eigen::Vector3d nearest = middles.front();
    for (const Eigen::Vector3d& middle : middles)
      if ((middle - p).squaredNorm() < (nearest - p).squaredNorm())
        nearest = middle;
    return isOpenBetween(draft.surface().graph(), p, nearest);
  };
  const auto byRing = [&](const Eigen::Vector3d& p) {
    return by_middle.any(p, farthest * spacing + 0.5 * longest, [&](const Eigen::Vector3d&, std::size_t i) {
      const Eigen::Vector3d& a = ring[i];
      const Eigen::Vector3d d = ring[(i + 1) % n] - a;
      const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      return (p - a - t * d).norm() < farthest * spacing;
    });
  };
  return allOf(ring, [&](const Eigen::Vector3d& p) { return isNear(by_curve, p, farthest_of_ring * spacing); }) &&
         allOf(outline.curve, [&](const Eigen::Vector3d& p) { return byRing(p) || inNotch(p); }) &&
         outline.curve.size() * node_step * spacing < 1.3 * length(ring, true);
}

/** Whether the outline does not cross itself. */
bool
isSimple(const SurfaceGraph& graph, const Outline& outline)
{
  Polyline closed = outline.curve;
  closed.push_back(closed.front());
  std::vector<Eigen::Vector3d> normals(closed.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(closed.size()); ++i)
    normals[i] = graph.normal(graph.blocks().nearest(closed[i]));
  return !firstSelfCrossing(closed, normals, 1e-3 * graph.spacing());
}

/** The outline as the corners of the draft suggest; empty if \p goOn returns false on the way. */
Outline
withCorners(OutlineDraft& draft, const std::function<bool()>& goOn)
{
  if (!draft.corners.empty()) {
    draft.fitSides();
    if (!goOn())
      return {};
    chooseCorners(draft);
    if (!goOn())
      return {};
  }
  if (draft.corners.empty())
    draft.fitClosed();
  else {
    draft.refine();
    if (!goOn())
      return {};
    draft.refine();
    drawInCorners(draft);
  }
  return goOn() ? assembled(draft) : Outline();
}

} // namespace

/** If a fit runs away from the ring (few points, or a very ragged rim) or crosses itself, a plainer one is used. */
Outline
fitOutline(const MlsSurface& surface, const Ring& ring, const std::function<bool()>& goOn)
{
  constexpr std::size_t fewest_points = 24; // with fewer, corners and chance look alike
  OutlineDraft draft(surface, ring);
  if (!goOn())
    return {};
  const auto isGood = [&](const Outline& outline) { return staysByRing(draft, outline) && isSimple(surface.graph(), outline); };
  if (ring.size() >= fewest_points) {
    const Outline outline = withCorners(draft, goOn);
    if (outline.curve.empty() || isGood(outline))
      return outline;
  }
  if (!goOn())
    return {};
  draft.fitClosed();
  if (const Outline outline = assembled(draft); isGood(outline))
    return outline;
  Outline plain;
  plain.curve = smoothSide(draft.points(), true, surface.graph().spacing()).nodes;
  return plain;
}

} // namespace pcl_spiral
