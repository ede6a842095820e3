#include "outline.h"

#include "outline_corners.h"
#include "outline_side.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double node_step = 0.5; // spacings
constexpr double corner_turn = 20.0 * M_PI / 180.0;

using Points = std::vector<Eigen::Vector3d>;

/** Start the ring at its point farthest from the ring's mean: the same point wherever the cloud lies. */
void
rotateToFarthest(const SurfaceGraph& graph, Ring& ring)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::uint32_t v : ring)
    mean += graph.position(v) / static_cast<double>(ring.size());
  const auto farther = [&](std::uint32_t a, std::uint32_t b) {
    return (graph.position(a) - mean).squaredNorm() < (graph.position(b) - mean).squaredNorm();
  };
  std::rotate(ring.begin(), std::max_element(ring.begin(), ring.end(), farther), ring.end());
}

/** Even nodes along a line, without waves shorter than \p wavelength (in spacings). */
Polyline
smoothed(const Polyline& line, bool closed, double spacing, double wavelength)
{
  const double whole = length(line, closed);
  const auto count = static_cast<std::size_t>(std::max(closed ? 8.0 : 5.0, std::round(whole / (node_step * spacing)) + !closed));
  const Polyline even = resampled(line, count, closed);
  const auto m = static_cast<std::ptrdiff_t>(even.size());
  const double step = whole / static_cast<double>(closed ? m : m - 1) / spacing;
  const double weight = std::pow(wavelength / (2.0 * M_PI * step), 3);
  std::vector<Eigen::Triplet<double>> entries;
  const std::ptrdiff_t rows = closed ? m : m - 3;
  for (std::ptrdiff_t r = 0; r < rows; ++r) {
    const double binomial[4] = {-1.0, 3.0, -3.0, 1.0};
    for (int k = 0; k < 4; ++k)
      entries.emplace_back(r, (r + k) % m, weight * binomial[k]);
  }
  Eigen::SparseMatrix<double> d(rows, m), a(m, m);
  d.setFromTriplets(entries.begin(), entries.end());
  a.setIdentity();
  a += Eigen::SparseMatrix<double>(d.transpose() * d);
  Eigen::MatrixXd right(m, 3);
  for (std::ptrdiff_t i = 0; i < m; ++i)
    right.row(i) = even[i];
  const Eigen::MatrixXd solution = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(a).solve(right);
  Polyline result(even.size());
  for (std::ptrdiff_t i = 0; i < m; ++i)
    result[i] = solution.row(i);
  return result;
}

/** An outline in the making: sides in order, each ending where the next one starts. */
class OutlineFitter {
public:
  OutlineFitter(const MlsSurface& surface, const Ring& ring);
  Outline fit();

private:
  void makeSides(const std::vector<std::size_t>& corners);
  void layOnSurface();
  void placePoints();
  double moveSides(double blur, double wavelength);
  void meetAtCorners();
  void meet(OutlineSide& before, OutlineSide& after);
  void evenNodes();
  bool dropFlatCorners();
  double cornerTurn(std::size_t side) const;

  const MlsSurface& surface_;
  const SurfaceGraph& graph_;
  Points points_, point_normals_;
  double spacing_;
  std::vector<OutlineSide> sides_;
  std::vector<std::vector<Eigen::Vector3d>> normals_; ///< of the surface at the nodes
  struct Home {
    std::size_t side;
    double share; ///< of the side's length
  };
  std::vector<Home> homes_; ///< of the points
  std::vector<std::vector<SidePoint>> placed_;
};

OutlineFitter::OutlineFitter(const MlsSurface& surface, const Ring& given)
: surface_(surface), graph_(surface.graph()), spacing_(graph_.spacing())
{
  Ring ring = given;
  rotateToFarthest(graph_, ring);
  for (const std::uint32_t v : ring) {
    points_.push_back(graph_.position(v));
    point_normals_.push_back(graph_.normal(v));
  }
}

void
OutlineFitter::makeSides(const std::vector<std::size_t>& corners)
{
  constexpr double first_wavelength = 8.0;
  const std::size_t n = points_.size();
  homes_.assign(n, {0, 0.0});
  sides_.clear();
  const std::size_t count = std::max<std::size_t>(1, corners.size());
  for (std::size_t c = 0; c < count; ++c) {
    const bool closed = corners.empty();
    const std::size_t from = closed ? 0 : corners[c];
    const std::size_t to = closed ? n - 1 : corners[(c + 1) % count] + (c + 1 == count ? n : 0);
    Polyline line;
    for (std::size_t i = from; i <= to; ++i)
      line.push_back(points_[i % n]);
    const std::vector<double> at = arcLengths(line, closed);
    for (std::size_t i = from; i < to + closed; ++i)
      homes_[i % n] = {c, at[i - from] / at.back()};
    OutlineSide side;
    side.closed = closed;
    side.nodes = smoothed(line, closed, spacing_, first_wavelength);
    sides_.push_back(std::move(side));
  }
}

void
OutlineFitter::layOnSurface()
{
  Points all;
  for (const OutlineSide& side : sides_)
    all.insert(all.end(), side.nodes.begin(), side.nodes.end());
  std::vector<SurfaceFoot> feet;
  surface_.project(all, feet);
  normals_.assign(sides_.size(), {});
  std::size_t at = 0;
  for (std::size_t s = 0; s < sides_.size(); ++s) {
    OutlineSide& side = sides_[s];
    const std::size_t m = side.nodes.size();
    for (std::size_t i = 0; i < m; ++i, ++at) {
      if (feet[at].valid)
        side.nodes[i] = feet[at].position;
      normals_[s].push_back(feet[at].valid ? feet[at].normal
                                           : graph_.normal(graph_.blocks().nearest(side.nodes[i])));
    }
    side.outward.resize(m);
    for (std::size_t i = 0; i < m; ++i) {
      const std::size_t a = i > 0 ? i - 1 : side.closed ? m - 1 : 0;
      const std::size_t b = i + 1 < m ? i + 1 : side.closed ? 0 : m - 1;
      side.outward[i] = (side.nodes[b] - side.nodes[a]).cross(normals_[s][i]).normalized();
    }
  }
}

/** Foot of \p p on the segment from node a to b as a share, unclamped. */
double
share(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d d = b - a;
  const double squared = d.squaredNorm();
  return squared > 0.0 ? (p - a).dot(d) / squared : 0.0;
}

void
OutlineFitter::placePoints()
{
  constexpr double search = 20.0; // spacings to either side
  constexpr double beyond = 3.0;  // nodes past a convex corner that points still count
  std::vector<std::size_t> begin{0};
  for (const OutlineSide& side : sides_)
    begin.push_back(begin.back() + side.nodes.size());
  const auto total = static_cast<std::ptrdiff_t>(begin.back());
  const auto reach = static_cast<std::ptrdiff_t>(search / node_step);
  placed_.assign(sides_.size(), {});
  for (std::size_t i = 0; i < points_.size(); ++i) {
    Home& home = homes_[i];
    const auto expected = static_cast<std::ptrdiff_t>(
        static_cast<double>(begin[home.side]) + home.share * static_cast<double>(sides_[home.side].nodes.size() - 1));
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t best_side = home.side, best_node = 0;
    const std::ptrdiff_t from = 2 * reach + 1 < total ? expected - reach : 0;
    const std::ptrdiff_t to = 2 * reach + 1 < total ? expected + reach : total - 1;
    for (std::ptrdiff_t k = from; k <= to; ++k) {
      const auto global = static_cast<std::size_t>((k % total + total) % total);
      const std::size_t s = std::upper_bound(begin.begin(), begin.end(), global) - begin.begin() - 1;
      const double squared = (sides_[s].nodes[global - begin[s]] - points_[i]).squaredNorm();
      if (squared < nearest) {
        nearest = squared;
        best_side = s;
        best_node = global - begin[s];
      }
    }
    const OutlineSide& side = sides_[best_side];
    const std::size_t m = side.nodes.size();
    const std::size_t next = best_node + 1 < m ? best_node + 1 : side.closed ? 0 : best_node;
    const std::size_t last = best_node > 0 ? best_node - 1 : side.closed ? m - 1 : 0;
    double place = static_cast<double>(best_node);
    std::size_t a = best_node, b = next;
    double f = a == b ? -1.0 : share(points_[i], side.nodes[a], side.nodes[b]);
    if (f < 0.0 && last != best_node) {
      a = last;
      b = best_node;
      f = share(points_[i], side.nodes[a], side.nodes[b]);
      if (next != best_node)
        f = std::min(f, 1.0);
      place -= 1.0;
    }
    place += f;
    home = {best_side, std::clamp(place / static_cast<double>(m - 1), 0.0, 1.0)};
    const double past = side.closed ? 0.0 : std::max(-place, place - static_cast<double>(m - 1));
    if (past > 0.0) {
      const std::size_t corner = place < 0.0 ? best_side : (best_side + 1) % sides_.size();
      if (cornerTurn(corner) < 0.0 || past > beyond)
        continue;
    }
    const Eigen::Vector3d foot = side.nodes[a] + f * (side.nodes[b] - side.nodes[a]);
    const Eigen::Vector3d out = side.outward[a] + std::clamp(f, 0.0, 1.0) * (side.outward[b] - side.outward[a]);
    placed_[best_side].push_back({place, (points_[i] - foot).dot(out.normalized()) / spacing_});
  }
}

/** Turn of the outline where \p side begins, radians; positive is convex. */
double
OutlineFitter::cornerTurn(std::size_t s) const
{
  const OutlineSide& after = sides_[s];
  const OutlineSide& before = sides_[(s + sides_.size() - 1) % sides_.size()];
  const std::size_t m = before.nodes.size();
  const Eigen::Vector3d from = before.nodes[m - 1] - before.nodes[m - 2], to = after.nodes[1] - after.nodes[0];
  const Eigen::Vector3d& up = normals_[s].front();
  return std::atan2(from.cross(to).dot(up), from.dot(to) - from.dot(up) * to.dot(up));
}

double
OutlineFitter::moveSides(double blur, double wavelength)
{
  double largest = 0.0;
  for (std::size_t s = 0; s < sides_.size(); ++s) {
    OutlineSide& side = sides_[s];
    SideFit fit;
    fit.blur = blur;
    fit.wavelength = wavelength;
    fit.step = length(side.nodes, side.closed) / spacing_ /
               static_cast<double>(side.closed ? side.nodes.size() : side.nodes.size() - 1);
    const std::vector<double> d = fitOffsets(side, spacing_, placed_[s], fit);
    for (std::size_t i = 0; i < d.size(); ++i) {
      const double moved = std::clamp(d[i], -4.0, 4.0);
      side.nodes[i] += moved * spacing_ * side.outward[i];
      largest = std::max(largest, std::abs(moved));
    }
  }
  return largest;
}

/** Where two lines in the plane, a + s u and b + t v, meet. */
bool
crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& u, const Eigen::Vector2d& b, const Eigen::Vector2d& v, double& s,
         double& t)
{
  const double det = u.x() * v.y() - u.y() * v.x();
  if (std::abs(det) < 1e-9 * u.norm() * v.norm())
    return false;
  const Eigen::Vector2d d = b - a;
  s = (d.x() * v.y() - d.y() * v.x()) / det;
  t = (d.x() * u.y() - d.y() * u.x()) / det;
  return true;
}

/** End \p before and start \p after at the place where they meet, prolonged straight if need be. */
void
OutlineFitter::meet(OutlineSide& before, OutlineSide& after)
{
  const double reach = 6.0; // spacings
  const Eigen::Vector3d origin = 0.5 * (before.nodes.back() + after.nodes.front());
  const Eigen::Vector3d up = graph_.normal(graph_.blocks().nearest(origin));
  const Eigen::Vector3d e = up.unitOrthogonal(), f = up.cross(e);
  const auto flat = [&](const Eigen::Vector3d& p) { return Eigen::Vector2d((p - origin).dot(e), (p - origin).dot(f)); };
  const auto most = static_cast<std::size_t>(reach / node_step);
  const std::size_t nb = before.nodes.size(), na = after.nodes.size();
  const std::size_t kb = std::min(most, nb / 2), ka = std::min(most, na / 2);
  double nearest = reach * spacing_;
  std::size_t cut_before = 0, cut_after = 0;
  Eigen::Vector3d corner = origin;
  bool found = false;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, kb); ++i)
    for (std::size_t j = 0; j < std::max<std::size_t>(1, ka); ++j) {
      const Eigen::Vector3d &p = before.nodes[nb - 2 - i], &q = before.nodes[nb - 1 - i];
      const Eigen::Vector3d &r = after.nodes[j], &w = after.nodes[j + 1];
      double s = 0.0, t = 0.0;
      if (!crossing(flat(p), flat(q) - flat(p), flat(r), flat(w) - flat(r), s, t))
        continue;
      if (s < 0.0 || (i > 0 && s > 1.0) || t > 1.0 || (j > 0 && t < 0.0))
        continue;
      const Eigen::Vector3d at = 0.5 * (p + s * (q - p) + r + t * (w - r));
      const double away = (at - origin).norm();
      if (away < nearest) {
        nearest = away;
        corner = at;
        cut_before = i;
        cut_after = j;
        found = true;
      }
    }
  if (found) {
    before.nodes.resize(nb - 1 - cut_before);
    after.nodes.erase(after.nodes.begin(), after.nodes.begin() + static_cast<std::ptrdiff_t>(cut_after) + 1);
  }
  else {
    before.nodes.pop_back();
    after.nodes.erase(after.nodes.begin());
  }
  before.nodes.push_back(corner);
  after.nodes.insert(after.nodes.begin(), corner);
}

void
OutlineFitter::meetAtCorners()
{
  if (sides_.front().closed)
    return;
  for (std::size_t s = 0; s < sides_.size(); ++s)
    meet(sides_[s], sides_[(s + 1) % sides_.size()]);
}

void
OutlineFitter::evenNodes()
{
  for (OutlineSide& side : sides_) {
    const double steps = std::round(length(side.nodes, side.closed) / (node_step * spacing_));
    const double count = side.closed ? std::max(8.0, steps) : std::max(4.0, steps) + 1;
    side.nodes = resampled(side.nodes, static_cast<std::size_t>(count), side.closed);
  }
}

bool
OutlineFitter::dropFlatCorners()
{
  if (sides_.front().closed)
    return false;
  std::size_t flattest = 0;
  for (std::size_t s = 1; s < sides_.size(); ++s)
    if (std::abs(cornerTurn(s)) < std::abs(cornerTurn(flattest)))
      flattest = s;
  if (std::abs(cornerTurn(flattest)) >= corner_turn)
    return false;
  if (sides_.size() == 1) {
    sides_[0].closed = true;
    sides_[0].nodes.pop_back();
    return true;
  }
  const std::size_t before = (flattest + sides_.size() - 1) % sides_.size();
  OutlineSide& kept = sides_[before];
  const double kept_length = length(kept.nodes), lost_length = length(sides_[flattest].nodes);
  const double kept_share = kept_length / (kept_length + lost_length);
  for (Home& home : homes_) {
    if (home.side == flattest)
      home = {before, kept_share + (1.0 - kept_share) * home.share};
    else if (home.side == before)
      home.share *= kept_share;
    if (home.side > flattest)
      --home.side;
  }
  kept.nodes.insert(kept.nodes.end(), sides_[flattest].nodes.begin() + 1, sides_[flattest].nodes.end());
  sides_.erase(sides_.begin() + static_cast<std::ptrdiff_t>(flattest));
  return true;
}

Outline
OutlineFitter::fit()
{
  makeSides(cornerCandidates(points_, point_normals_, spacing_));
  constexpr double wavelength = 30.0;
  const auto round = [&](double blur) {
    layOnSurface();
    placePoints();
    const double moved = moveSides(blur, wavelength);
    meetAtCorners();
    evenNodes();
    return moved;
  };
  layOnSurface();
  while (dropFlatCorners()) {
    evenNodes();
    layOnSurface();
  }
  if (sides_.front().closed)
    for (const double blur : {0.5, 0.25, 0.12, 0.08, 0.08, 0.08})
      round(blur);
  layOnSurface();
  Outline outline;
  for (const OutlineSide& side : sides_) {
    if (!side.closed)
      outline.corners.push_back(outline.curve.size());
    outline.curve.insert(outline.curve.end(), side.nodes.begin(), side.nodes.end() - !side.closed);
  }
  return outline;
}

} // namespace

Outline
fitOutline(const MlsSurface& surface, const Ring& ring)
{
  return OutlineFitter(surface, ring).fit();
}

} // namespace pcl_spiral
