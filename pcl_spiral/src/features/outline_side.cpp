#include "outline_side.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;
using Triplets = std::vector<Eigen::Triplet<double>>;

/** The penalty as sum over rows of (row . d + constant)^2. */
struct Roughness {
  Matrix rows;
  Vector constant;
};

/** Differences of geodesic curvature from node to node (scaled by the root of \p weight / step), and, lightly, the
 *  curvature itself, which settles sides too short for more. */
Roughness
roughness(const OutlineSide& side, double spacing, double step, double weight)
{
  constexpr double straightness = 0.3;
  const auto m = static_cast<std::ptrdiff_t>(side.nodes.size());
  const std::ptrdiff_t curvatures = side.closed ? m : m - 2;
  const std::ptrdiff_t differences = side.closed ? m : m - 3;
  const auto node = [&](std::ptrdiff_t i) { return (i % m + m) % m; };
  // Curvature about node j: coefficients of d at j - 1, j, j + 1, and constant.
  struct Curvature {
    std::array<double, 3> at;
    double constant;
  };
  std::vector<Curvature> kappa(std::max<std::ptrdiff_t>(curvatures, 0));
  const auto centre = [&](std::ptrdiff_t j) { return node(side.closed ? j : j + 1); };
  const double h2 = step * step;
  for (std::ptrdiff_t j = 0; j < curvatures; ++j) {
    const std::ptrdiff_t c = centre(j), a = node(c - 1), b = node(c + 1);
    const Eigen::Vector3d& n = side.outward[c];
    kappa[j] = {{n.dot(side.outward[a]) / h2, -2.0 / h2, n.dot(side.outward[b]) / h2},
                n.dot(side.nodes[a] - 2.0 * side.nodes[c] + side.nodes[b]) / spacing / h2};
  }
  Triplets entries;
  Roughness result;
  const std::ptrdiff_t rows = std::max<std::ptrdiff_t>(differences, 0) + std::max<std::ptrdiff_t>(curvatures, 0);
  result.constant.setZero(rows);
  std::ptrdiff_t row = 0;
  const double difference_weight = std::sqrt(weight / step), own_weight = std::sqrt(straightness * step);
  const auto add = [&](const Curvature& k, std::ptrdiff_t at, double factor) {
    for (int i = 0; i < 3; ++i)
      entries.emplace_back(row, node(at - 1 + i), factor * k.at[i]);
    result.constant[row] += factor * k.constant;
  };
  for (std::ptrdiff_t j = 0; j < differences; ++j, ++row) {
    const std::ptrdiff_t next = side.closed ? node(j + 1) : j + 1;
    add(kappa[next], centre(next), difference_weight);
    add(kappa[j], centre(j), -difference_weight);
  }
  for (std::ptrdiff_t j = 0; j < curvatures; ++j, ++row)
    add(kappa[j], centre(j), own_weight);
  result.rows.resize(rows, m);
  result.rows.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/** Where a point's edge offset is read: two nodes and their weights (beyond the ends: extrapolated). */
struct Reading {
  std::ptrdiff_t a, b;
  double wa, wb;
};

Reading
reading(const OutlineSide& side, double place)
{
  const auto m = static_cast<std::ptrdiff_t>(side.nodes.size());
  auto a = static_cast<std::ptrdiff_t>(std::floor(place));
  if (side.closed) {
    const double f = place - static_cast<double>(a);
    a = (a % m + m) % m;
    return {a, (a + 1) % m, 1.0 - f, f};
  }
  a = std::clamp<std::ptrdiff_t>(a, 0, m - 2);
  const double f = place - static_cast<double>(a);
  return {a, a + 1, 1.0 - f, f};
}

/** The negative log-likelihood of the edge, with its penalty. */
class EdgeProblem {
public:
  EdgeProblem(const OutlineSide& side, double spacing, const std::vector<SidePoint>& points, const SideFit& fit)
  : points_(points), blur_(fit.blur), rough_(roughness(side, spacing, fit.step, std::pow(fit.wavelength / (2 * M_PI), 7)))
  {
    const auto m = static_cast<std::ptrdiff_t>(side.nodes.size());
    for (const SidePoint& p : points)
      readings_.push_back(reading(side, p.place));
    pressure_ = Vector::Constant(m, fit.step);
    if (!side.closed)
      pressure_[0] = pressure_[m - 1] = 0.5 * fit.step;
    Matrix identity(m, m);
    identity.setIdentity();
    penalty_ = rough_.rows.transpose() * rough_.rows + 1e-6 * identity;
  }

  /** A step from \p d that cannot increase the sum: each point's term is replaced by the parabola above it that touches
   *  it here (Jaakkola and Jordan 2000, equation 10). */
  Vector
  step(const Vector& d)
  {
    Vector gradient = pressure_ + rough_.rows.transpose() * (rough_.rows * d + rough_.constant);
    Triplets entries;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Reading& r = readings_[i];
      const double u = gap(i, d) / blur_;
      const double pull = 1.0 / (1.0 + std::exp(u));
      gradient[r.a] -= r.wa * pull / blur_;
      gradient[r.b] -= r.wb * pull / blur_;
      const double w = (std::abs(u) > 1e-3 ? std::tanh(0.5 * u) / (2.0 * u) : 0.25) / (blur_ * blur_);
      entries.emplace_back(r.a, r.a, w * r.wa * r.wa);
      entries.emplace_back(r.b, r.b, w * r.wb * r.wb);
      entries.emplace_back(r.a, r.b, w * r.wa * r.wb);
      entries.emplace_back(r.b, r.a, w * r.wa * r.wb);
    }
    Matrix hessian(d.size(), d.size());
    hessian.setFromTriplets(entries.begin(), entries.end());
    hessian += penalty_;
    solver_.compute(hessian);
    return -solver_.solve(gradient);
  }

private:
  /** How far point i lies within the edge. */
  double
  gap(std::size_t i, const Vector& d) const
  {
    const Reading& r = readings_[i];
    return r.wa * d[r.a] + r.wb * d[r.b] - points_[i].offset;
  }

  const std::vector<SidePoint>& points_;
  double blur_;
  Roughness rough_;
  std::vector<Reading> readings_;
  Vector pressure_;
  Matrix penalty_;
  Eigen::SimplicialLDLT<Matrix> solver_;
};

} // namespace

std::vector<double>
fitOffsets(const OutlineSide& side, double spacing, const std::vector<SidePoint>& points, const SideFit& fit)
{
  constexpr int most_steps = 40;
  Vector d = Vector::Zero(static_cast<std::ptrdiff_t>(side.nodes.size()));
  EdgeProblem problem(side, spacing, points, fit);
  for (int i = 0; i < most_steps; ++i) {
    const Vector step = problem.step(d);
    d += step;
    if (step.cwiseAbs().maxCoeff() < 1e-3 * fit.blur)
      break;
  }
  return std::vector<double>(d.data(), d.data() + d.size());
}

} // namespace pcl_spiral
