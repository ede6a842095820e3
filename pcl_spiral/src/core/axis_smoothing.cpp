// SPDX-License-Identifier: BSD-3-Clause
#include "axis_smoothing.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;
using Vectors = std::vector<Vector3d>;

constexpr double closest_knots = 1.0 / 300.0; // of the smoothing length; keeps the condition number of the system below 10^10
constexpr int most_rounds = 20;               // of weighting
constexpr double near_enough = 1.05;          // of the deviation allowed

/** The points of a path as knots. Points very near to each other make one knot. */
struct Knots {
  std::vector<double> at; ///< arc length
  Vectors wanted;
  std::vector<double> weight; ///< length of path that each one represents

  Knots(const std::vector<double>& s, const Vectors& axes, double closest)
  {
    for (std::size_t begin = 0, end; begin < s.size(); begin = end) {
      double place = 0.0;
      Vector3d sum = Vector3d::Zero();
      for (end = begin; end < s.size() && s[end] <= s[begin] + closest; ++end) {
        place += s[end] - s[begin];
        sum += axes[end];
      }
      const auto count = static_cast<double>(end - begin);
      at.push_back(s[begin] + place / count);
      wanted.push_back(end == begin + 1 ? axes[begin] : Vector3d(sum / count));
    }
    const std::size_t n = at.size();
    for (std::size_t k = 0; k < n; ++k)
      weight.push_back(0.5 * (at[std::min(k + 1, n - 1)] - at[k > 0 ? k - 1 : 0]));
  }
};

/** A natural cubic spline by values and second derivatives at its knots. */
struct Spline {
  Vectors value, second;

  /** Values at \p s between the knots \p at; beyond them the spline continues straight. */
  Vectors values(const std::vector<double>& at, const std::vector<double>& s) const
  {
    if (at.size() == 1)
      return Vectors(s.size(), value[0]);
    Vectors result;
    result.reserve(s.size());
    std::size_t k = 0;
    for (const double place : s) {
      while (k + 2 < at.size() && at[k + 1] <= place)
        ++k;
      const double h = at[k + 1] - at[k], ahead = at[k + 1] - place, back = place - at[k];
      Vector3d v = (back * value[k + 1] + ahead * value[k]) / h;
      if (back > 0.0 && ahead > 0.0)
        v -= back * ahead / 6.0 * ((1.0 + back / h) * second[k + 1] + (1.0 + ahead / h) * second[k]);
      result.push_back(back == 0.0 ? value[k] : v);
    }
    return result;
  }
};

/** The smoothing spline for given weights of the knots: (R + Q^T W^-1 Q) second = Q^T wanted, five diagonals, by L D L^T. */
class SmoothingSpline {
public:
  SmoothingSpline(const Knots& knots, double length)
  : knots_(knots), stiffness_(length * length * length * length), n_(knots.at.size()), d_(n_), l1_(n_), l2_(n_)
  {}

  void solve(const std::vector<double>& weights, Spline& spline)
  {
    spline.value = knots_.wanted;
    Vectors& z = spline.second;
    z.assign(n_, Vector3d::Zero());
    // Row k belongs to knot k: 1 to n - 2.
    for (std::size_t k = 1; k + 1 < n_; ++k) {
      const double a = inverse(k - 1), c = inverse(k), b = -a - c;
      const double p = penalty(weights[k - 1]), q = penalty(weights[k]), r = penalty(weights[k + 1]);
      double diagonal = (step(k - 1) + step(k)) / 3.0 + a * a * p + b * b * q + c * c * r;
      z[k] = a * (knots_.wanted[k - 1] - knots_.wanted[k]) + c * (knots_.wanted[k + 1] - knots_.wanted[k]);
      if (k > 1) {
        diagonal -= l1_[k - 1] * l1_[k - 1] * d_[k - 1];
        z[k] -= l1_[k - 1] * z[k - 1];
      }
      if (k > 2) {
        diagonal -= l2_[k - 2] * l2_[k - 2] * d_[k - 2];
        z[k] -= l2_[k - 2] * z[k - 2];
      }
      d_[k] = diagonal;
      if (k + 2 >= n_)
        break;
      const double next = -c - inverse(k + 1);
      double beside = step(k) / 6.0 + b * c * q + next * c * r;
      if (k > 1)
        beside -= l1_[k - 1] * l2_[k - 1] * d_[k - 1];
      l1_[k] = beside / diagonal;
      l2_[k] = k + 3 < n_ ? c * inverse(k + 1) * r / diagonal : 0.0;
    }
    for (std::size_t k = n_ - 1; k-- > 1;) {
      z[k] /= d_[k];
      if (k + 2 < n_)
        z[k] -= l1_[k] * z[k + 1];
      if (k + 3 < n_)
        z[k] -= l2_[k] * z[k + 2];
    }
    for (std::size_t k = 0; k < n_; ++k) {
      Vector3d bend = Vector3d::Zero();
      if (k > 0)
        bend += (z[k - 1] - z[k]) * inverse(k - 1);
      if (k + 1 < n_)
        bend += (z[k + 1] - z[k]) * inverse(k);
      spline.value[k] -= penalty(weights[k]) * bend;
    }
  }

private:
  double step(std::size_t k) const { return knots_.at[k + 1] - knots_.at[k]; }
  double inverse(std::size_t k) const { return 1.0 / step(k); }
  double penalty(double weight) const { return stiffness_ / weight; }

  const Knots& knots_;
  double stiffness_;
  std::size_t n_;
  std::vector<double> d_, l1_, l2_;
};

/** Means along a path: a value at distance d has the weight exp(-d / length). */
class MeanAlong {
public:
  MeanAlong(const Knots& knots, double length) : weight_(knots.weight), fade_(knots.at.size() - 1)
  {
    const auto steps = static_cast<std::int64_t>(fade_.size());
#pragma omp parallel for schedule(static)
    for (std::int64_t k = 0; k < steps; ++k)
      fade_[k] = std::exp((knots.at[k] - knots.at[k + 1]) / length);
  }

  std::vector<double> operator()(const std::vector<double>& values) const
  {
    const std::size_t n = values.size();
    std::vector<double> sum(n), whole(n);
    double s = 0.0, w = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      sum[k] = s += weight_[k] * values[k];
      whole[k] = w += weight_[k];
      s *= k + 1 < n ? fade_[k] : 0.0;
      w *= k + 1 < n ? fade_[k] : 0.0;
    }
    for (std::size_t k = n - 1; k-- > 0;) {
      s = fade_[k] * (s + weight_[k + 1] * values[k + 1]);
      w = fade_[k] * (w + weight_[k + 1]);
      sum[k] += s;
      whole[k] += w;
    }
    for (std::size_t k = 0; k < n; ++k)
      sum[k] /= whole[k];
    return sum;
  }

private:
  const std::vector<double>& weight_;
  std::vector<double> fade_;
};

} // namespace

Vectors
splineOfAxes(const std::vector<double>& s, const Vectors& wanted, double length, double max_deviation)
{
  const Knots knots(s, wanted, closest_knots * length);
  if (knots.at.size() < 3)
    return wanted;
  SmoothingSpline smoothing(knots, length);
  const MeanAlong meanOf(knots, length);
  std::vector<double> weights = knots.weight, deviations(knots.at.size());
  Spline spline;
  for (int round = 0; round < most_rounds; ++round) {
    smoothing.solve(weights, spline);
    for (std::size_t k = 0; k < deviations.size(); ++k)
      deviations[k] = (spline.value[k] - knots.wanted[k]).norm();
    bool kept = true;
    const std::vector<double> mean = meanOf(deviations);
    for (std::size_t k = 0; k < mean.size(); ++k)
      if (mean[k] > max_deviation) { // by as much as needed; otherwise the axis would make a step where this begins
        kept = kept && mean[k] < near_enough * max_deviation;
        const double excess = mean[k] / max_deviation;
        weights[k] *= excess * excess;
      }
    if (kept)
      break;
  }
  Vectors axes = spline.values(knots.at, s);
  for (std::size_t i = 0; i < axes.size(); ++i)
    axes[i] = axes[i].norm() > 1e-3 ? Vector3d(axes[i].normalized()) : wanted[i];
  return axes;
}

} // namespace pcl_spiral
