// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The frame in which the profile of a ridge keeps its shape along a rail.
 *
 *  A generator that runs along a smooth rail sweeps a ridge. It lies always in the normal plane of the rail, with constant coordinates in
 *  the local frame: x along the rail's tangent, y along the generator's chord from its start to its end, z = x cross y. The chord
 *  keeps its angle theta with a reference plane of unit normal N. Source: the feature-line method for ridges of press dies in 3-D
 *  laser surface hardening (China Mechanical Engineering), equation (1). Lengths in mm, angles in radians. */
#pragma once

#include <Eigen/Core>

#include <optional>

namespace pcl_spiral {

/** What the chord of a generator keeps constant along the rail. */
struct RidgeChord {
  Eigen::Vector3d reference = Eigen::Vector3d::UnitZ(); ///< N, unit
  double sin_angle = 0.0;                               ///< sine of the angle theta between the chord and the reference plane
  int branch = 1;                                       ///< sign of cos psi, 1 or -1: the side to which the measured chord points
};

/** The frame at a place of the rail, right-handed. */
struct RidgeFrame {
  Eigen::Vector3d tangent = Eigen::Vector3d::UnitX(); ///< m1, of the rail
  Eigen::Vector3d chord = Eigen::Vector3d::UnitY();   ///< m2
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();      ///< m3 = m1 cross m2
  double sin_psi = 0.0; ///< of the chord about the tangent, from the line e1 that is parallel to the reference plane
  double slope = 0.0;   ///< of the rail to the reference plane, from -pi/2 to pi/2

  /** \p local along the three directions of the frame. */
  Eigen::Vector3d turned(const Eigen::Vector3d& local) const { return local.x() * tangent + local.y() * chord + local.z() * up; }
  Eigen::Vector3d localOf(const Eigen::Vector3d& direction) const
  {
    return {tangent.dot(direction), chord.dot(direction), up.dot(direction)};
  }
  /** Factor from an error of the slope to the turn of the chord: |tan psi tan slope|. */
  double slopeFactor() const;
};

/** Equation (1) in closed form: e1 = N x m1 / rho, e2 = m1 x e1, rho = |N x m1| the cosine of the slope;
 *  m2 = cos psi e1 + sin psi e2 with sin psi = sin theta / rho. nullopt where the rail is so steep that no chord has the angle,
 *  |sin theta| >= rho: at equality both branches meet, and the choice between them is not defined. \p tangent is unit. */
std::optional<RidgeFrame> ridgeFrame(const Eigen::Vector3d& tangent, const RidgeChord& chord);

/** Angle and branch of the chord along \p direction, in the normal plane of \p tangent. Both unit. */
RidgeChord ridgeChord(const Eigen::Vector3d& tangent, const Eigen::Vector3d& direction, const Eigen::Vector3d& reference);

/** Rotation of the frame along the rail, in its own directions, 1/mm: each direction m changes by omega x m. \p curvature is the
 *  curvature vector of the rail, the derivative of the tangent by the length. omega2 = -k.m3, omega3 = k.m2, and as the chord keeps
 *  its angle, omega1 = omega3 (m1.N) / (m3.N). */
Eigen::Vector3d ridgeTurn(const RidgeFrame& frame, const Eigen::Vector3d& curvature, const Eigen::Vector3d& reference);

} // namespace pcl_spiral
