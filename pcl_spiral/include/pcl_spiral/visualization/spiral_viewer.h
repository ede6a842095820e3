// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A toolpath on its scan, in a window.
 */
#pragma once

#include <pcl_spiral/visualization/verification_pictures.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

class vtkRenderWindowInteractor;

namespace pcl_spiral {

/** The views; each has its own key. */
enum class ViewerPage {
  Boundaries = 1, ///< the cloud with its loops, and the radial lines if the report has them
  Path,           ///< the spiral on the shaded surface
  Deviation,      ///< the path coloured by its deviation
  Stock,          ///< the scan coloured by the stock left
  Histogram       ///< of the ridge heights
};

class ViewerSession;

/** The views of the pictures in one window, to turn and zoom; the keys are listed on the screen.
 *
 *  A view from far away shows only as many turns as can be seen separately; a near
 *  view shows every turn. Points with values beyond the colour scale are drawn
 *  larger, over the others, at any distance. The drawn surface is thinned as in the
 *  pictures. A million points of the path and of the scan stay usable. Lengths in mm. */
class SpiralViewer {
public:
  /** Opens the window. A scene without deviations or without stock has only the other views.
   *  \throw std::runtime_error without a display, std::invalid_argument as VerificationPictures */
  explicit SpiralViewer(VerificationScene scene);
  ~SpiralViewer();

  /** The advice that a view without values shows to the user. */
  void setRemedy(const std::string& remedy);
  /** Saved views are STEM_1.png, STEM_2.png ...: the first name that does not exist. "view" by default. */
  void setPictureStem(const std::string& stem);
  /** Called repeatedly while run works; return true to end it. */
  void setCloseRequest(std::function<bool()> wanted);

  /** Handles keys and mouse until the user closes the window. */
  void run();

  ViewerPage getPage() const; ///< The view shown.
  /** The path point that the user chose. */
  std::optional<std::size_t> getChosenPoint() const;
  /** The message of the last key or click. */
  const std::string& getMessage() const;
  /** Handles keys and mouse; valid as long as the viewer. */
  vtkRenderWindowInteractor* getInteractor() const;

private:
  std::unique_ptr<ViewerSession> session_;
};

} // namespace pcl_spiral
