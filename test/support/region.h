// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Regions of the plane inside closed outlines, the parameter domains of the test surfaces.
 */
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace pcl_spiral::test {

/** A closed outline in the plane; the first vertex is not repeated. */
using PlaneLoop = std::vector<Eigen::Vector2d>;

/** The inside of the first, outer loop without the insides of the others. */
class Region {
public:
  Region() = default;
  explicit Region(std::vector<PlaneLoop> loops);

  const std::vector<PlaneLoop>& loops() const { return loops_; }
  bool contains(const Eigen::Vector2d& u) const;
  const Eigen::Vector2d& lower() const { return lower_; }
  const Eigen::Vector2d& upper() const { return upper_; }
  /** Intervals of the row v inside the region, ascending. */
  std::vector<std::pair<double, double>> row(double v) const;
  /** Integral of \p f over the region, by midpoint rows and 8-point Gauss rules along them. */
  double integrate(const std::function<double(const Eigen::Vector2d&)>& f, int rows = 800) const;

private:
  struct Edge {
    Eigen::Vector2d a, b;
  };
  const std::vector<Edge>& bucket(double v) const;

  std::vector<PlaneLoop> loops_;
  std::vector<std::vector<Edge>> buckets_; ///< edges by the rows they touch
  Eigen::Vector2d lower_ = Eigen::Vector2d::Zero(), upper_ = Eigen::Vector2d::Zero();
};

/** Loops, counter-clockwise. \p count vertices; the sagitta of a chord is radius * (pi / count)^2 / 2. */
PlaneLoop circle(const Eigen::Vector2d& centre, double radius, std::size_t count = 4096);
PlaneLoop ellipse(double a, double b, std::size_t count = 4096);
PlaneLoop rectangle(double width, double height, const Eigen::Vector2d& centre = Eigen::Vector2d::Zero());
/** An L of outer size \p size, limbs \p limb wide, its re-entrant corner up and right of the outer corner. */
PlaneLoop ell(double size, double limb);
/** A rectangle with two half circles at its ends. */
PlaneLoop slot(double length, double width, std::size_t count = 2048);
/** A star with \p tips tips on the radius \p outer and as many re-entrant corners on \p inner. */
PlaneLoop star(int tips, double outer, double inner);
/** An ellipse bent into a banana: (a cos t, b sin t + c x^2); re-entrant above. */
PlaneLoop kidney(double a, double b, double c, std::size_t count = 4096);

} // namespace pcl_spiral::test
