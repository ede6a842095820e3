// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The viewer's window: the part, words at its right, axes and marks that follow it.
 */
#pragma once

#include "visualization/part_view.h"

#include <vtkNew.h>

#include <functional>

namespace pcl_spiral {

/** A window with a view of the part on the left and words in a column at the right. */
class ViewerWindow : public PartView {
public:
  /** \throw std::runtime_error without a display */
  ViewerWindow(const DisplaySurface& surface, const std::string& name);
  ~ViewerWindow() override;

  vtkRenderWindow* window() const { return window_; }
  const PageSize& page() const { return page_; }
  /** For words; it fills the window. */
  vtkRenderer* words() const { return words_; }
  /** Called before a frame of another size than the last. */
  void setResized(std::function<void()> resized) { resized_ = std::move(resized); }

  /** Take off everything. What is added again before the next frame stays in the graphics memory. */
  void clear();
  void add(vtkActor* actor) override;
  void addOver(vtkActor* actor) override;
  void addInFront(vtkActor* actor) override;
  /** \p layers times as near to the viewer as addOver. */
  void addOver(vtkActor* actor, int layers);
  /** Axes about the part, and a bar that tells the scale. */
  void addMeasures();

  /** Show the whole part, as the pictures do. */
  void reset();
  /** Show \p across mm about a place, along \p normal. */
  void lookAt(const Eigen::Vector3d& place, const Eigen::Vector3d& normal, double across);
  /** Within half a view beside it. */
  bool isNear(const Eigen::Vector3d& place) const override;
  void render();

private:
  /** What is drawn nearer to the viewer than it stands. */
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
  int viewWidth() const; ///< pixels
  double size() const;   ///< of the part, mm

  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkRenderer> view_, side_, overlay_, words_;
  PageSize page_;
  std::function<void()> resized_;
  std::vector<vtkSmartPointer<vtkActor>> actors_, before_; ///< before_: since clear no longer wanted
  std::vector<Lifted> lifted_;
  std::vector<Mark> marks_;
  bool measures_ = false;
  double whole_scale_ = 1.0; ///< mm a pixel, of the whole part
  unsigned long observer_ = 0;
};

} // namespace pcl_spiral
