// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A toolpath on its scan, in a window.
 */
#pragma once

#include <pcl_spiral/core/control_model.h>
#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/core/polyline.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/machine/program_file.h>
#include <pcl_spiral/verify/stock_mesh.h>
#include <pcl_spiral/visualization/verification_pictures.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkRenderWindowInteractor;

namespace pcl_spiral {

/** The views; each has its own key. */
enum class ViewerPage {
  Boundaries = 1, ///< the cloud with its loops, and the radial lines if the report has them
  Path,           ///< the spiral on the shaded surface
  Deviation,      ///< the path coloured by its deviation
  Stock,          ///< the scan coloured by the stock left
  Histogram,      ///< of the ridge heights
  Playback        ///< the tool along the path in time, and the stock that falls
};

/** A place of a playback that a warning is about. */
struct PlaybackStop {
  std::string words;                ///< of the warning
  std::size_t point = 0;            ///< of the path
  std::optional<std::size_t> block; ///< of the program, in place of the point
};

/** What a viewer plays, beside its VerificationScene. Lengths in mm. */
struct PlaybackScene {
  CutterShape cutter;                          ///< of the path
  std::vector<ToolSegment> holder;             ///< shank and holder above it, from the flank upwards; empty: a shank as wide as the cutter
  Polyline tips;                               ///< one for each point of the path; empty: from the contacts
  std::optional<ProgramFile> program;          ///< that was judged; absent: one of the machine is made of the path
  std::vector<std::size_t> lines;              ///< ProgramFileReport::lines, if there is a program
  Machine machine;                             ///< for a path
  double feed = 1000.0;                        ///< of a path, mm/min
  ControlKind control = ControlKind::LinuxCNC; ///< whose times are shown
  StockMesh left;                              ///< stockMesh of what the whole path leaves
  std::vector<PlaybackStop> stops;             ///< the key w goes from one to the next
};

/** What the user chose of the scan. */
struct PartSelection {
  std::string place;      ///< X,Y,Z in the coordinates of the file; empty: a polygon was drawn
  std::string file;       ///< of the polygon, for readPolygon
  std::size_t points = 0; ///< of the scan, inside the polygon
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
  /** Opens the window. A scene without deviations or without stock has only the other views; one with an empty path has only the scan.
   *  \throw std::runtime_error without a display, std::invalid_argument as VerificationPictures */
  explicit SpiralViewer(VerificationScene scene);
  ~SpiralViewer();

  /** The advice that a view without values, and the playback without a scene of it, shows to the user. */
  void setRemedy(const std::string& remedy);
  /** Saved views are STEM_1.png, STEM_2.png ..., and polygons STEM_lasso_1.txt ...: the first name that does not exist. "view" by
   *  default. */
  void setPictureStem(const std::string& stem);
  /** Turns a place of the scene into the coordinates of the file of the scan, for chosen places and polygons; without it they are those
   *  of the scene. */
  void setFileCoordinates(std::function<Eigen::Vector3d(const Eigen::Vector3d&)> in_file);
  /** Called with each choice of a part; returns the message that the window shows for it. */
  void setChoiceCallback(std::function<std::string(const PartSelection&)> chosen);
  /** What the space key plays; without it there is nothing to play. The times are computed with the first key, the stock beside the
   *  window. */
  void setPlayback(PlaybackScene playback);
  /** Called repeatedly while run works; return true to end it. */
  void setCloseRequest(std::function<bool()> wanted);

  /** Handles keys and mouse until the user closes the window. */
  void run();

  ViewerPage getPage() const; ///< The view shown.
  /** The path point that the user chose. */
  std::optional<std::size_t> getChosenPoint() const;
  /** The place of the scan that the user chose. */
  std::optional<Eigen::Vector3d> getChosenPlace() const;
  /** The message of the last key or click. */
  const std::string& getMessage() const;
  /** Handles keys and mouse; valid as long as the viewer. */
  vtkRenderWindowInteractor* getInteractor() const;

private:
  std::unique_ptr<ViewerSession> session_;
};

} // namespace pcl_spiral
