// SPDX-License-Identifier: BSD-3-Clause
#include "edge_fit.h"

#include "core/band_system.h"
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double straightness = 0.3; // weight of the squared curvature: settles sides too short for more
constexpr double tether = 1.0;       // weight of the squared offset: one fit moves a side no farther than its points warrant

/** A weighted sum of neighbouring offsets, plus a constant. */
struct Stencil {
  std::array<std::size_t, 4> node{};
  std::array<double, 4> factor{};
  int size = 0;
  double constant = 0.0;

  void add(std::size_t i, double f)
  {
    for (int k = 0; k < size; ++k)
      if (node[k] == i) {
        factor[k] += f;
        return;
      }
    node[size] = i;
    factor[size++] = f;
  }
  void add(const Stencil& other, double f)
  {
    for (int k = 0; k < other.size; ++k)
      add(other.node[k], f * other.factor[k]);
    constant += f * other.constant;
  }
  double value(const std::vector<double>& d) const
  {
    double sum = constant;
    for (int k = 0; k < size; ++k)
      sum += factor[k] * d[node[k]];
    return sum;
  }
};

/** How far a point lies within the edge: between the offsets of two neighbouring nodes, less its own. */
struct Gap {
  std::size_t before, after;
  double share; ///< of the way from the one node to the other
  double offset;

  double value(const std::vector<double>& d) const { return (1.0 - share) * d[before] + share * d[after] - offset; }
};

/** Geodesic curvature at every inner node (at every node of a closed side) as it depends on the offsets, 1/spacing. */
std::vector<Stencil>
curvatures(const EdgeSide& side, double spacing, double step)
{
  const std::size_t m = side.nodes.size();
  const double h2 = step * step;
  std::vector<Stencil> result;
  for (std::size_t c = side.closed ? 0 : 1; c < (side.closed ? m : m - 1); ++c) {
    const std::size_t a = (c + m - 1) % m, b = (c + 1) % m;
    const Eigen::Vector3d& n = side.outward[c];
    Stencil s;
    s.add(a, n.dot(side.outward[a]) / h2);
    s.add(c, -2.0 / h2);
    s.add(b, n.dot(side.outward[b]) / h2);
    s.constant = n.dot(side.nodes[a] - 2.0 * side.nodes[c] + side.nodes[b]) / spacing / h2;
    result.push_back(s);
  }
  return result;
}

/** The terms whose halved squares make up the roughness. */
std::vector<Stencil>
roughness(const EdgeSide& side, const EdgeOptions& options, double step)
{
  const std::vector<Stencil> kappa = curvatures(side, options.spacing, step);
  const double change = std::sqrt(std::pow(options.wavelength / (2.0 * pi), 7) / step);
  const std::size_t count = kappa.size();
  std::vector<Stencil> terms;
  for (std::size_t j = 0; j + (side.closed ? 0 : 1) < count; ++j) {
    Stencil difference;
    difference.add(kappa[j], -change);
    difference.add(kappa[(j + 1) % count], change);
    terms.push_back(difference);
  }
  for (const Stencil& k : kappa) {
    Stencil own;
    own.add(k, std::sqrt(straightness * step));
    terms.push_back(own);
  }
  return terms;
}

Gap
gapOf(const EdgeSide& side, const SidePoint& point)
{
  const auto m = static_cast<std::ptrdiff_t>(side.nodes.size());
  auto a = static_cast<std::ptrdiff_t>(std::floor(point.place));
  if (!side.closed)
    a = std::clamp<std::ptrdiff_t>(a, 0, m - 2);
  const double f = point.place - static_cast<double>(a);
  a = (a % m + m) % m;
  return {static_cast<std::size_t>(a), static_cast<std::size_t>((a + 1) % m), f, point.offset};
}

/** Sum over points of -log of the share of blurred points that are seen as deep as u blurs within the edge,
 *  log (1 + exp(-u)): the logarithm of a product of a few at a time. */
class OutsideCost {
public:
  /** \p small = exp(-|u|). */
  void add(double u, double small)
  {
    product_ *= 1.0 + small;
    sum_ -= std::min(u, 0.0);
    if (++count_ % 64 == 0)
      flush();
  }
  double total()
  {
    flush();
    return sum_;
  }

private:
  void flush()
  {
    sum_ += std::log(product_);
    product_ = 1.0;
  }

  double sum_ = 0.0, product_ = 1.0;
  int count_ = 0;
};

/** The convex function of the offsets that the edge minimises. */
class EdgeProblem {
public:
  EdgeProblem(const EdgeSide& side, const std::vector<SidePoint>& points, const EdgeOptions& options)
  : blur_(options.blur), penalty_(side.nodes.size(), 3, side.closed), pressure_(side.nodes.size())
  {
    const std::size_t m = side.nodes.size();
    const double step = length(side.nodes, side.closed) / options.spacing / static_cast<double>(side.segments());
    terms_ = roughness(side, options, step);
    for (const SidePoint& p : points)
      gaps_.push_back(gapOf(side, p));
    deep_.resize(gaps_.size());
    small_.resize(gaps_.size());
    for (std::size_t i = 0; i < m; ++i) {
      pressure_[i] = side.closed || (i > 0 && i + 1 < m) ? step : 0.5 * step;
      penalty_.add(i, i, tether * step);
    }
    for (const Stencil& t : terms_)
      addSquare(penalty_, t, 1.0);
  }

  /** Its value at \p d, where the next step starts from. */
  double value(const std::vector<double>& d)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < d.size(); ++i)
      sum += pressure_[i] * d[i] * (1.0 + 0.5 * tether * d[i]);
    sum += outside(d);
    for (const Stencil& t : terms_)
      sum += 0.5 * std::pow(t.value(d), 2);
    return sum;
  }

  /** Newton's step from \p d, the place of the last value; a point far outside counts with some curvature too. */
  std::vector<double> step(const std::vector<double>& d) const
  {
    std::vector<double> descent(d.size());
    for (std::size_t i = 0; i < d.size(); ++i)
      descent[i] = -pressure_[i] * (1.0 + tether * d[i]);
    for (const Stencil& t : terms_)
      addScaled(descent, t, -t.value(d));
    BandSystem hessian = penalty_;
    for (std::size_t k = 0; k < gaps_.size(); ++k) {
      const double u = deep_[k];
      if (u > 40.0)
        continue;
      const Gap& gap = gaps_[k];
      const double pull = u > 0.0 ? small_[k] / (1.0 + small_[k]) : 1.0 / (1.0 + small_[k]); // 1 / (1 + exp(u))
      const double f = gap.share, e = 1.0 - f;
      descent[gap.before] += e * pull / blur_;
      descent[gap.after] += f * pull / blur_;
      const double weight = (pull * (1.0 - pull) + 0.02 * pull / (1.0 + std::abs(u))) / (blur_ * blur_);
      hessian.add(gap.before, gap.before, weight * e * e);
      hessian.add(gap.after, gap.before, weight * f * e);
      hessian.add(gap.after, gap.after, weight * f * f);
    }
    hessian.solve(descent);
    return descent;
  }

  EdgeFit result(std::vector<double> d)
  {
    EdgeFit fit;
    for (std::size_t i = 0; i < d.size(); ++i)
      fit.area += pressure_[i] * d[i];
    fit.outside = outside(d);
    for (const Stencil& t : terms_)
      fit.roughness += 0.5 * t.value(d) * t.value(d);
    fit.offsets = std::move(d);
    return fit;
  }

private:
  double outside(const std::vector<double>& d)
  {
    OutsideCost cost;
    for (std::size_t k = 0; k < gaps_.size(); ++k) {
      deep_[k] = gaps_[k].value(d) / blur_;
      small_[k] = std::exp(-std::abs(deep_[k]));
      cost.add(deep_[k], small_[k]);
    }
    return cost.total();
  }
  static void addSquare(BandSystem& matrix, const Stencil& s, double weight)
  {
    for (int i = 0; i < s.size; ++i)
      for (int j = 0; j <= i; ++j)
        matrix.add(s.node[i], s.node[j], weight * s.factor[i] * s.factor[j]);
  }
  static void addScaled(std::vector<double>& sum, const Stencil& s, double weight)
  {
    for (int i = 0; i < s.size; ++i)
      sum[s.node[i]] += weight * s.factor[i];
  }

  double blur_;
  std::vector<Stencil> terms_;
  std::vector<Gap> gaps_;
  std::vector<double> deep_, small_; ///< of each point at the last value: u in blurs within the edge, exp(-|u|)
  BandSystem penalty_;
  std::vector<double> pressure_;
};

} // namespace

EdgeFit
fitEdge(const EdgeSide& side, const std::vector<SidePoint>& points, const EdgeOptions& options)
{
  constexpr int most_steps = 40;
  EdgeProblem problem(side, points, options);
  std::vector<double> d(side.nodes.size(), 0.0);
  double value = problem.value(d);
  for (int i = 0; i < most_steps; ++i) {
    const std::vector<double> step = problem.step(d);
    double largest = 0.0;
    for (const double s : step)
      largest = std::max(largest, std::abs(s));
    double share = 1.0, tried = value;
    std::vector<double> there(d.size());
    for (int half = 0; half < 8; ++half, share *= 0.5) {
      for (std::size_t k = 0; k < d.size(); ++k)
        there[k] = d[k] + share * step[k];
      tried = problem.value(there);
      if (tried < value)
        break;
    }
    if (!(tried < value))
      break;
    const bool settled = share * largest < 1e-3 * options.blur;
    d.swap(there);
    value = tried;
    if (settled)
      break;
  }
  return problem.result(std::move(d));
}

} // namespace pcl_spiral
