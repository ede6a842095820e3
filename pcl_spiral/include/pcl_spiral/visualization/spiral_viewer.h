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

/** The views, by the key that shows each. */
enum class ViewerPage {
  Boundaries = 1, ///< the cloud with its loops, and the radial lines where the report has them
  Path,           ///< the spiral on the shaded surface
  Deviation,      ///< the path coloured by its deviation
  Stock,          ///< the scan coloured by the stock left
  Histogram       ///< of the scallops
};

class ViewerSession;

/** The views of the pictures in one window, to be turned and enlarged; the keys are listed on the screen.
 *
 *  A view from afar shows as many turns as stand apart, a near one every turn. Points whose values lie beyond
 * the colours are drawn larger, over the others, from any distance. The drawn surface is thinned as in the
 * pictures; a million points of the path and of the scan stay usable. Lengths in mm.
 */
class SpiralViewer {
public:
  /** Opens the window. A scene without deviations or without stock has the other views alone.
   *  \throw std::runtime_error without a display, std::invalid_argument as VerificationPictures */
  explicit SpiralViewer(VerificationScene scene);
  ~SpiralViewer();

  /** What a view without values tells the user to do. */
  void setRemedy(const std::string& remedy);
  /** Saved views are STEM_1.png, STEM_2.png ...: the first that does not exist. "view" by default. */
  void setPictureStem(const std::string& stem);
  /** Asked again and again while run is at work; true ends it. */
  void setCloseRequest(std::function<bool()> wanted);

  /** Take keys and mouse until the user closes the window. */
  void run();

  ViewerPage getPage() const;
  /** The path point that the user has chosen. */
  std::optional<std::size_t> getChosenPoint() const;
  /** What the last key or click had to say. */
  const std::string& getMessage() const;
  /** Takes keys and mouse; valid as long as the viewer. */
  vtkRenderWindowInteractor* getInteractor() const;

private:
  std::unique_ptr<ViewerSession> session_;
};

} // namespace pcl_spiral
