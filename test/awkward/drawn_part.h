// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Random parts and bodies of awkward scenes.
 */
#pragma once

#include "scene.h"

namespace pcl_spiral::awkward {

/** A gently curved part of 60 to 120 mm, times \p size, with a simple outline, in the x-y plane of its frame. */
test::SurfacePtr drawnPart(test::Random& random, double size);

/** The same of \p length, mm. */
test::SurfacePtr drawnPartOf(double length, test::Random& random);

/** Sets the part, the cutter and a clean scan of it. */
void drawScan(Scene& scene, test::SurfacePtr part, test::Random& random);

/** A random turn about z, and a shift of up to \p reach. */
Eigen::Isometry3d levelMotion(test::Random& random, double reach);

/** A place of the part at least \p margin from its rim. */
Eigen::Vector3d innerPlace(const test::AnalyticSurface& part, double margin, test::Random& random);

/** A box that stands upright: its top is seen, and hides what is below. */
struct Box {
  Eigen::Vector2d centre;
  double half_x = 5.0, half_y = 5.0, turn = 0.0; ///< turn: radians
  double bottom = 0.0, top = 10.0;               ///< z

  /** Whether \p p is inside the outline widened by \p margin. */
  bool covers(const Eigen::Vector2d& p, double margin = 0.0) const;
  /** Corners of the outline widened by \p margin, counter-clockwise. */
  test::PlaneLoop outline(double margin = 0.0) const;
};

/** Whether the box is outside the part by more than \p margin. */
bool isClear(const test::AnalyticSurface& part, const Box& box, double margin);

/** Whether two boxes, however they are turned, may overlap. */
bool overlap(const Box& a, const Box& b);

/** Adds the box: its top to the scan, its faces to the bodies; removes what it hides from the scan. */
void addBox(Scene& scene, const Box& box);

/** Adds a table at the height \p z, \p margin wider than the part, seen where the part does not hide it. */
void addTable(Scene& scene, double z, double margin);

} // namespace pcl_spiral::awkward
