// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Exact ridges: a generator along a rail, by formulas and a frame solved by bisection.
 */
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace pcl_spiral::test {

/** Parameters are from 0 to 1, and a little beyond. */
struct ExactRidge {
  std::function<Eigen::Vector3d(double)> rail;
  std::function<Eigen::Vector3d(double)> generator; ///< along tangent, chord and up
  double theta = 0.0;                               ///< of the chord with the reference plane, radians
  Eigen::Vector3d reference = Eigen::Vector3d::UnitZ();

  /** Tangent, chord and up at \p t, one a column; up on the side of the reference normal. */
  Eigen::Matrix3d frame(double t) const;
  Eigen::Vector3d position(double t, double w) const;
  /** Unit, by central differences. */
  Eigen::Vector3d normal(double t, double w) const;
  /** Distance of \p p from the surface, and its nearest place (\p t, \p w), from those as a first guess. */
  double distance(const Eigen::Vector3d& p, double& t, double& w) const;
  /** The same from the best of a grid of guesses. */
  double distance(const Eigen::Vector3d& p) const;

  std::vector<Eigen::Vector3d> railPoints(std::size_t count) const;
  /** Points of the generator where it is measured. */
  std::vector<Eigen::Vector3d> generatorPoints(double measured_at, std::size_t count) const;
};

/** Ridge of a press die: 600 mm long, 24 wide. */
ExactRidge dieRidge();

/** A closed ring of radius \p radius about +Z with the generator (b, c). */
ExactRidge ringRidge(double radius, std::function<Eigen::Vector3d(double)> generator, double theta);

/** One turn of a helix about +Z. */
ExactRidge helixRidge(double radius, double slope, std::function<Eigen::Vector3d(double)> generator, double theta);

/** The points, each coordinate moved by Gaussian noise. */
std::vector<Eigen::Vector3d> moved(std::vector<Eigen::Vector3d> points, double sigma, std::uint64_t seed);

} // namespace pcl_spiral::test
