// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_style.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <cstdlib>

namespace pcl_spiral {
namespace {

constexpr int still = 3; ///< pixels the mouse may move during a click

bool
isSideways(const std::string& key)
{
  return key == "Left" || key == "Right";
}

} // namespace

vtkStandardNewMacro(ViewerStyle);

void
ViewerStyle::OnKeyPress()
{
  const char* const key = Interactor->GetKeySym();
  if (key && pressed)
    pressed((Interactor->GetShiftKey() && isSideways(key) ? "shift " : "") + std::string(key));
}

void
ViewerStyle::OnMouseMove()
{
  if (drawing_)
    drawn(Interactor->GetEventPosition()[0], Interactor->GetEventPosition()[1]);
  else
    Superclass::OnMouseMove();
}

void
ViewerStyle::OnLeftButtonDown()
{
  down_x_ = Interactor->GetEventPosition()[0];
  down_y_ = Interactor->GetEventPosition()[1];
  drawing_ = lasso || (grabs && grabs(down_x_, down_y_));
  if (drawing_)
    drawn(down_x_, down_y_);
  else
    Superclass::OnLeftButtonDown();
}

void
ViewerStyle::OnLeftButtonUp()
{
  if (drawing_) {
    drawing_ = lasso = false;
    return closed();
  }
  Superclass::OnLeftButtonUp();
  const int x = Interactor->GetEventPosition()[0], y = Interactor->GetEventPosition()[1];
  if (std::abs(x - down_x_) < still && std::abs(y - down_y_) < still)
    clicked(x, y);
  else
    moved();
}

void
ViewerStyle::OnMiddleButtonUp()
{
  Superclass::OnMiddleButtonUp();
  moved();
}

void
ViewerStyle::OnRightButtonUp()
{
  Superclass::OnRightButtonUp();
  moved();
}

void
ViewerStyle::OnMouseWheelForward()
{
  Superclass::OnMouseWheelForward();
  zoomed();
}

void
ViewerStyle::OnMouseWheelBackward()
{
  Superclass::OnMouseWheelBackward();
  zoomed();
}

} // namespace pcl_spiral
