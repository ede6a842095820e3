// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The keys of the viewer, and the list of them on the screen.
 */
#pragma once

#include "visualization/sheet.h"

#include <optional>
#include <string>

namespace pcl_spiral {

/** What a key asks for. */
enum class ViewerCommand {
  ShowBoundaries,
  ShowPath,
  ShowDeviation,
  ShowStock,
  ShowHistogram,
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
  SavePicture,
  ToggleKeys,
  Close
};

/** The command of a key, by X's name for it; nothing for a key without one. */
std::optional<ViewerCommand> commandOf(const std::string& key);

/** List the keys in the column at the right, from \p below down; without \p all only the one that lists them.
 */
void addKeys(vtkRenderer* words, const PageSize& page, int below, bool all);

} // namespace pcl_spiral
