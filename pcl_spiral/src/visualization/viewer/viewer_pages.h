// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Content of each view of the viewer.
 */
#pragma once

#include "viewer_window.h"
#include "visualization/value_style.h"

#include "visualization/shown_turns.h"
#include <pcl_spiral/visualization/spiral_viewer.h>

#include <optional>

namespace pcl_spiral {

/** The user's choices. */
struct ViewerChoice {
  ViewerPage page = ViewerPage::Boundaries;
  bool every_turn = false;          ///< otherwise only turns that appear apart
  bool cutter = false;              ///< at the chosen point
  std::optional<std::size_t> point; ///< of the path
};

/** Puts the views of one scene on a window. */
class ViewerPages {
public:
  ViewerPages(const VerificationScene& scene, ViewerWindow& window);

  void setRemedy(const std::string& remedy) { remedy_ = remedy; }
  const std::string& remedy() const { return remedy_; }
  /** Replaces the content of the window. Returns the lower end of the right column, pixels. */
  int fill(const ViewerChoice& choice);
  /** The turns that a page shows for the position of the camera. */
  ShownTurns turns(const ViewerChoice& choice) const;
  /** Width of a view of one place, mm. */
  double nearWidth() const { return near_width_; }

private:
  int boundaries();
  int path(const ViewerChoice& choice);
  int deviation(const ViewerChoice& choice);
  int stock();
  void addStockPoints(const ValueStyle& style);
  int histogram();
  int absent(const std::string& what);
  void addChosen(const ViewerChoice& choice);
  /** Title, colour bar and legend. */
  int addWords(const Title& title, const std::string& bar, vtkScalarsToColors* colors, const std::vector<LegendEntry>& legend);

  const VerificationScene& scene_;
  ViewerWindow& window_;
  double near_width_, disc_radius_; ///< mm
  std::string remedy_;
  std::vector<float> heights_; ///< of stock, one per reference point
  std::vector<vtkSmartPointer<vtkActor>> stock_outstanding_, deviation_outstanding_;
};

} // namespace pcl_spiral
