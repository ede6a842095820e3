// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Where a part is drawn: in a picture or in the viewer.
 */
#pragma once

#include "display_surface.h"
#include "sheet.h"

#include "box_axes.h"

#include <vtkActor.h>
#include <vtkRenderer.h>

namespace pcl_spiral {

/** A parallel view of a part, and what is put on it. */
class PartView {
public:
  explicit PartView(const DisplaySurface& surface) : surface_(surface) {}
  virtual ~PartView() = default;
  PartView(const PartView&) = delete;
  PartView& operator=(const PartView&) = delete;

  const DisplaySurface& surface() const { return surface_; }
  const ParallelView& projection() const { return projection_; }

  /** Where a place appears: pixels from the view's lower left corner. */
  Eigen::Vector2d onScreen(const Eigen::Vector3d& place) const;
  /** Whether a place is in the view or near it: what is not need not be drawn. */
  virtual bool isNear(const Eigen::Vector3d&) const { return true; }
  /** Draw as it stands. */
  virtual void add(vtkActor* actor) = 0;
  /** Draw what lies on the surface: nearer to the viewer by what the drawn surface may stand out. */
  virtual void addOver(vtkActor* actor) = 0;
  /** Draw over everything, what the part hides too. */
  virtual void addInFront(vtkActor* actor) = 0;
  /** A mark over everything: a ring where the part hides the place. Returns whether it does. */
  bool addMarker(const Eigen::Vector3d& place, const Color& color);
  /** A circle about a place, over everything. Returns whether the part hides the place. */
  bool addCircle(const Eigen::Vector3d& place, const Color& color = ink);

protected:
  virtual void addMarkAt(Marker marker, const Eigen::Vector3d& place, const Color& color) = 0;
  /** Look along the surface's mean normal tilted by 35 degrees; the part's box fills \p room about \p middle,
   * pixels. */
  void aim(const Eigen::Vector2d& room, const Eigen::Vector2d& middle);
  /** Axes with numbers in mm, clear of the part and of one another. */
  void drawAxes(vtkRenderer* view) const;

  const DisplaySurface& surface_;
  ParallelView projection_;
  Eigen::Vector2d origin_; ///< where the scene's origin appears, pixels
};

/** Light from over the viewer's left shoulder. */
void addLight(vtkRenderer* view);

} // namespace pcl_spiral
