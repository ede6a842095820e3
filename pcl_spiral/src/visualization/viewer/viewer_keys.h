// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The keys of the viewer, and the list of them on the screen.
 */
#pragma once

#include "visualization/sheet.h"

#include <optional>
#include <string>

namespace pcl_spiral {

/** The command of a key. */
enum class ViewerCommand {
  ShowBoundaries,
  ShowPath,
  ShowDeviation,
  ShowStock,
  ShowHistogram,
  ShowPlayback,
  Play,
  Faster,
  Slower,
  ByLength,
  NextSlow,
  NextWarning,
  NextExtreme,
  ShowMachine,
  ToggleTurns,
  GoToDeviation,
  GoToScallop,
  GoToGouge,
  ToggleCutter,
  NextPoint,
  LastPoint,
  NextTurn,
  LastTurn,
  ShowWhole,
  LookDown,
  ChoosePlace,
  DrawLasso,
  SavePicture,
  ToggleKeys,
  Close
};

/** The command of a key, by the X name of the key; nothing for other keys. */
std::optional<ViewerCommand> commandOf(const std::string& key);

/** Whether a command shows or chooses something of a path. */
bool needsPath(ViewerCommand command);

/** The keys that are listed. */
enum class KeyList { None, Views, Playback };

/** Lists the keys in the right column, from \p below down; None: only the key of the list. */
void addKeys(vtkRenderer* words, const PageSize& page, int below, KeyList list);

} // namespace pcl_spiral
