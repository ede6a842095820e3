// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What keys and mouse do in the viewer.
 */
#pragma once

#include <vtkInteractorStyleTrackballCamera.h>

#include <functional>
#include <string>

namespace pcl_spiral {

/** Turns, moves and enlarges as a trackball does, and tells of the rest. VTK's own keys are off. */
class ViewerStyle : public vtkInteractorStyleTrackballCamera {
public:
  static ViewerStyle* New();
  vtkTypeMacro(ViewerStyle, vtkInteractorStyleTrackballCamera);

  std::function<void(const std::string& key)> pressed; ///< by X's name of the key
  std::function<void(int x, int y)> clicked;           ///< without a drag; pixels from the lower left corner
  std::function<void()> moved;                         ///< the camera has come to rest
  std::function<void()> zoomed;                        ///< by the wheel; more may follow at once

  void OnChar() override {}
  void OnKeyPress() override;
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
};

} // namespace pcl_spiral
