// SPDX-License-Identifier: BSD-3-Clause
#include "revolution_axis.h"

#include "core/median.h"

#include <pcl_spiral/core/impl/frame.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;
using Vector8 = Eigen::Matrix<double, 8, 1>; // two turns and two shifts of the axis, cubic of n d
using Matrix8 = Eigen::Matrix<double, 8, 8>;

constexpr std::size_t fewest_points = 10;
constexpr std::size_t few_points = 2000; // enough to find the direction of the axis
constexpr int most_steps = 40;

/** Points relative to their mean, scaled to mean square distance 1. */
struct Sample {
  std::vector<Vector3d> points, normals;
  std::vector<double> weights;

  /** Some of the points, \p most or fewer. */
  Sample thinned(std::size_t most) const
  {
    Sample some;
    for (std::size_t i = 0; i < points.size(); i += (points.size() + most - 1) / most) {
      some.points.push_back(points[i]);
      some.normals.push_back(normals[i]);
      some.weights.push_back(weights[i]);
    }
    return some;
  }
};

struct Axis {
  Vector3d origin, direction;

  Axis moved(const Vector8& by) const
  {
    Vector3d e1, e2;
    tangentFrame(direction, e1, e2);
    return {origin + by[2] * e1 + by[3] * e2, (direction + by[0] * e1 + by[1] * e2).normalized()};
  }
};

/** Component of a normal round the axis; 0 on the axis. */
double
turningOf(const Axis& axis, const Vector3d& x, const Vector3d& n)
{
  const Vector3d round = axis.direction.cross(x - axis.origin);
  const double r = round.norm();
  return r > 1e-9 ? n.dot(round) / r : 0.0;
}

double
cubicAt(const Eigen::Vector4d& cubic, double z)
{
  return cubic[0] + z * (cubic[1] + z * (cubic[2] + z * cubic[3]));
}

/** One linearised problem: normal equations, and the weighted mean square of the residuals. */
struct Equations {
  Matrix8 normal = Matrix8::Zero();
  Vector8 right = Vector8::Zero();
  double square = 0.0, weight = 0.0;

  void add(const Vector8& row, double residual, double weight)
  {
    normal += weight * row * row.transpose();
    right -= weight * residual * row;
  }
};

Equations
equationsAt(const Sample& sample, const Axis& axis, const Eigen::Vector4d& cubic, double scale)
{
  constexpr double on_axis = 1e-9;
  Vector3d e[2];
  tangentFrame(axis.direction, e[0], e[1]);
  Equations equations;
  for (std::size_t i = 0; i < sample.points.size(); ++i) {
    const Vector3d &x = sample.points[i], &n = sample.normals[i], y = x - axis.origin, round = axis.direction.cross(y);
    const double z = axis.direction.dot(x), r = std::max(on_axis, round.norm()), turning = n.dot(round) / r;
    const Eigen::Vector4d powers(1.0, z, z * z, z * z * z);
    const double leaning = n.dot(axis.direction) - cubic.dot(powers);
    const double slope = cubic[1] + 2.0 * cubic[2] * z + 3.0 * cubic[3] * z * z;
    const Vector3d change = (n - round * (turning / r)) / r; // derivative of the turning
    Vector8 turning_row = Vector8::Zero(), leaning_row = Vector8::Zero();
    for (int j = 0; j < 2; ++j) {
      turning_row[j] = change.dot(e[j].cross(y));
      turning_row[2 + j] = -change.dot(axis.direction.cross(e[j]));
      leaning_row[j] = e[j].dot(n) - slope * e[j].dot(x);
    }
    leaning_row.tail<4>() = -powers;
    const double square = turning * turning + leaning * leaning;
    const double weight = sample.weights[i] / (1.0 + square / (scale * scale));
    equations.add(turning_row, turning, weight);
    equations.add(leaning_row, leaning, weight);
    equations.square += weight * square;
    equations.weight += weight;
  }
  return equations;
}

/** Residual at which Cauchy's weight is a half: twice the median residual, but at least about 3 degrees. */
double
scaleAt(const Sample& sample, const Axis& axis, const Eigen::Vector4d& cubic)
{
  std::vector<double> left;
  left.reserve(sample.points.size());
  for (std::size_t i = 0; i < sample.points.size(); ++i) {
    left.push_back(std::hypot(turningOf(axis, sample.points[i], sample.normals[i]),
                              sample.normals[i].dot(axis.direction) - cubicAt(cubic, axis.direction.dot(sample.points[i]))));
  }
  return std::max(0.05, 2.0 * medianOf(std::move(left)));
}

/** Place across \p direction that the normals pass closest to. Seen along \p direction they are straight lines. */
Vector3d
placeBetweenNormals(const Sample& sample, const Vector3d& direction)
{
  Eigen::Matrix3d normal = 1e-9 * Eigen::Matrix3d::Identity();
  Vector3d right = Vector3d::Zero();
  for (std::size_t i = 0; i < sample.points.size(); ++i) {
    const Vector3d across = direction.cross(sample.normals[i]);
    normal += sample.weights[i] * across * across.transpose();
    right += sample.weights[i] * across * across.dot(sample.points[i]);
  }
  const Vector3d place = normal.ldlt().solve(right);
  return place - direction * direction.dot(place);
}

struct AxisFit {
  RevolutionAxis axis;
  Axis end;
  double left = 0.0; ///< mean square of the normals' components round the axis, and of those along it less the cubic
};

AxisFit
judged(const Sample& sample, const Axis& axis, const Eigen::Vector4d& cubic, const Equations& equations)
{
  AxisFit fit;
  fit.end = axis;
  fit.axis.direction = axis.direction;
  fit.axis.origin = axis.origin - axis.direction * axis.direction.dot(axis.origin);
  double weights = 0.0;
  for (std::size_t i = 0; i < sample.points.size(); ++i) {
    const double turning = turningOf(axis, sample.points[i], sample.normals[i]), along = sample.normals[i].dot(axis.direction),
                 weight = sample.weights[i], leaning = along - cubicAt(cubic, axis.direction.dot(sample.points[i]));
    fit.axis.turning += weight * turning * turning;
    fit.axis.radial += weight * std::max(0.0, 1.0 - turning * turning - along * along);
    fit.left += weight * (turning * turning + leaning * leaning);
    weights += weight;
  }
  fit.axis.turning = std::sqrt(fit.axis.turning / weights);
  fit.axis.radial = std::sqrt(fit.axis.radial / weights);
  fit.left /= weights;
  // What the data determine of the turns after shift and cubic are eliminated.
  const Eigen::Matrix<double, 6, 6> others =
      equations.normal.bottomRightCorner<6, 6>() + 1e-12 * equations.weight * Eigen::Matrix<double, 6, 6>::Identity();
  const Eigen::Matrix<double, 6, 2> coupling = equations.normal.bottomLeftCorner<6, 2>();
  const Eigen::Matrix2d turns = equations.normal.topLeftCorner<2, 2>() - coupling.transpose() * others.ldlt().solve(coupling);
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(turns).eigenvalues()[0];
  fit.axis.uncertainty = std::sqrt((equations.square + 1e-8 * equations.weight) / std::max(least, 1e-300));
  return fit;
}

std::optional<AxisFit>
fitFrom(const Sample& sample, Axis axis)
{
  Eigen::Vector4d cubic = Eigen::Vector4d::Zero();
  for (int step = 0; step < most_steps; ++step) {
    const Equations equations = equationsAt(sample, axis, cubic, scaleAt(sample, axis, cubic));
    Matrix8 damped = equations.normal;
    damped.diagonal().array() += 1e-6 * equations.weight;
    Vector8 by = damped.ldlt().solve(equations.right);
    if (!by.allFinite())
      return std::nullopt;
    const double turn = by.head<2>().norm();
    if (turn > 0.3)
      by *= 0.3 / turn;
    axis = axis.moved(by);
    cubic += by.tail<4>();
    if (by.head<4>().norm() < 1e-8)
      break;
  }
  return judged(sample, axis, cubic, equationsAt(sample, axis, cubic, scaleAt(sample, axis, cubic)));
}

/** The fit with the smallest residual. A cylinder also goes round any distant axis across its own, as a piece of a huge ring: of fits
 *  with nearly equal residuals, the one with the most certain direction. */
std::optional<AxisFit>
bestOf(const std::vector<AxisFit>& fits)
{
  constexpr double as_much = 1.5, rounding = 1e-8;
  double least = std::numeric_limits<double>::max();
  for (const AxisFit& fit : fits)
    least = std::min(least, fit.left);
  std::optional<AxisFit> best;
  for (const AxisFit& fit : fits)
    if (fit.left <= as_much * least + rounding && !std::isnan(fit.axis.uncertainty) &&
        (!best || fit.axis.uncertainty < best->axis.uncertainty))
      best = fit;
  return best;
}

} // namespace

std::optional<RevolutionAxis>
fitRevolutionAxis(const std::vector<Vector3d>& points, const std::vector<Vector3d>& normals, const std::vector<double>& weights)
{
  double whole = 0.0, square = 0.0;
  Vector3d mean = Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    whole += weights[i];
    mean += weights[i] * points[i];
  }
  mean /= whole;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    square += weights[i] * (points[i] - mean).squaredNorm();
    spread += weights[i] * normals[i] * normals[i].transpose();
  }
  const double size = std::sqrt(square / whole);
  if (points.size() < fewest_points || !(size > 0.0) || !std::isfinite(size))
    return std::nullopt;
  Sample sample{{}, normals, weights};
  sample.points.reserve(points.size());
  for (const Vector3d& p : points)
    sample.points.push_back((p - mean) / size);
  const Eigen::Matrix3d start = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
  const Sample some = sample.thinned(few_points);
  std::vector<AxisFit> fits;
  for (int k = 0; k < 3; ++k)
    if (const auto fit = fitFrom(some, {placeBetweenNormals(some, start.col(k)), start.col(k)}))
      fits.push_back(*fit);
  std::optional<AxisFit> best = bestOf(fits);
  if (best)
    best = fitFrom(sample, best->end);
  if (!best)
    return std::nullopt;
  RevolutionAxis axis = best->axis;
  int largest = 0;
  axis.direction.cwiseAbs().maxCoeff(&largest);
  if (axis.direction[largest] < 0.0)
    axis.direction = -axis.direction;
  axis.origin = mean + size * axis.origin;
  return axis;
}

} // namespace pcl_spiral
