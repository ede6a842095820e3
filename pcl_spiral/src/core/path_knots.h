// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Knots of a spline along a path.
 */
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** The points of a path as knots. Points very near to each other make one knot. */
class KnotsOfPath {
public:
  KnotsOfPath(const std::vector<double>& s, const std::vector<Eigen::Vector3d>& axes, double closest) : s_(s), axes_(axes)
  {
    begin_.reserve(s.size() + 1);
    for (std::size_t i = 0; i < s.size();) {
      const double farthest = s[i] + closest;
      begin_.push_back(static_cast<std::uint32_t>(i));
      while (i < s.size() && s[i] <= farthest)
        ++i;
    }
    begin_.push_back(static_cast<std::uint32_t>(s.size()));
  }

  std::size_t size() const { return begin_.size() - 1; }
  const std::vector<double>& places() const { return s_; }
  const std::vector<Eigen::Vector3d>& axes() const { return axes_; }
  /** The first of the points of knot \p k. */
  std::size_t begin(std::size_t k) const { return begin_[k]; }
  /** Arc length of knot \p k, in the middle of its points. */
  double at(std::size_t k) const
  {
    double place = 0.0;
    for (std::size_t i = begin_[k]; i < begin_[k + 1]; ++i)
      place += s_[i] - s_[begin_[k]];
    return s_[begin_[k]] + place / points(k);
  }
  /** Mean axis of the points of knot \p k. */
  Eigen::Vector3d wanted(std::size_t k) const
  {
    if (begin_[k + 1] == begin_[k] + 1)
      return axes_[begin_[k]];
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t i = begin_[k]; i < begin_[k + 1]; ++i)
      sum += axes_[i];
    return sum / points(k);
  }
  /** Length of path that knot \p k represents. */
  double weight(std::size_t k) const { return 0.5 * (at(std::min(k + 1, size() - 1)) - at(k > 0 ? k - 1 : 0)); }

private:
  double points(std::size_t k) const { return static_cast<double>(begin_[k + 1] - begin_[k]); }

  const std::vector<double>& s_;
  const std::vector<Eigen::Vector3d>& axes_;
  std::vector<std::uint32_t> begin_; ///< first point of each knot, and the end
};

/** Knots of a path that follow each other. */
struct PathKnots {
  std::vector<double> at; ///< arc length
  std::vector<Eigen::Vector3d> wanted;
  std::vector<double> weight;

  PathKnots(const KnotsOfPath& all, std::size_t first, std::size_t last)
  {
    at.reserve(last - first);
    wanted.reserve(last - first);
    weight.reserve(last - first);
    for (std::size_t k = first; k < last; ++k) {
      at.push_back(all.at(k));
      wanted.push_back(all.wanted(k));
      weight.push_back(all.weight(k));
    }
  }
};

} // namespace pcl_spiral
