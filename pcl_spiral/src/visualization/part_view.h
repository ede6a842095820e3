// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A view that shows a part: in a picture or in the viewer.
 */
#pragma once

#include "display_surface.h"
#include "sheet.h"

#include "box_axes.h"

#include <vtkActor.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>

namespace pcl_spiral {

/** A parallel view of a part and the drawings on it. */
class PartView {
public:
  explicit PartView(const DisplaySurface& surface) : surface_(surface) {}
  virtual ~PartView() = default;
  PartView(const PartView&) = delete;
  PartView& operator=(const PartView&) = delete;

  const DisplaySurface& surface() const { return surface_; }
  const ParallelView& projection() const { return projection_; }

  /** Position of a place: pixels from the lower left corner of the view. */
  Eigen::Vector2d onScreen(const Eigen::Vector3d& place) const;
  /** Whether a place is in the view or near it; other places need not be drawn. */
  virtual bool isNear(const Eigen::Vector3d&) const { return true; }
  /** Draws without a change. */
  virtual void add(vtkActor* actor) = 0;
  /** Draws something on the surface: nearer to the viewer by the error of the drawn surface. */
  virtual void addOver(vtkActor* actor) = 0;
  /** Draws over everything, also what the part hides. */
  virtual void addInFront(vtkActor* actor) = 0;
  /** A mark over everything: a ring if the part hides the place. Returns whether the part hides it. */
  bool addMarker(const Eigen::Vector3d& place, const Color& color);
  /** A circle round a place, over everything. Returns whether the part hides the place. */
  bool addCircle(const Eigen::Vector3d& place, const Color& color = ink);

protected:
  virtual void addMarkAt(Marker marker, const Eigen::Vector3d& place, const Color& color) = 0;
  /** Looks along the mean normal of the surface, tilted by 35 degrees; the part's box fills \p room round \p middle,
   * pixels. */
  void aim(const Eigen::Vector2d& room, const Eigen::Vector2d& middle);
  /** What the axes' words take up; pixels. */
  Eigen::AlignedBox2d axisWords() const;
  /** Axes with numbers in mm, without overlap with the part and each other. */
  void drawAxes(vtkRenderer* view) const;

  const DisplaySurface& surface_;
  ParallelView projection_;
  Eigen::Vector2d origin_; ///< position of the scene's origin, pixels
};

/** Light from above and behind the viewer, from the left. */
void addLight(vtkRenderer* view);

} // namespace pcl_spiral
