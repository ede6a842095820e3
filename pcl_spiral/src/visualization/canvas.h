// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A picture in the making: camera, axes, words, and the PNG at the end.
 */
#pragma once

#include "actors.h"
#include "part_view.h"

namespace pcl_spiral {

/** An enlarged view of a place. */
struct Inset {
  vtkSmartPointer<vtkRenderer> view;
  ParallelView projection;
  Eigen::Vector2d origin; ///< where the scene's origin appears, pixels from the view's lower left corner

  Eigen::Vector2d onScreen(const Eigen::Vector3d& place) const { return origin + projection.project(place); }
};

/** A sheet whose main view is of the part. */
class Canvas : public Sheet, public PartView {
public:
  /** The main view shows the whole of \p surface; words go right of it. \throw std::runtime_error without a
   * display */
  explicit Canvas(const DisplaySurface& surface);

  void add(vtkActor* actor) override;
  void addOver(vtkActor* actor) override;
  void addInFront(vtkActor* actor) override;
  void addAxes();
  /** An enlarged view, \p across mm wide and high, along \p normal; the \p slot'th from the top of two. */
  Inset addInset(int slot, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double across);
  /** The same with \p up upwards, which is not along \p normal. */
  Inset addInset(int slot, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double across, const Eigen::Vector3d& up);

  static constexpr int inset_size = column_width;

private:
  void addMarkAt(Marker marker, const Eigen::Vector3d& place, const Color& color) override;
};

} // namespace pcl_spiral
