// SPDX-License-Identifier: BSD-3-Clause
#include "corner_choice.h"
#include "side_fit.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr double least_corner = 20.0 * pi / 180.0; // turn
constexpr double sure_corner = 75.0 * pi / 180.0;
constexpr double corner_cost = 8.0; // what a corner must save, in units of EdgeFit::cost

/** Cost that does not depend on where the fit started from. */
double
ownCost(const FittedSide& fitted, double spacing)
{
  return fitted.outside + fitted.roughness + freedom_cost * length(fitted.side.nodes, fitted.side.closed) / spacing / fitted.wavelength;
}

/** Squared spacings by which the run of sides \p now encloses more than the run \p was, between the same ends. */
double
extraArea(const std::vector<EdgeSide>& was, const std::vector<EdgeSide>& now, double spacing)
{
  double area = 0.0;
  for (const EdgeSide& side : now) {
    const double step = length(side.nodes, side.closed) / static_cast<double>(side.segments());
    for (const Eigen::Vector3d& p : side.nodes) {
      double nearest = std::numeric_limits<double>::infinity(), offset = 0.0;
      for (const EdgeSide& other : was) {
        const SideFoot foot = footOn(other, p, 0, static_cast<std::ptrdiff_t>(other.nodes.size()));
        if (const double squared = (p - foot.position).squaredNorm(); squared < nearest) {
          nearest = squared;
          offset = foot.offset;
        }
      }
      area += step * offset;
    }
  }
  return area / (spacing * spacing);
}

/** Whether a smooth side \p through corner \p c explains the points as well as a corner does. */
bool
isSmooth(const OutlineDraft& draft, std::size_t c, const FittedSide& through)
{
  double apart = ownCost(draft.sides[c], draft.spacing());
  if (draft.corners.size() > 1)
    apart += ownCost(draft.sides[draft.preceding(c)], draft.spacing());
  const double more = extraArea({draft.trimmed(draft.preceding(c)), draft.trimmed(c)}, {through.side}, draft.spacing());
  return ownCost(through, draft.spacing()) + more < apart + corner_cost;
}

/** Merge sides at corners that turn too little, or that a smooth side explains as well; the flattest first. */
void
dropSmoothCorners(OutlineDraft& draft)
{
  std::vector<Corner>& corners = draft.corners;
  while (!corners.empty()) {
    std::size_t c = corners.size();
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (!corners[i].sure && (c == corners.size() || std::abs(corners[i].turn) < std::abs(corners[c].turn)))
        c = i;
    if (c == corners.size() || std::abs(corners[c].turn) > sure_corner)
      return;
    FittedSide through = draft.merged(c);
    if (std::abs(corners[c].turn) >= least_corner && !isSmooth(draft, c, through))
      corners[c].sure = true;
    else
      draft.merge(c, std::move(through));
  }
}

/** The node where a side turns most, and by how much. */
std::pair<std::size_t, double>
sharpestBend(const EdgeSide& side)
{
  constexpr std::size_t arm = 10; // nodes
  std::pair<std::size_t, double> sharpest{0, 0.0};
  for (std::size_t i = arm; i + arm < side.nodes.size(); ++i) {
    const Eigen::Vector3d in = side.nodes[i] - side.nodes[i - arm], out = side.nodes[i + arm] - side.nodes[i];
    // Chords over a round bend turn by half as much as its ends.
    const double turn = std::atan2(in.cross(out).dot(side.normals[i]), in.dot(out));
    if (std::abs(turn) > std::abs(sharpest.second))
      sharpest = {i, turn};
  }
  return sharpest;
}

/** Whether the new corner \p c turns as the side did there by \p turn, and its neighbours are as clear as before. */
bool
isSound(const OutlineDraft& draft, std::size_t c, double turn, const Corner& was_before, const Corner& was_after)
{
  const auto kept = [](const Corner& was, const Corner& now) { return std::abs(was.turn) < sure_corner || now.turn / was.turn > 0.5; };
  return draft.corners[c].turn * (turn > 0.0 ? 1.0 : -1.0) >= least_corner && kept(was_before, draft.corners[draft.preceding(c)]) &&
         kept(was_after, draft.corners[draft.following(c)]);
}

/** Whether the corner between the new sides \p s and the next is better placed than the one between the two in \p was. */
bool
isBetterPlace(const OutlineDraft& was, std::size_t was_first, const OutlineDraft& now, std::size_t first)
{
  const auto cost = [](const OutlineDraft& draft, std::size_t s) {
    return ownCost(draft.sides[s], draft.spacing()) + ownCost(draft.sides[draft.following(s)], draft.spacing());
  };
  const auto run = [](const OutlineDraft& draft, std::size_t s) {
    return std::vector<EdgeSide>{draft.trimmed(s), draft.trimmed(draft.following(s))};
  };
  return cost(now, first) + extraArea(run(was, was_first), run(now, first), was.spacing()) < cost(was, was_first);
}

/** Move a corner that ends side \p s to the new one, c = s + 1, in \p split, if it belongs there. */
bool
moveCorner(const OutlineDraft& was, OutlineDraft& split, std::size_t s)
{
  const std::size_t c = s + 1;
  for (const std::size_t old : {s, split.following(c)}) {
    if (split.corners.size() < 4 || std::abs(split.corners[old].turn) > sure_corner)
      continue;
    OutlineDraft moved = split;
    moved.merge(old, moved.merged(old));
    // In both runs the corner in question is the one between the two sides.
    const bool earlier = old == s;
    const std::size_t was_first = earlier ? was.preceding(s) : s;
    const std::size_t now_corner = old < c ? c - 1 : c;
    if (!isBetterPlace(was, was_first, moved, moved.preceding(now_corner)))
      continue;
    split.corners = moved.corners;
    split.sides = moved.sides;
    return true;
  }
  return false;
}

/** Put a corner at a bend of side \p s if it explains the points better, or move one there. Returns whether it did. */
bool
addMissedCorner(OutlineDraft& draft, std::size_t s, std::size_t node, double turn)
{
  OutlineDraft split = draft;
  split.split(s, node, turn);
  if (split.corners.size() == draft.corners.size() || !isSound(split, s + 1, turn, draft.corners[s], draft.corners[draft.following(s)]))
    return false;
  if (isSmooth(split, s + 1, draft.sides[s]) && !moveCorner(draft, split, s))
    return false;
  draft.corners = std::move(split.corners);
  draft.sides = std::move(split.sides);
  return true;
}

/** Add corners where sides bend, the sharpest bend first. In the order of the sides, a mirrored part would get other corners. */
bool
addMissedCorners(OutlineDraft& draft)
{
  constexpr int most = 20;
  int added = 0;
  std::vector<Polyline> tried; // sides
  while (added < most) {
    std::size_t side = 0;
    std::pair<std::size_t, double> sharpest{0, 0.0};
    for (std::size_t s = 0; s < draft.corners.size(); ++s) {
      const EdgeSide& own = draft.sides[s].side;
      if (std::find(tried.begin(), tried.end(), own.nodes) != tried.end())
        continue;
      if (const auto bend = sharpestBend(own); std::abs(bend.second) > std::abs(sharpest.second)) {
        sharpest = bend;
        side = s;
      }
    }
    if (std::abs(sharpest.second) < least_corner)
      break;
    tried.push_back(draft.sides[side].side.nodes);
    added += addMissedCorner(draft, side, sharpest.first, sharpest.second);
  }
  return added > 0;
}

} // namespace

void
chooseCorners(OutlineDraft& draft)
{
  dropSmoothCorners(draft);
  if (!addMissedCorners(draft))
    return;
  for (Corner& corner : draft.corners)
    corner.sure = false;
  dropSmoothCorners(draft);
}

} // namespace pcl_spiral
