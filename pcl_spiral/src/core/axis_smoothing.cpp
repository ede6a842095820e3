// SPDX-License-Identifier: BSD-3-Clause
#include "axis_smoothing.h"

#include "core/parallel_resize.h"
#include "core/path_knots.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;
using Vectors = std::vector<Vector3d>;

constexpr double closest_knots = 1.0 / 300.0; // of the smoothing length; keeps the condition number of the system below 10^10
constexpr int most_rounds = 20;               // of weighting
constexpr double near_enough = 1.05;          // of the deviation allowed

// What is far away has no part in a double. From one knot to the next, a change of the spline fades by exp(-step / (sqrt(2) length)),
// but where steps are much longer than the length by no less than 2 - sqrt(3) = exp(-1.3), as an interpolating spline; a mean by
// exp(-step / length). To 1e-17, exp(-39), a change thus fades over 39, and through a mean over 28 more.
constexpr double fading = 70.0;       // sum of step / (sqrt(2) length), each at most steepest
constexpr double steepest = 1.3;      // from one knot to the next
constexpr double part_length = 700.0; // the same sum over a part of a path; only speed: of ten fadings, a fifth is solved twice

/** A natural cubic spline by values and second derivatives at its knots. */
struct Spline {
  Vectors value, second;

  /** The value at \p place, beside or beyond knots \p k and k + 1, which are at \p at; beyond all knots the spline continues straight. */
  Vector3d between(const std::vector<double>& at, std::size_t k, double place) const
  {
    const double h = at[k + 1] - at[k], ahead = at[k + 1] - place, back = place - at[k];
    if (back == 0.0)
      return value[k];
    Vector3d result = (back * value[k + 1] + ahead * value[k]) / h;
    if (back > 0.0 && ahead > 0.0)
      result -= back * ahead / 6.0 * ((1.0 + back / h) * second[k + 1] + (1.0 + ahead / h) * second[k]);
    return result;
  }
};

/** The smoothing spline for weights of the knots: (R + Q^T W^-1 Q) second = Q^T wanted, five diagonals, by L D L^T. Solved again after
 *  some weights have changed, it goes only through the rows whose numbers change: the same result as from the start. */
class SmoothingSpline {
public:
  SmoothingSpline(const PathKnots& knots, double length)
  : knots_(knots), stiffness_(length * length * length * length), n_(knots.at.size()), inverse_(n_ - 1), penalty_(n_), d_(n_), l1_(n_),
    l2_(n_), ahead_(n_, Vector3d::Zero())
  {
    for (std::size_t k = 0; k + 1 < n_; ++k)
      inverse_[k] = 1.0 / step(k);
  }

  /** \p changed: one entry a knot, 1 where the weight is new; after it, 1 where the value of \p spline is. */
  void solve(const std::vector<double>& weights, std::vector<std::uint8_t>& changed, Spline& spline)
  {
    spline.value.resize(n_, Vector3d::Constant(std::numeric_limits<double>::quiet_NaN())); // equal to nothing: all are new at first
    spline.second.resize(n_, Vector3d::Zero());
    std::vector<std::uint8_t> rows(n_, 0); // 1 where the row's part of L D L^T, or of the right side, is new
    for (std::size_t k = 0; k < n_; ++k)
      if (changed[k])
        penalty_[k] = stiffness_ / weights[k];
    for (std::size_t k = 1; k + 1 < n_; ++k)
      if (changed[k - 1] || changed[k] || changed[k + 1] || rows[k - 1] || (k > 1 && rows[k - 2]))
        rows[k] = eliminate(k);
    for (std::size_t k = n_ - 1; k-- > 1;)
      if (rows[k] || rows[k + 1] || (k + 2 < n_ && rows[k + 2])) { // from here on 1 where the second derivative is new
        const Vector3d before = spline.second[k];
        spline.second[k] = ahead_[k] / d_[k];
        if (k + 2 < n_)
          spline.second[k] -= l1_[k] * spline.second[k + 1];
        if (k + 3 < n_)
          spline.second[k] -= l2_[k] * spline.second[k + 2];
        rows[k] = spline.second[k] != before;
      }
    const Vectors& z = spline.second;
    for (std::size_t k = 0; k < n_; ++k) {
      if (!changed[k] && !rows[k] && !(k > 0 && rows[k - 1]) && !(k + 1 < n_ && rows[k + 1]))
        continue;
      Vector3d bend = Vector3d::Zero();
      if (k > 0)
        bend += (z[k - 1] - z[k]) * inverse_[k - 1];
      if (k + 1 < n_)
        bend += (z[k + 1] - z[k]) * inverse_[k];
      const Vector3d before = spline.value[k];
      spline.value[k] = knots_.wanted[k] - penalty_[k] * bend;
      changed[k] = spline.value[k] != before;
    }
  }

private:
  /** Row \p k, of knots 1 to n - 2, of the factors and of L^-1 times the right side. True if one of its numbers is new. */
  bool eliminate(std::size_t k)
  {
    const double a = inverse_[k - 1], c = inverse_[k], b = -a - c;
    const double p = penalty_[k - 1], q = penalty_[k], r = penalty_[k + 1];
    double diagonal = (step(k - 1) + step(k)) / 3.0 + a * a * p + b * b * q + c * c * r;
    Vector3d z = a * (knots_.wanted[k - 1] - knots_.wanted[k]) + c * (knots_.wanted[k + 1] - knots_.wanted[k]);
    if (k > 1) {
      diagonal -= l1_[k - 1] * l1_[k - 1] * d_[k - 1];
      z -= l1_[k - 1] * ahead_[k - 1];
    }
    if (k > 2) {
      diagonal -= l2_[k - 2] * l2_[k - 2] * d_[k - 2];
      z -= l2_[k - 2] * ahead_[k - 2];
    }
    double l1 = 0.0, l2 = 0.0;
    if (k + 2 < n_) {
      const double next = -c - inverse_[k + 1];
      double beside = step(k) / 6.0 + b * c * q + next * c * r;
      if (k > 1)
        beside -= l1_[k - 1] * l2_[k - 1] * d_[k - 1];
      l1 = beside / diagonal;
      l2 = k + 3 < n_ ? c * inverse_[k + 1] * r / diagonal : 0.0;
    }
    const bool is_new = d_[k] != diagonal || l1_[k] != l1 || l2_[k] != l2 || ahead_[k] != z;
    d_[k] = diagonal;
    l1_[k] = l1;
    l2_[k] = l2;
    ahead_[k] = z;
    return is_new;
  }
  double step(std::size_t k) const { return knots_.at[k + 1] - knots_.at[k]; }

  const PathKnots& knots_;
  double stiffness_;
  std::size_t n_;
  std::vector<double> inverse_, penalty_; ///< of the steps; stiffness over weight
  std::vector<double> d_, l1_, l2_;
  Vectors ahead_; ///< L^-1 times the right side
};

/** Means along a path: a value at distance d has the weight exp(-d / length). Like the spline, made anew only where they change. */
class MeanAlong {
public:
  MeanAlong(const PathKnots& knots, double length)
  : weight_(knots.weight), fade_(knots.at.size() - 1), before_(knots.at.size(), 0.0), after_(knots.at.size(), 0.0)
  {
    for (std::size_t k = 0; k < fade_.size(); ++k)
      fade_[k] = std::exp((knots.at[k] - knots.at[k + 1]) / length);
    whole_.resize(weight_.size());
    double w = 0.0;
    for (std::size_t k = 0; k < weight_.size(); ++k) {
      whole_[k] = w += weight_[k];
      w *= k < fade_.size() ? fade_[k] : 0.0;
    }
    for (std::size_t k = fade_.size(); k-- > 0;) {
      w = fade_[k] * (w + weight_[k + 1]);
      whole_[k] += w;
    }
  }

  /** Into \p mean the means of \p values. \p changed: one entry a knot, 1 where the value is new; after it, 1 where the mean is. */
  void find(const std::vector<double>& values, std::vector<std::uint8_t>& changed, std::vector<double>& mean)
  {
    const std::size_t n = values.size();
    std::vector<std::uint8_t> sums(n, 0); // 1 where a sum is new
    const auto put = [](double& old, double now, std::uint8_t& mark) {
      mark = mark || old != now;
      old = now;
    };
    bool is_new = false;
    for (std::size_t k = 0; k < n; ++k)
      if (changed[k] || is_new) {
        const double sum = weight_[k] * values[k] + (k > 0 ? fade_[k - 1] * before_[k - 1] : 0.0);
        is_new = before_[k] != sum;
        put(before_[k], sum, sums[k]);
      }
    is_new = false;
    for (std::size_t k = n - 1; k-- > 0;)
      if (changed[k + 1] || is_new) {
        const double sum = fade_[k] * (after_[k + 1] + weight_[k + 1] * values[k + 1]);
        is_new = after_[k] != sum;
        put(after_[k], sum, sums[k]);
      }
    for (std::size_t k = 0; k < n; ++k)
      if (sums[k])
        mean[k] = (before_[k] + after_[k]) / whole_[k];
    changed = std::move(sums);
  }

private:
  const std::vector<double>& weight_;
  std::vector<double> fade_, whole_;   ///< from a knot to the next; of the weights
  std::vector<double> before_, after_; ///< sums up to each knot and beyond it
};

/** A part of a path, solved with as much of the path before and after it as has a part in its numbers. */
class SmoothedPart {
public:
  /** Its knots, from begin up to end, in those with a part in its numbers, from first up to last. */
  struct Range {
    std::size_t begin, end, first, last;

    /** \p faded: by how much a change fades from the first knot to each. */
    Range(const std::vector<double>& faded, std::size_t from, std::size_t to) : begin(from), end(to)
    {
      first = static_cast<std::size_t>(std::lower_bound(faded.begin(), faded.end(), faded[begin] - fading) - faded.begin());
      last = static_cast<std::size_t>(std::upper_bound(faded.begin(), faded.end(), faded[end - 1] + fading) - faded.begin());
    }
    /** Whether one of its knots has a mark in \p marked. */
    bool holds(const std::vector<std::uint8_t>& marked) const { return std::memchr(&marked[first], 1, last - first) != nullptr; }
  };

  SmoothedPart(const SmoothedPart&) = delete; // its members refer to each other
  SmoothedPart(const KnotsOfPath& all, const Range& range, double length)
  : all_(all), begin_(range.begin), end_(range.end), first_(range.first), knots_(all, range.first, range.last), spline_(knots_, length),
    along_(knots_, length), deviations_(knots_.at.size()), means_(knots_.at.size(), 0.0)
  {}

  /** Solve it again for \p weights, of which those with a mark in \p changed are new. */
  void solve(const std::vector<double>& weights, const std::vector<std::uint8_t>& changed)
  {
    const auto first = static_cast<std::ptrdiff_t>(first_), last = first + static_cast<std::ptrdiff_t>(knots_.at.size());
    std::vector<std::uint8_t> fresh(knots_.at.size(), 1);
    if (!solved_.value.empty())
      fresh.assign(changed.begin() + first, changed.begin() + last);
    spline_.solve({weights.begin() + first, weights.begin() + last}, fresh, solved_);
    for (std::size_t k = 0; k < deviations_.size(); ++k)
      if (fresh[k])
        deviations_[k] = (solved_.value[k] - knots_.wanted[k]).norm();
    along_.find(deviations_, fresh, means_);
  }

  /** The unit values of its spline at its points into \p axes, those of the whole path; where one is almost zero, the wanted axis. */
  void store(Vectors& axes) const
  {
    const std::vector<double>& at = knots_.at;
    std::size_t k = 0;
    for (std::size_t i = all_.begin(begin_); i < all_.begin(end_); ++i) {
      const double place = all_.places()[i];
      while (k + 2 < at.size() && at[k + 1] <= place)
        ++k;
      const Vector3d axis = solved_.between(at, k, place);
      axes[i] = axis.norm() > 1e-3 ? Vector3d(axis.normalized()) : all_.axes()[i];
    }
  }

  /** Whether the mean deviation is above \p most somewhere. */
  bool exceeds(double most) const
  {
    const auto begin = means_.begin() + static_cast<std::ptrdiff_t>(begin_ - first_);
    return std::any_of(begin, begin + static_cast<std::ptrdiff_t>(end_ - begin_), [most](double mean) { return mean > most; });
  }

  /** Raises the weights where the mean deviation is above \p most, by as much as needed, otherwise the axis would make a step where this
   *  begins, and marks them. False if it is far above somewhere. */
  bool raise(double most, std::vector<double>& weights, std::vector<std::uint8_t>& changed) const
  {
    bool kept = true;
    for (std::size_t k = begin_; k < end_; ++k)
      if (means_[k - first_] > most) {
        const double excess = means_[k - first_] / most;
        kept = kept && excess < near_enough;
        weights[k] *= excess * excess;
        changed[k] = 1;
      }
    return kept;
  }

private:
  const KnotsOfPath& all_;
  std::size_t begin_, end_, first_; ///< first_: index of the first of knots_
  PathKnots knots_;
  SmoothingSpline spline_;
  MeanAlong along_;
  Spline solved_;
  std::vector<double> deviations_, means_;
};

/** By how much a change fades from the first knot to each, see fading. */
std::vector<double>
fadedAlong(const KnotsOfPath& knots, double length)
{
  std::vector<double> faded(knots.size(), 0.0);
  double before = knots.at(0);
  for (std::size_t k = 1; k < faded.size(); ++k) {
    const double at = knots.at(k);
    faded[k] = faded[k - 1] + std::min(steepest, (at - before) / (std::sqrt(2.0) * length));
    before = at;
  }
  return faded;
}

/** Ends of the parts of a path. */
std::vector<std::size_t>
partEnds(const std::vector<double>& faded)
{
  std::vector<std::size_t> ends;
  for (std::size_t begin = 0; begin < faded.size(); begin = ends.back())
    ends.push_back(static_cast<std::size_t>(std::upper_bound(faded.begin(), faded.end(), faded[begin] + part_length) - faded.begin()));
  return ends;
}

} // namespace

Vectors
splineOfAxes(const std::vector<double>& s, const Vectors& wanted, double length, double max_deviation)
{
  const KnotsOfPath knots(s, wanted, closest_knots * length);
  if (knots.size() < 3)
    return wanted;
  const std::vector<double> faded = fadedAlong(knots, length);
  const std::vector<std::size_t> ends = partEnds(faded);
  const auto count = static_cast<std::int64_t>(ends.size()), whole = static_cast<std::int64_t>(knots.size());
  std::vector<std::unique_ptr<SmoothedPart>> parts(ends.size()); // those that exceed the deviation
  std::vector<double> weights(knots.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t k = 0; k < whole; ++k)
    weights[k] = knots.weight(k);
  std::vector<std::uint8_t> changed(knots.size(), 1);
  Vectors axes;
  resizeInParallel(axes, s.size());
  bool kept = false;
  for (int round = 0; round < most_rounds && !kept; ++round) {
#pragma omp parallel for schedule(dynamic)
    for (std::int64_t p = 0; p < count; ++p) {
      const SmoothedPart::Range range(faded, p > 0 ? ends[p - 1] : 0, ends[p]);
      if (!range.holds(changed))
        continue;
      if (!parts[p])
        parts[p] = std::make_unique<SmoothedPart>(knots, range, length);
      parts[p]->solve(weights, changed);
      parts[p]->store(axes);
      if (!parts[p]->exceeds(max_deviation))
        parts[p].reset();
    }
    kept = true;
    std::fill(changed.begin(), changed.end(), 0);
    for (const auto& part : parts)
      if (part)
        kept = part->raise(max_deviation, weights, changed) && kept;
  }
  return axes;
}

} // namespace pcl_spiral
