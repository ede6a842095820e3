// SPDX-License-Identifier: BSD-3-Clause
#include "outline_draft.h"

#include "outline_corners.h"

#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

namespace pcl_spiral {
namespace {

/** Where two lines in the plane, a + s u and b + t v, meet. */
bool
crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& u, const Eigen::Vector2d& b, const Eigen::Vector2d& v, double& s, double& t)
{
  const double det = u.x() * v.y() - u.y() * v.x();
  if (std::abs(det) < 1e-6 * u.norm() * v.norm())
    return false;
  const Eigen::Vector2d d = b - a;
  s = (d.x() * v.y() - d.y() * v.x()) / det;
  t = (d.x() * u.y() - d.y() * u.x()) / det;
  return true;
}

} // namespace

OutlineDraft::OutlineDraft(const MlsSurface& surface, const Ring& given) : surface_(surface), spacing_(surface.graph().spacing())
{
  const SurfaceGraph& graph = surface.graph();
  const Ring ring = begunFarOut(graph, given);
  for (const std::uint32_t v : ring) {
    points_.push_back(graph.position(v));
    normals_.push_back(graph.normal(v));
  }
  at_ = arcLengths(points_, true);
  edge_ = edgePoints(graph, ring);
  for (const CornerCandidate& c : cornerCandidates(points_, normals_, spacing_))
    corners.push_back({c.point, c.turn, points_[c.point]});
}

/** Points of the ring from one to another, including both ends; if they are the same, the whole ring and its first again. */
Polyline
OutlineDraft::pointsBetween(std::size_t from, std::size_t to) const
{
  Polyline result{points_[from]};
  do {
    from = (from + 1) % points_.size();
    result.push_back(points_[from]);
  } while (from != to);
  return result;
}

/** Length of the ring from one of its points to another, mm. */
double
OutlineDraft::ringBetween(std::size_t from, std::size_t to) const
{
  return to > from ? at_[to] - at_[from] : at_[to] + at_.back() - at_[from];
}

/** Points of the edge once round, starting at a point of the ring. */
std::vector<ExpectedPoint>
OutlineDraft::edgeFrom(std::size_t from) const
{
  std::vector<ExpectedPoint> result;
  for (const EdgePoint& p : edge_) {
    const double share = (p.place - at_[from]) / at_.back();
    result.push_back({p.position, share - std::floor(share)});
  }
  return result;
}

/** Points of the edge from one point of the ring to another, and \p beyond (mm) past both. If the ends are so close that the
 *  stretches past them overlap, a point is expected at both. */
std::vector<ExpectedPoint>
OutlineDraft::edgeBetween(std::size_t from, std::size_t to, double beyond) const
{
  const double whole = at_.back(), span = ringBetween(from, to);
  beyond = std::min(beyond, 0.5 * whole);
  std::vector<ExpectedPoint> result;
  for (const EdgePoint& p : edge_) {
    const double first = p.place - at_[from] + beyond;
    for (double past = first - whole * std::floor(first / whole); past <= span + 2.0 * beyond; past += whole)
      result.push_back({p.position, std::clamp((past - beyond) / span, 0.0, 1.0)});
  }
  return result;
}

/** Side from corner \p c to the next, from the ring alone. Near a re-entrant corner the ring may cut across the notch:
 *  that stretch is left out, and the side is extended. */
FittedSide
OutlineDraft::firstFit(std::size_t c) const
{
  constexpr double widest_clearance = 4.0, share = 0.2; // spacings; of the side's length
  const Corner &a = corners[c], &b = corners[following(c)];
  EdgeSide start = smoothSide(pointsBetween(a.point, b.point), false, spacing_);
  const double most = share * length(start.nodes);
  const auto clearance = [&](const Corner& c) {
    return std::min(most, widest_clearance * spacing_ * std::clamp(-c.turn / (0.5 * pi), 0.0, 1.0));
  };
  const auto clear = [&](const Eigen::Vector3d& p) {
    return (p - a.position).norm() >= clearance(a) && (p - b.position).norm() >= clearance(b);
  };
  Polyline nodes;
  std::copy_if(start.nodes.begin(), start.nodes.end(), std::back_inserter(nodes), clear);
  std::vector<ExpectedPoint> points;
  for (const ExpectedPoint& p : edgeBetween(a.point, b.point, 0.0))
    if (clear(p.position))
      points.push_back(p);
  if (nodes.size() >= 5)
    start.nodes = std::move(nodes);
  return fitSide(surface_, spacing_, std::move(start), std::move(points), ringBetween(a.point, b.point));
}

/** Fit a side from one corner to another, \p start, with points beyond a re-entrant corner if they belong to it. */
FittedSide
OutlineDraft::fitBetween(std::size_t from, std::size_t to, EdgeSide start) const
{
  constexpr double beyond = 6.0, contested = 14.0; // spacings, from a re-entrant corner
  constexpr std::ptrdiff_t reach = 40;             // nodes
  const Corner &a = corners[from], &b = corners[to];
  makeEven(start, spacing_);
  const auto last = static_cast<std::ptrdiff_t>(start.nodes.size()) - 1;
  const EdgeSide before = trimmed(preceding(from)), after = trimmed(to);
  const auto last_before = static_cast<std::ptrdiff_t>(before.nodes.size()) - 1;
  // The surface at a re-entrant corner is what lies inside either side: a point belongs to the side it is deeper in.
  const auto own = [&](const Eigen::Vector3d& p) {
    if (a.turn < 0.0 && (p - a.position).norm() < contested * spacing_ &&
        footOn(before, p, last_before, reach).offset < footOn(start, p, 0, reach).offset)
      return false;
    return b.turn > 0.0 || (p - b.position).norm() > contested * spacing_ ||
           footOn(after, p, 0, reach).offset >= footOn(start, p, last, reach).offset;
  };
  std::vector<ExpectedPoint> points;
  for (const ExpectedPoint& p : edgeBetween(a.point, b.point, beyond * spacing_))
    if (own(p.position))
      points.push_back(p);
  return fitSide(surface_, spacing_, std::move(start), std::move(points), ringBetween(a.point, b.point));
}

void
OutlineDraft::fitSides()
{
  sides.assign(corners.size(), FittedSide());
  const auto count = static_cast<std::int64_t>(corners.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t c = 0; c < count; ++c)
    sides[c] = firstFit(c);
  for (std::size_t c = 0; c < corners.size(); ++c)
    meetAt(c);
}

/** The point of the ring nearest to \p p among those up to \p window points from entry \p about. */
std::size_t
OutlineDraft::nearestPoint(const Eigen::Vector3d& p, std::size_t about, std::size_t window) const
{
  const std::size_t n = points_.size();
  std::size_t best = about;
  for (std::size_t k = 0; k <= 2 * std::min(window, n / 2); ++k) {
    const std::size_t i = (about + n - std::min(window, n / 2) + k) % n;
    if ((points_[i] - p).squaredNorm() < (points_[best] - p).squaredNorm())
      best = i;
  }
  return best;
}

void
OutlineDraft::refine()
{
  constexpr std::size_t window = 6; // points
  for (Corner& corner : corners)
    corner.point = nearestPoint(corner.position, corner.point, window);
  std::vector<FittedSide> fitted(corners.size());
  const auto count = static_cast<std::int64_t>(corners.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t c = 0; c < count; ++c)
    fitted[c] = fitBetween(c, following(c), trimmed(c));
  sides = std::move(fitted);
  for (std::size_t c = 0; c < corners.size(); ++c)
    meetAt(c);
}

void
OutlineDraft::fitClosed()
{
  corners.clear();
  sides.assign(1, fitSide(surface_, spacing_, smoothSide(points_, true, spacing_), edgeFrom(0), at_.back()));
}

FittedSide
OutlineDraft::merged(std::size_t c) const
{
  Polyline line = trimmed(preceding(c)).nodes;
  if (corners.size() == 1) {
    line.pop_back();
    return fitSide(surface_, spacing_, smoothSide(line, true, spacing_), edgeFrom(corners[c].point), at_.back());
  }
  const Polyline rest = trimmed(c).nodes;
  line.insert(line.end(), rest.begin() + 1, rest.end());
  EdgeSide start = smoothSide(line, false, spacing_);
  layOnSurface(surface_, start);
  return fitBetween(preceding(c), following(c), std::move(start));
}

void
OutlineDraft::merge(std::size_t c, FittedSide through)
{
  if (corners.size() == 1) {
    corners.clear();
    sides.assign(1, through);
    return;
  }
  sides[preceding(c)] = std::move(through);
  sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(c));
  corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(c));
  const std::size_t side = c == 0 ? corners.size() - 1 : c - 1;
  meetAt(side);
  meetAt(following(side));
}

void
OutlineDraft::split(std::size_t s, std::size_t node, double turn)
{
  const std::size_t next = following(s), c = s + 1;
  std::size_t between = points_.size(); // point of the ring between the side's ends nearest to the node
  const Eigen::Vector3d at = sides[s].side.nodes[node];
  for (std::size_t i = (corners[s].point + 1) % points_.size(); i != corners[next].point; i = (i + 1) % points_.size())
    if (between == points_.size() || (points_[i] - at).squaredNorm() < (points_[between] - at).squaredNorm())
      between = i;
  if (between == points_.size())
    return;
  corners.insert(corners.begin() + static_cast<std::ptrdiff_t>(c), Corner{between, turn, points_[between]});
  sides.insert(sides.begin() + static_cast<std::ptrdiff_t>(c), FittedSide());
  const auto meet = [&] {
    meetAt(s);
    meetAt(c);
    meetAt(following(c));
  };
  sides[s] = firstFit(s);
  sides[c] = firstFit(c);
  meet();
  FittedSide before = fitBetween(s, c, trimmed(s));
  sides[c] = fitBetween(c, following(c), trimmed(c));
  sides[s] = std::move(before);
  meet();
}

/** Find where the sides before and after corner \p c meet, extended straight if necessary. */
void
OutlineDraft::meetAt(std::size_t c)
{
  constexpr double reach = 6.0; // spacings
  Corner& corner = corners[c];
  const Polyline &before = sides[preceding(c)].side.nodes, &after = sides[c].side.nodes;
  const Eigen::Vector3d origin = points_[corner.point], up = normals_[corner.point];
  const Eigen::Vector3d e = up.unitOrthogonal(), f = up.cross(e);
  const auto flat = [&](const Eigen::Vector3d& p) { return Eigen::Vector2d((p - origin).dot(e), (p - origin).dot(f)); };
  const auto most = static_cast<std::size_t>(reach / node_step);
  const std::size_t nb = before.size(), na = after.size();
  double nearest = reach * spacing_;
  Eigen::Vector2d u = flat(before[nb - 1]) - flat(before[nb - 2]), v = flat(after[1]) - flat(after[0]);
  corner.position = 0.5 * (before.back() + after.front());
  corner.cut_before = corner.cut_after = 0;
  for (std::size_t i = 0; i < std::min(most, nb / 2); ++i)
    for (std::size_t j = 0; j < std::min(most, na / 2); ++j) {
      const Eigen::Vector3d &p = before[nb - 2 - i], &q = before[nb - 1 - i], &r = after[j], &w = after[j + 1];
      const Eigen::Vector2d pq = flat(q) - flat(p), rw = flat(w) - flat(r);
      double s = 0.0, t = 0.0;
      if (!crossing(flat(p), pq, flat(r), rw, s, t) || s < 0.0 || (i > 0 && s > 1.0) || t > 1.0 || (j > 0 && t < 0.0))
        continue;
      const Eigen::Vector3d at = 0.5 * (p + s * (q - p) + r + t * (w - r));
      if ((at - origin).norm() >= nearest)
        continue;
      nearest = (at - origin).norm();
      corner.position = at;
      corner.cut_before = s > 1.0 ? 0 : i + 1;
      corner.cut_after = t < 0.0 ? 0 : j + 1;
      u = pq;
      v = rw;
    }
  corner.turn = std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
}

EdgeSide
OutlineDraft::trimmed(std::size_t c) const
{
  const Corner &a = corners[c], &b = corners[following(c)];
  const EdgeSide& whole = sides[c].side;
  EdgeSide side;
  const std::size_t begin = std::min(a.cut_after, whole.nodes.size() / 2);
  const std::size_t end = whole.nodes.size() - std::min(b.cut_before, whole.nodes.size() / 2);
  side.nodes.push_back(a.position);
  side.normals.push_back(whole.normals.front());
  for (std::size_t i = begin; i < end; ++i) {
    side.nodes.push_back(whole.nodes[i]);
    side.normals.push_back(whole.normals[i]);
  }
  side.nodes.push_back(b.position);
  side.normals.push_back(whole.normals.back());
  makeEven(side, spacing_);
  return side;
}

} // namespace pcl_spiral
