// SPDX-License-Identifier: BSD-3-Clause
#include "row_distance.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/step_over.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

/** Chord of an arc of the given length and curvature, at most the diameter. */
double
chordOf(double arc, double curvature)
{
  const double half_turn = std::min(0.5 * std::abs(curvature) * arc, 0.5 * pi);
  return half_turn < 1e-6 ? arc : 2.0 * std::sin(half_turn) / std::abs(curvature);
}

} // namespace

double
rowDistance(const SurfaceBend& place, const Eigen::Vector3d& across, double radius, double height, RowsThrough through)
{
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  const Eigen::Vector3d along = place.normal.cross(across);
  const double lean = along.norm(), k1 = place.curvature1, k2 = place.curvature2;
  if (!cutterFits(radius, std::min(k1, k2)))
    return unlimited;
  if (!(lean > 0.0))
    return 0.0;
  const Eigen::Vector3d w = along.cross(place.normal) / lean;
  const double c = w.dot(place.direction1), s = w.dot(place.normal.cross(place.direction1));
  const double across_rows = k1 * c * c + k2 * s * s, torsion = (k1 - k2) * c * s;
  const bool centres = through == RowsThrough::Centres;
  const double k = centres ? across_rows : across_rows - torsion * torsion / (k1 * s * s + k2 * c * c + 1.0 / radius);
  const auto step = stepOver(radius, k, height);
  return step ? (centres ? 1.0 + radius * k : 1.0) * chordOf(*step, k) * lean : unlimited;
}

} // namespace pcl_spiral
