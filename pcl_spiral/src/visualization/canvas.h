// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Makes a picture: camera, axes, text, and the PNG file.
 */
#pragma once

#include "actors.h"
#include "part_view.h"

namespace pcl_spiral {

/** An enlarged view of a place. */
struct Inset {
  vtkSmartPointer<vtkRenderer> view;
  ParallelView projection;
  Eigen::Vector2d origin; ///< position of the scene's origin, pixels from the lower left corner of the view

  Eigen::Vector2d onScreen(const Eigen::Vector3d& place) const { return origin + projection.project(place); }
};

/** A sheet whose main view shows the part. */
class Canvas : public Sheet, public PartView {
public:
  /** The main view shows the whole \p surface; text is right of it. \throw std::runtime_error without a
   * display */
  explicit Canvas(const DisplaySurface& surface);

  void add(vtkActor* actor) override;
  void addOver(vtkActor* actor) override;
  void addInFront(vtkActor* actor) override;
  void addAxes();
  /** An enlarged view, \p across mm wide and high, along \p normal; \p slot 0 is the upper of two. */
  Inset addInset(int slot, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double across);
  /** The same with \p up upwards; \p up is not along \p normal. */
  Inset addInset(int slot, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double across, const Eigen::Vector3d& up);

  static constexpr int inset_size = column_width;

private:
  /** Aims so that part and axes fit left of the words. Returns the middle of the part's room, pixels. */
  Eigen::Vector2d aimWithAxes();
  void addMarkAt(Marker marker, const Eigen::Vector3d& place, const Color& color) override;
};

} // namespace pcl_spiral
