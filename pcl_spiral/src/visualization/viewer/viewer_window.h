// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The window of the viewer: the part, text on the right, axes and marks that follow the part.
 */
#pragma once

#include "visualization/part_view.h"

#include <vtkNew.h>

#include <functional>

namespace pcl_spiral {

/** A window with a view of the part on the left and a text column on the right. */
class ViewerWindow : public PartView {
public:
  /** \throw std::runtime_error without a display */
  ViewerWindow(const DisplaySurface& surface, const std::string& name);
  ~ViewerWindow() override;

  vtkRenderWindow* window() const { return window_; }
  const PageSize& page() const { return page_; }
  /** The layer for text; it fills the window. */
  vtkRenderer* words() const { return words_; }
  /** Called before a frame with another size than the last frame. */
  void setResized(std::function<void()> resized) { resized_ = std::move(resized); }

  /** Removes everything. Objects added again before the next frame stay in the graphics memory. */
  void clear();
  void add(vtkActor* actor) override;
  void addOver(vtkActor* actor) override;
  void addInFront(vtkActor* actor) override;
  /** \p layers times nearer to the viewer than addOver. */
  void addOver(vtkActor* actor, int layers);
  /** Axes round the part, and a scale bar. */
  void addMeasures();

  /** Shows the whole part, as in the pictures. */
  void reset();
  /** Shows \p across mm round a place, along \p normal. */
  void lookAt(const Eigen::Vector3d& place, const Eigen::Vector3d& normal, double across);
  /** Shows the whole part along z, from above. */
  void lookDown();
  /** Shows \p times as much to each side. */
  void widen(double times);
  /** The place at \p pixel in the plane through the middle of the part that faces the viewer. */
  Eigen::Vector3d placeAt(const Eigen::Vector2d& pixel) const;
  /** A closed line over everything, pixels; empty: none. It stays until it is set again. */
  void setLasso(const std::vector<Eigen::Vector2d>& corners) { lasso_ = corners; }
  /** Whether a place is in the view or within half a view beside it. */
  bool isNear(const Eigen::Vector3d& place) const override;
  void render();

private:
  /** Objects drawn nearer to the viewer than their true place. */
  struct Lifted {
    vtkActor* actor;
    double by; ///< mm
  };
  struct Mark {
    Marker marker;
    Eigen::Vector3d place;
    Color color;
  };
  void addMarkAt(Marker marker, const Eigen::Vector3d& place, const Color& color) override;
  void fitToWindow();
  void readCamera();
  void beforeFrame();
  void drawScale();
  void drawLasso();
  int viewWidth() const; ///< pixels
  double size() const;   ///< of the part, mm

  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> view_, side_, overlay_, words_;
  PageSize page_;
  std::function<void()> resized_;
  std::vector<vtkSmartPointer<vtkActor>> actors_, before_; ///< before_: removed by clear
  std::vector<Lifted> lifted_;
  std::vector<Mark> marks_;
  std::vector<Eigen::Vector2d> lasso_;
  bool measures_ = false;
  double whole_scale_ = 1.0; ///< mm a pixel, of the whole part
  unsigned long observer_ = 0;
};

} // namespace pcl_spiral
