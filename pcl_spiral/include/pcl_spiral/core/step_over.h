// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Step-over from scallop height, scallop height from step-over, step from chord error.
 *
 *  Radius R of the ball, scallop height h and chord error e are in mm. Curvature kappa = 1/rho is in 1/mm,
 * that of the normal section across the feed (step-over) or along it (step): positive where convex, 0 where
 * flat, negative where concave. Step-overs are lengths along the surface. Nothing here returns NaN: a result that
 * does not exist is std::nullopt.
 */
#pragma once

#include <optional>

namespace pcl_spiral {

/** True if a ball of \p radius touches a section of \p curvature at one point only: 1 + R kappa > 0. In a
 * concave section this requires R < |rho|. If it is false there is no step-over and the ball gouges. */
bool cutterFits(double radius, double curvature);

/** The \p curvature by which turns are spaced where a ball of \p radius hardly fits or does not fit. With c = 1 + R kappa: kappa itself for
 *  c of 0.05 and more. Below, no step-over exists, and the ball rests on the sides of the hollow: c is replaced by -c, but at
 *  least 0.05, and at most 1, the plane. No scallop height follows from it there. */
double spacingCurvature(double radius, double curvature);

/** Exact step-over for scallop height h on a section of constant curvature.
 *
 *  From the triangle of centre of curvature, ball centre (rho + R) and ridge (rho + h):
 *  cos phi = ((rho+R)^2 + (rho+h)^2 - R^2) / (2 (rho+R)(rho+h)), step = 2 |rho| phi. Computed as
 *  step = 4/|kappa| asin(|kappa| q / 2) with q^2 = h (2R - h) / ((1 + kappa R)(1 + kappa h)), the same
 * without cancellation, which becomes the flat 2 sqrt(2Rh - h^2) at kappa = 0. In a bowl so close to
 * the ball that no ridge reaches h the step is the whole circle, 2 pi |rho|. \return nullopt if the ball
 * does not fit (cutterFits), R <= 0, h <= 0, h >= R, or a value is not finite. */
std::optional<double> stepOver(double radius, double curvature, double scallop_height);

/** Step-over to first order in h: sqrt(8 h / (1/R + kappa)). Same errors as stepOver. */
std::optional<double> stepOverFirstOrder(double radius, double curvature, double scallop_height);

/** Step-over as published: 2 sqrt(2 h R), flat and first order (Wu et al. 2025, equation 16). Too wide where
 * convex. \return nullopt if R <= 0, h <= 0, h >= R, or a value is not finite. */
std::optional<double> stepOverPublished(double radius, double scallop_height);

/** Scallop height that \p step along the surface leaves: the inverse of stepOver.
 *  \return nullopt if the ball does not fit, an argument is out of range (R <= 0, step < 0, not finite), or
 * the passes are so far apart that they leave the surface between them uncut. */
std::optional<double> scallopHeight(double radius, double curvature, double step);

/** Chord whose sagitta on a curve of \p curvature (either sign) is \p chord_error: 2 sqrt(2 rho e - e^2), at
 * most the diameter and at most \p max_step, which must be finite; 0 if e or max_step is not positive. */
double stepFromChordError(double curvature, double chord_error, double max_step);

/** As stepFromChordError, with the error on the curve of the ball's centre, radius rho + R, and the
 * chord measured at the contact. This is the error of a controller that moves the ball in straight lines. 0 also
 * if the ball does not fit. */
double stepFromChordErrorAtCentre(double radius, double curvature, double chord_error, double max_step);

} // namespace pcl_spiral
