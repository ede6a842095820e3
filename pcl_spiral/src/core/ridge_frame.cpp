// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/ridge_frame.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** e1, parallel to the reference plane and across \p tangent, times rho. */
Eigen::Vector3d
levelAcross(const Eigen::Vector3d& tangent, const Eigen::Vector3d& reference)
{
  return reference.cross(tangent);
}

} // namespace

double
RidgeFrame::slopeFactor() const
{
  const double cos_psi = std::sqrt(std::max(0.0, 1.0 - sin_psi * sin_psi));
  return std::abs(sin_psi / cos_psi * std::tan(slope));
}

std::optional<RidgeFrame>
ridgeFrame(const Eigen::Vector3d& tangent, const RidgeChord& chord)
{
  const Eigen::Vector3d across = levelAcross(tangent, chord.reference);
  const double rho = across.norm();
  if (!(std::abs(chord.sin_angle) < rho))
    return std::nullopt;
  RidgeFrame frame;
  const Eigen::Vector3d e1 = across / rho, e2 = tangent.cross(e1);
  frame.sin_psi = chord.sin_angle / rho;
  frame.tangent = tangent;
  frame.chord = chord.branch * std::sqrt((1.0 - frame.sin_psi) * (1.0 + frame.sin_psi)) * e1 + frame.sin_psi * e2;
  frame.up = tangent.cross(frame.chord);
  frame.slope = std::atan2(tangent.dot(chord.reference), rho);
  return frame;
}

RidgeChord
ridgeChord(const Eigen::Vector3d& tangent, const Eigen::Vector3d& direction, const Eigen::Vector3d& reference)
{
  return {reference, direction.dot(reference), direction.dot(levelAcross(tangent, reference)) < 0.0 ? -1 : 1};
}

Eigen::Vector3d
ridgeTurn(const RidgeFrame& frame, const Eigen::Vector3d& curvature, const Eigen::Vector3d& reference)
{
  const double omega3 = curvature.dot(frame.chord);
  return {omega3 * frame.tangent.dot(reference) / frame.up.dot(reference), -curvature.dot(frame.up), omega3};
}

} // namespace pcl_spiral
