// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A viewer's window, its content, and the effect of its keys and clicks. Private to visualization.
 */
#pragma once

#include "part_choosing.h"
#include "playback_page.h"
#include "player.h"
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
#include <memory>
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
  void setPlayback(PlaybackScene playback);
  /** Shows the playback after \p wall_seconds more of it. */
  void play(double wall_seconds);

  VerificationScene scene;
  DisplaySurface surface;
  ViewerWindow window;
  ViewerPages pages;
  ViewerChoice choice;
  bool keys_listed = true, closed = false;
  bool stale = false; ///< the page is for another distance of the camera
  std::string message, picture_stem = "view";
  std::function<bool()> close_wanted;
  FileCoordinates in_file = [](const Eigen::Vector3d& place) { return place; };
  std::function<std::string(const PartSelection&)> chosen = partInWords; ///< the message for a choice
  std::optional<Eigen::Vector3d> place;                                  ///< of the scan, chosen
  std::unique_ptr<Player> player;                                        ///< null: there is nothing to play
  std::unique_ptr<PlaybackPage> playback;                                ///< null: the key was not pressed
  vtkNew<ViewerStyle> style;
  vtkSmartPointer<vtkRenderWindowInteractor> interactor; ///< destroyed first: it uses all the others

private:
  void fill();
  void obey(ViewerCommand command);
  bool obeyPlayback(ViewerCommand command);
  bool openPlayback();
  void goTo(const PlacedValue& worst, const std::string& what);
  void goToDeviation();
  void goToStock(bool gouge);
  void toggleCutter();
  void step(int points);
  void stepTurn(double turns);
  void savePicture();
  void choosePlace(int x, int y);
  void beginLasso();
  void draw(int x, int y);
  void endLasso();
  void choose(std::size_t point);
  std::string pointInWords() const;
  std::string newFile(const std::string& kind) const;

  void slide(int x);
  void endSlide();

  bool slides_ = false;                ///< the bar of the playback is dragged
  std::vector<Eigen::Vector2d> lasso_; ///< pixels
};

} // namespace pcl_spiral
