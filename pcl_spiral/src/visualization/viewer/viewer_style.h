// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Effect of keys and mouse in the viewer.
 */
#pragma once

#include <vtkInteractorStyleTrackballCamera.h>

#include <functional>
#include <string>

namespace pcl_spiral {

/** Rotates, moves and zooms like a trackball, and reports other events. VTK's own keys are off. */
class ViewerStyle : public vtkInteractorStyleTrackballCamera {
public:
  static ViewerStyle* New();
  vtkTypeMacro(ViewerStyle, vtkInteractorStyleTrackballCamera);

  std::function<void(const std::string& key)> pressed; ///< by the X name of the key
  std::function<void(int x, int y)> clicked;           ///< without a drag; pixels from the lower left corner
  std::function<void()> moved;                         ///< the camera has stopped
  std::function<void()> zoomed;                        ///< by the wheel; more events may follow at once
  std::function<void(int x, int y)> drawn;             ///< while the left button is down, if lasso is set
  std::function<void()> closed;                        ///< the left button is up again, and lasso is not set any more

  std::function<bool(int x, int y)> grabs; ///< whether a drag from there is drawn, too

  bool lasso = false; ///< the next drag with the left button draws and turns nothing

  void OnChar() override {}
  void OnKeyPress() override;
  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMiddleButtonUp() override;
  void OnRightButtonUp() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;

protected:
  ViewerStyle() = default;
  ~ViewerStyle() override = default;

private:
  int down_x_ = 0, down_y_ = 0;
  bool drawing_ = false;
};

} // namespace pcl_spiral
