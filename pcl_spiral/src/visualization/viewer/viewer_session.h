// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A viewer's window, its content, and the effect of its keys and clicks. Private to visualization.
 */
#pragma once

#include "viewer_keys.h"
#include "viewer_pages.h"
#include "viewer_style.h"
#include "viewer_window.h"
#include "visualization/display_surface.h"

#include <pcl_spiral/visualization/verification_pictures.h>

#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSmartPointer.h>

#include <cstddef>
#include <functional>
#include <string>

namespace pcl_spiral {

/** State and commands of one window. */
class ViewerSession {
public:
  explicit ViewerSession(VerificationScene scene);
  ~ViewerSession();
  ViewerSession(const ViewerSession&) = delete;
  ViewerSession& operator=(const ViewerSession&) = delete;

  void press(const std::string& key);
  void click(int x, int y);
  /** Fills the page again and draws it. */
  void show();
  void run();

  VerificationScene scene;
  DisplaySurface surface;
  ViewerWindow window;
  ViewerPages pages;
  ViewerChoice choice;
  bool keys_listed = true, closed = false;
  bool stale = false; ///< the page is for another distance of the camera
  std::string message, picture_stem = "view";
  std::function<bool()> close_wanted;
  vtkNew<ViewerStyle> style;
  vtkSmartPointer<vtkRenderWindowInteractor> interactor; ///< destroyed first: it uses all the others

private:
  void fill();
  void obey(ViewerCommand command);
  void goTo(const PlacedValue& worst, const std::string& what);
  void goToDeviation();
  void goToStock(bool gouge);
  void toggleCutter();
  void step(int points);
  void stepTurn(double turns);
  void savePicture();
  void choose(std::size_t point);
  std::string pointInWords() const;
};

} // namespace pcl_spiral
