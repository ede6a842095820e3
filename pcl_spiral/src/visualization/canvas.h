/** \file
 *  A picture in the making: camera, axes, words, and the PNG at the end.
 */
#pragma once

#include "display_surface.h"
#include "sheet.h"

#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/visualization/box_axes.h>

#include <vtkActor.h>
#include <vtkRenderer.h>

#include <vector>

namespace pcl_spiral {

constexpr Color surface_color{0.80, 0.83, 0.87};

/** An enlarged view of a place. */
struct Inset {
  vtkSmartPointer<vtkRenderer> view;
  ParallelView projection;
  Eigen::Vector2d origin; ///< where the scene's origin appears, pixels from the view's lower left corner

  Eigen::Vector2d
  onScreen(const Eigen::Vector3d& place) const
  {
    return origin + projection.project(place);
  }
};

/** A sheet whose main view is of the part. */
class Canvas : public Sheet {
public:
  /** The main view shows the whole of \p surface, along its mean normal tilted by 35 degrees; words go right
   * of it. \throw std::runtime_error without a display */
  explicit Canvas(const DisplaySurface& surface);

  const ParallelView&
  projection() const
  {
    return projection_;
  }

  /** Where a place appears: pixels from the lower left corner. */
  Eigen::Vector2d onScreen(const Eigen::Vector3d& place) const;
  /** Draw what lies on the surface: nearer to the viewer by what the drawn surface may stand out. */
  void addOver(vtkActor* actor);
  /** Draw over everything, what the part hides too. */
  void addInFront(vtkActor* actor);
  /** A mark over everything: a ring where the part hides the place. Returns whether it does. */
  bool addMarker(const Eigen::Vector3d& place, const Color& color);
  /** A circle about a place, over everything. Returns whether the part hides the place. */
  bool addCircle(const Eigen::Vector3d& place);
  /** Axes with numbers in mm, clear of the part and of one another. */
  void addAxes();
  /** An enlarged view, \p across mm wide and high, along \p normal; the \p slot'th from the top of two. */
  Inset addInset(int slot, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal, double across);

  static constexpr int inset_size = column_width;

private:
  void aim();
  const DisplaySurface& surface_;
  ParallelView projection_;
  Eigen::Vector2d origin_; ///< where the scene's origin appears, pixels
};

/** The surface in one colour, lit from the viewer's side. */
vtkSmartPointer<vtkActor> surfaceActor(vtkPolyData* surface, const Color& color);

/** Lines in one colour, drawn over the surface they lie on. */
vtkSmartPointer<vtkActor> lineActor(const std::vector<Polyline>& lines, bool closed, const Color& color,
                                    float width);

/** From dark blue through green to yellow. */
vtkSmartPointer<vtkScalarsToColors> colorScale(double low, double high);

/** From blue, at minus \p reach, through pale yellow to red. */
vtkSmartPointer<vtkScalarsToColors> divergingScale(double reach);

} // namespace pcl_spiral
