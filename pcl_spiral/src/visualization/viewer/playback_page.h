// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a playback draws: the tool, the stock, the bar of the time, and what the machine does.
 */
#pragma once

#include "machine_actors.h"
#include "player.h"
#include "stock_patches.h"
#include "viewer_window.h"

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkTextActor.h>

#include <memory>
#include <optional>
#include <string>

namespace pcl_spiral {

/** Draws the moment of a player. */
class PlaybackPage {
public:
  PlaybackPage(Player& player, const VerificationScene& scene, ViewerWindow& window);

  /** Puts all of it on the window. Returns the lower end of the right column, pixels. */
  int fill();
  /** Moves and colours what has changed since; the window is not rendered. */
  void update();
  /** Shows the machine, with the part on its table, or the part alone, which then stands. */
  void toggleMachine() { shows_machine_ = !shows_machine_; }
  bool showsMachine() const { return shows_machine_; }
  /** Whether a pixel is on the bar. */
  bool isOnBar(int x, int y) const;
  /** The share of the whole at a pixel on the bar. */
  double shareAt(int x) const;
  /** The lines of text. */
  const std::string& place() const { return place_; }
  const std::string& motion() const { return motion_; }

private:
  void start();
  void place(const MotionFrame& frame);
  void writeWords(const MotionFrame& frame);
  int barLength() const;

  Player& player_;
  const VerificationScene& scene_;
  ViewerWindow& window_;
  StockScale scale_;
  std::unique_ptr<StockPatches> patches_;
  std::unique_ptr<MachineActors> machine_;
  vtkSmartPointer<vtkActor> tool_;
  vtkNew<vtkTextActor> first_, second_;
  vtkSmartPointer<vtkActor2D> knob_;
  std::string place_, motion_;
  bool shows_machine_ = false;
  bool fallen_ = false; ///< the stock is known
};

} // namespace pcl_spiral
