#include "outline.h"

#include "outline_corners.h"
#include "side_fit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr double least_corner = 20.0 * M_PI / 180.0; // turn
constexpr double sure_corner = 75.0 * M_PI / 180.0;
constexpr double corner_cost = 8.0;      // what a corner must save, in units of EdgeFit::cost
constexpr double freedom_cost = 6.0;     // of one wave more
constexpr double corner_clearance = 0.8; // spacings: nearer to a re-entrant corner a point's side is uncertain

using Points = std::vector<Eigen::Vector3d>;

struct Corner {
  std::size_t point; ///< of the ring, nearest
  double turn;       ///< radians, positive is convex
  Eigen::Vector3d position;
  std::size_t cut_before = 0, cut_after = 0; ///< nodes past the corner on the sides before and after it
  bool sure = false;
};

/** Where two lines in the plane, a + s u and b + t v, meet. */
bool
crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& u, const Eigen::Vector2d& b, const Eigen::Vector2d& v, double& s,
         double& t)
{
  const double det = u.x() * v.y() - u.y() * v.x();
  if (std::abs(det) < 1e-6 * u.norm() * v.norm())
    return false;
  const Eigen::Vector2d d = b - a;
  s = (d.x() * v.y() - d.y() * v.x()) / det;
  t = (d.x() * u.y() - d.y() * u.x()) / det;
  return true;
}

/** Cost that does not depend on where the fit started from. */
double
ownCost(const FittedSide& fitted, double spacing)
{
  return fitted.outside + fitted.roughness +
         freedom_cost * length(fitted.side.nodes, fitted.side.closed) / spacing / fitted.wavelength;
}

/** An outline in the making: a side from every corner to the next. */
class OutlineFitter {
public:
  OutlineFitter(const MlsSurface& surface, const Ring& ring);
  Outline fit();

private:
  std::size_t following(std::size_t c) const { return (c + 1) % corners_.size(); }
  std::size_t preceding(std::size_t c) const { return (c + corners_.size() - 1) % corners_.size(); }
  Points pointsBetween(std::size_t from, std::size_t to) const;
  void fitFrom(std::size_t c);
  void meetAt(std::size_t c);
  OutlineSide trimmed(std::size_t c) const;
  FittedSide merged(std::size_t c) const;
  bool isSmooth(std::size_t c, const FittedSide& through) const;
  void dropSmoothCorners();
  void refine();
  void drawInCorners();
  void fallBackInward(OutlineSide& side) const;
  Outline assembled() const;
  bool staysByRing(const Outline& outline) const;
  Outline withCorners();
  Outline withoutCorners();

  const MlsSurface& surface_;
  double spacing_;
  Points points_, normals_;
  std::vector<Corner> corners_;
  std::vector<FittedSide> sides_; ///< from the corner of the same number to the next; one, closed, without corners
};

OutlineFitter::OutlineFitter(const MlsSurface& surface, const Ring& ring)
: surface_(surface), spacing_(surface.graph().spacing())
{
  // Start at the point farthest from the ring's mean: the same one wherever the cloud lies.
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::uint32_t v : ring)
    mean += surface.graph().position(v) / static_cast<double>(ring.size());
  std::size_t first = 0;
  double farthest = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const double distance = (surface.graph().position(ring[i]) - mean).norm();
    if (distance > farthest) {
      farthest = distance;
      first = i;
    }
  }
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::uint32_t v = ring[(first + i) % ring.size()];
    points_.push_back(surface.graph().position(v));
    normals_.push_back(surface.graph().normal(v));
  }
}

/** Points of the ring from one to another, both ends among them; the whole ring and its first again if they are one. */
Points
OutlineFitter::pointsBetween(std::size_t from, std::size_t to) const
{
  Points result{points_[from]};
  do {
    from = (from + 1) % points_.size();
    result.push_back(points_[from]);
  } while (from != to);
  return result;
}

/** Fit the side that starts at corner \p c. */
void
OutlineFitter::fitFrom(std::size_t c)
{
  const Corner &a = corners_[c], &b = corners_[following(c)];
  Points line = pointsBetween(a.point, b.point);
  OutlineSide start;
  if (sides_[c].side.nodes.empty())
    start = smoothSide(line, false, spacing_);
  else
    start = trimmed(c);
  // Near a re-entrant corner points of the other side stick out; leave out that stretch.
  const double clearance = corner_clearance * spacing_;
  const auto unclear = [&](const Eigen::Vector3d& p) {
    return (a.turn < 0.0 && (p - a.position).norm() < clearance) || (b.turn < 0.0 && (p - b.position).norm() < clearance);
  };
  Points kept;
  for (const Eigen::Vector3d& p : line)
    if (!unclear(p))
      kept.push_back(p);
  Polyline nodes;
  for (const Eigen::Vector3d& p : start.nodes)
    if (!unclear(p))
      nodes.push_back(p);
  if (nodes.size() >= 5)
    start.nodes = nodes;
  sides_[c] = fitSide(surface_, spacing_, start, kept.size() >= 3 ? kept : line);
}

/** Find where the sides before and after corner \p c meet, prolonged straight if need be. */
void
OutlineFitter::meetAt(std::size_t c)
{
  constexpr double reach = 5.0; // spacings
  Corner& corner = corners_[c];
  const Polyline &before = sides_[preceding(c)].side.nodes, &after = sides_[c].side.nodes;
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

/** The side from corner \p c to the next, cut off or prolonged at both. */
OutlineSide
OutlineFitter::trimmed(std::size_t c) const
{
  const Corner &a = corners_[c], &b = corners_[following(c)];
  const OutlineSide& whole = sides_[c].side;
  OutlineSide side;
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

/** One smooth side through corner \p c in place of the two that meet there. */
FittedSide
OutlineFitter::merged(std::size_t c) const
{
  const std::size_t before = preceding(c);
  Polyline line = trimmed(before).nodes;
  if (corners_.size() == 1) {
    line.pop_back();
    return fitSide(surface_, spacing_, smoothSide(line, true, spacing_), points_);
  }
  const Polyline rest = trimmed(c).nodes;
  line.insert(line.end(), rest.begin() + 1, rest.end());
  return fitSide(surface_, spacing_, smoothSide(line, false, spacing_),
                 pointsBetween(corners_[before].point, corners_[following(c)].point));
}

/** Whether a smooth side \p through corner \p c explains the points as well as a corner does. */
bool
OutlineFitter::isSmooth(std::size_t c, const FittedSide& through) const
{
  const OutlineSide before = trimmed(preceding(c)), after = trimmed(c);
  const double step = length(through.side.nodes, through.side.closed) / static_cast<double>(through.side.segments());
  double area = 0.0; // by which the smooth side encloses more
  for (const Eigen::Vector3d& p : through.side.nodes) {
    const SideFoot a = footOn(before, p, 0, static_cast<std::ptrdiff_t>(before.nodes.size()));
    const SideFoot b = footOn(after, p, 0, static_cast<std::ptrdiff_t>(after.nodes.size()));
    area += step * ((p - a.position).squaredNorm() < (p - b.position).squaredNorm() ? a.offset : b.offset);
  }
  double apart = ownCost(sides_[c], spacing_);
  if (corners_.size() > 1)
    apart += ownCost(sides_[preceding(c)], spacing_);
  return ownCost(through, spacing_) + area / (spacing_ * spacing_) < apart + corner_cost;
}

/** Merge sides at corners that turn too little or that a smooth side explains as well, the flattest first. */
void
OutlineFitter::dropSmoothCorners()
{
  while (!corners_.empty()) {
    std::size_t c = corners_.size();
    for (std::size_t i = 0; i < corners_.size(); ++i)
      if (!corners_[i].sure && (c == corners_.size() || std::abs(corners_[i].turn) < std::abs(corners_[c].turn)))
        c = i;
    if (c == corners_.size() || std::abs(corners_[c].turn) > sure_corner)
      return;
    FittedSide through = merged(c);
    if (std::abs(corners_[c].turn) >= least_corner && !isSmooth(c, through)) {
      corners_[c].sure = true;
      continue;
    }
    if (corners_.size() == 1) {
      corners_.clear();
      sides_.assign(1, std::move(through));
      return;
    }
    sides_[preceding(c)] = std::move(through);
    sides_.erase(sides_.begin() + static_cast<std::ptrdiff_t>(c));
    corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(c));
    const std::size_t side = c == 0 ? corners_.size() - 1 : c - 1;
    meetAt(side);
    meetAt(following(side));
  }
}

/** With the corners known, share out the points anew and fit again from corner to corner. */
void
OutlineFitter::refine()
{
  constexpr std::ptrdiff_t reach = 6; // points
  const auto n = static_cast<std::ptrdiff_t>(points_.size());
  for (Corner& corner : corners_) {
    const auto old = static_cast<std::ptrdiff_t>(corner.point);
    for (std::ptrdiff_t k = old - reach; k <= old + reach; ++k) {
      const auto i = static_cast<std::size_t>((k % n + n) % n);
      if ((points_[i] - corner.position).squaredNorm() < (points_[corner.point] - corner.position).squaredNorm())
        corner.point = i;
    }
  }
  std::vector<FittedSide> fitted;
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const FittedSide old = sides_[c];
    fitFrom(c);
    fitted.push_back(sides_[c]);
    sides_[c] = old;
  }
  sides_ = std::move(fitted);
  for (std::size_t c = 0; c < corners_.size(); ++c)
    meetAt(c);
}

/** Draw corners beyond what is known of the surface back between their sides. */
void
OutlineFitter::drawInCorners()
{
  constexpr int most_steps = 12;
  for (std::size_t c = 0; c < corners_.size(); ++c) {
    const Polyline before = trimmed(preceding(c)).nodes, after = trimmed(c).nodes;
    const std::size_t k = std::min<std::size_t>(4, std::min(before.size(), after.size()) - 1);
    const Eigen::Vector3d inner = 0.5 * (before[before.size() - 1 - k] + after[k]), tip = corners_[c].position;
    const Eigen::Vector3d step = 0.25 * spacing_ * (inner - tip).normalized();
    for (int i = 0; i <= most_steps; ++i)
      if (const SurfaceFoot foot = surface_.project(tip + i * step); foot.valid) {
        corners_[c].position = foot.position;
        break;
      }
  }
}

/** Lay nodes on the surface; draw back those that lie beyond what is known of it. */
void
OutlineFitter::fallBackInward(OutlineSide& side) const
{
  constexpr int most_steps = 12;
  const double step = 0.25 * spacing_;
  std::vector<std::size_t> open(side.nodes.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  for (int k = 0; k <= most_steps && !open.empty(); ++k) {
    Points queries;
    for (const std::size_t i : open)
      queries.push_back(side.nodes[i] - k * step * side.outward[i]);
    std::vector<SurfaceFoot> feet;
    surface_.project(queries, feet);
    std::vector<std::size_t> still_open;
    for (std::size_t j = 0; j < open.size(); ++j)
      if (feet[j].valid)
        side.nodes[open[j]] = feet[j].position;
      else
        still_open.push_back(open[j]);
    open.swap(still_open);
  }
}

Outline
OutlineFitter::assembled() const
{
  Outline outline;
  for (std::size_t s = 0; s < sides_.size(); ++s) {
    OutlineSide side = corners_.empty() ? sides_[s].side : trimmed(s);
    fallBackInward(side);
    if (!side.closed)
      outline.corners.push_back(outline.curve.size());
    outline.curve.insert(outline.curve.end(), side.nodes.begin(), side.nodes.end() - (side.closed ? 0 : 1));
  }
  return outline;
}

/** Whether the outline stays by the ring it was fitted to. */
bool
OutlineFitter::staysByRing(const Outline& outline) const
{
  constexpr double farthest = 3.5; // spacings: the longest edge of the ring is six
  for (const Eigen::Vector3d& p : outline.curve) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Eigen::Vector3d a = points_[i], d = points_[(i + 1) % points_.size()] - a;
      const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (p - a - t * d).squaredNorm());
    }
    if (!(nearest < farthest * farthest * spacing_ * spacing_))
      return false;
  }
  return outline.curve.size() * node_step * spacing_ < 1.3 * length(points_, true);
}

Outline
OutlineFitter::withCorners()
{
  for (const CornerCandidate& c : cornerCandidates(points_, normals_, spacing_))
    corners_.push_back({c.point, c.turn, points_[c.point]});
  if (corners_.empty())
    return withoutCorners();
  sides_.resize(corners_.size());
  for (std::size_t c = 0; c < corners_.size(); ++c)
    fitFrom(c);
  for (std::size_t c = 0; c < corners_.size(); ++c)
    meetAt(c);
  dropSmoothCorners();
  if (corners_.empty())
    return withoutCorners();
  refine();
  drawInCorners();
  return assembled();
}

Outline
OutlineFitter::withoutCorners()
{
  corners_.clear();
  sides_.assign(1, fitSide(surface_, spacing_, smoothSide(points_, true, spacing_), points_));
  return assembled();
}

/** A fit that runs away from the ring (few points, or a very ragged rim) gives way to a plainer one. */
Outline
OutlineFitter::fit()
{
  constexpr std::size_t fewest_points = 24; // in which corners can be told from chance
  if (points_.size() >= fewest_points)
    if (const Outline outline = withCorners(); staysByRing(outline))
      return outline;
  if (const Outline outline = withoutCorners(); staysByRing(outline))
    return outline;
  Outline plain;
  plain.curve = smoothSide(points_, true, spacing_).nodes;
  return plain;
}

} // namespace

Outline
fitOutline(const MlsSurface& surface, const Ring& ring)
{
  return OutlineFitter(surface, ring).fit();
}

} // namespace pcl_spiral
