// SPDX-License-Identifier: BSD-3-Clause
#include "rim_zipper.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double flip_cost = 10.0;   // spacings
constexpr double largest_lag = 12.0; // spacings of arc length

/** The problem, with both sides rotated to begin at their closest pair of points. */
class Zipper {
public:
  Zipper(const ZipperSide& edge, const ZipperSide& outline, double length, double spacing)
  : edge_(edge), outline_(outline), length_(length), spacing_(spacing)
  {
    findBegin();
    unwrapArcs();
    findWindows();
  }

  std::vector<Triangulation::Triangle> solve()
  {
    if (!run())
      return {};
    std::vector<Triangulation::Triangle> strip;
    for (std::size_t a = edge_.ids.size(), c = outline_.ids.size(); a > 0 || c > 0;) {
      if (from_edge_[a][c - low_[a]]) {
        --a;
        strip.push_back({edgeId(a + 1), edgeId(a), outlineId(c)});
      }
      else {
        --c;
        strip.push_back({outlineId(c), outlineId(c + 1), edgeId(a)});
      }
    }
    std::reverse(strip.begin(), strip.end());
    return strip;
  }

private:
  std::size_t edgeAt(std::size_t a) const { return (a + first_edge_) % edge_.ids.size(); }
  std::size_t outlineAt(std::size_t c) const { return (c + first_outline_) % outline_.ids.size(); }
  std::uint32_t edgeId(std::size_t a) const { return edge_.ids[edgeAt(a)]; }
  std::uint32_t outlineId(std::size_t c) const { return outline_.ids[outlineAt(c)]; }

  /** Signed difference of arc lengths on the closed line, at most half its length. */
  double wrapped(double d) const { return d - length_ * std::round(d / length_); }

  void findBegin()
  {
    double best = std::numeric_limits<double>::max();
    for (std::size_t a = 0; a < edge_.ids.size(); ++a) {
      const auto at = std::lower_bound(outline_.arcs.begin(), outline_.arcs.end(), edge_.arcs[a]);
      for (int side = 0; side < 2; ++side) {
        const std::size_t c = (static_cast<std::size_t>(at - outline_.arcs.begin()) + outline_.ids.size() - side) % outline_.ids.size();
        const double d = (edge_.points[a] - outline_.points[c]).norm();
        if (d < best) {
          best = d;
          first_edge_ = a;
          first_outline_ = c;
        }
      }
    }
  }
  void unwrapArcs()
  {
    const double zero = outline_.arcs[first_outline_];
    for (std::size_t c = 0; c <= outline_.ids.size(); ++c)
      outline_arcs_.push_back(c == outline_.ids.size() ? length_ : std::fmod(outline_.arcs[outlineAt(c)] - zero + length_, length_));
    double arc = wrapped(edge_.arcs[first_edge_] - zero);
    for (std::size_t a = 0; a <= edge_.ids.size(); ++a) {
      if (a > 0)
        arc += wrapped(edge_.arcs[edgeAt(a)] - edge_.arcs[edgeAt(a - 1)]);
      edge_arcs_.push_back(arc);
    }
  }
  void findWindows()
  {
    const std::size_t rows = edge_arcs_.size(), last = outline_arcs_.size() - 1;
    const double reach = largest_lag * spacing_;
    low_.resize(rows);
    high_.resize(rows);
    for (std::size_t a = 0; a < rows; ++a) {
      const auto low = std::lower_bound(outline_arcs_.begin(), outline_arcs_.end(), edge_arcs_[a] - reach);
      const auto high = std::upper_bound(outline_arcs_.begin(), outline_arcs_.end(), edge_arcs_[a] + reach);
      low_[a] = std::min(last, static_cast<std::size_t>(low - outline_arcs_.begin()));
      high_[a] = high == outline_arcs_.begin() ? 0 : static_cast<std::size_t>(high - outline_arcs_.begin()) - 1;
    }
    low_[0] = 0;
    high_[rows - 1] = last;
    for (std::size_t a = rows - 1; a > 0; --a)
      low_[a - 1] = std::min(low_[a - 1], low_[a]);
    for (std::size_t a = 1; a < rows; ++a)
      high_[a] = std::max(high_[a], high_[a - 1]);
    for (std::size_t a = 0; a < rows; ++a)
      high_[a] = std::max(high_[a], low_[a]);
  }

  double flipCost(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& normal) const
  {
    return (b - a).cross(c - a).dot(normal) <= 0.0 ? flip_cost * spacing_ : 0.0;
  }
  /** Cost of the triangle over the edge's step from a to a + 1. */
  double edgeStep(std::size_t a, std::size_t c) const
  {
    const Eigen::Vector3d &p = edge_.points[edgeAt(a)], &q = edge_.points[edgeAt(a + 1)], &o = outline_.points[outlineAt(c)];
    return (q - o).norm() + flipCost(q, p, o, edge_.normals[edgeAt(a)]);
  }
  double outlineStep(std::size_t a, std::size_t c) const
  {
    const Eigen::Vector3d &o = outline_.points[outlineAt(c)], &n = outline_.points[outlineAt(c + 1)], &p = edge_.points[edgeAt(a)];
    return (p - n).norm() + flipCost(o, n, p, edge_.normals[edgeAt(a)]);
  }

  bool run()
  {
    const double infinite = std::numeric_limits<double>::infinity();
    const std::size_t rows = edge_arcs_.size();
    std::vector<double> above, row;
    from_edge_.resize(rows);
    for (std::size_t a = 0; a < rows; ++a) {
      row.assign(high_[a] - low_[a] + 1, infinite);
      from_edge_[a].assign(row.size(), 0);
      for (std::size_t c = low_[a]; c <= high_[a]; ++c) {
        double& cost = row[c - low_[a]];
        if (a == 0 && c == 0)
          cost = 0.0;
        if (a > 0 && c >= low_[a - 1] && c <= high_[a - 1]) {
          cost = above[c - low_[a - 1]] + edgeStep(a - 1, c);
          from_edge_[a][c - low_[a]] = 1;
        }
        if (c > low_[a]) {
          const double other = row[c - 1 - low_[a]] + outlineStep(a, c - 1);
          if (other < cost) {
            cost = other;
            from_edge_[a][c - low_[a]] = 0;
          }
        }
      }
      above.swap(row);
    }
    return high_.back() + 1 == outline_arcs_.size() && std::isfinite(above.back());
  }

  const ZipperSide &edge_, &outline_;
  double length_, spacing_;
  std::size_t first_edge_ = 0, first_outline_ = 0;
  std::vector<double> edge_arcs_, outline_arcs_; ///< from the begin, with one more at the end
  std::vector<std::size_t> low_, high_;          ///< window of outline points for each of the edge's
  std::vector<std::vector<std::uint8_t>> from_edge_;
};

} // namespace

std::vector<Triangulation::Triangle>
zipped(const ZipperSide& edge, const ZipperSide& outline, double length, double spacing)
{
  return Zipper(edge, outline, length, spacing).solve();
}

Polyline
pointsApart(const ZipperSide& edge, const ZipperSide& outline, double spacing)
{
  constexpr double far = 4.0; // spacings
  Polyline apart;
  for (const auto& [side, other] : {std::pair(&edge, &outline), std::pair(&outline, &edge)})
    for (const Eigen::Vector3d& p : side->points)
      if (std::none_of(other->points.begin(), other->points.end(), [&](const auto& q) { return (q - p).norm() < far * spacing; }))
        apart.push_back(p);
  return apart;
}

} // namespace pcl_spiral
