// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the G, M and other words of G-code mean for the path.
 */
#pragma once

#include "program_words.h"

#include <pcl_spiral/io/program_writer.h>

#include <cstddef>
#include <optional>
#include <string>

namespace pcl_spiral {

/** Modal state of a control, as far as it concerns the path. */
struct GCodeModes {
  std::optional<bool> rapid; ///< G0 or G1; empty: none yet
  bool inverse_time = false;
  double unit = 1.0;         ///< mm
  bool tool_length = false;  ///< it is added to Z
  bool guides_tip = false;   ///< G43.4, G43.5, TRAORI, M428: the control keeps the tip in place
  std::string offset;        ///< the work offset; empty: none named yet
  bool vectors = false;      ///< G43.5: I J K are the tool axis
  bool spindle = false;      ///< M3 or M4
  bool ended = false;        ///< M2, M30
  bool of_machine = false;   ///< only in this line: G53, SUPA
  bool dwells = false;       ///< only in this line: G4
  bool takes_values = false; ///< only in this line: a code with P, Q or E
};

/** Takes a G code. \return why it is refused; empty if it was taken */
std::string takeG(Dialect dialect, double code, GCodeModes& modes);
/** The same for an M code. \p moved: whether the program has moved before. */
std::string takeM(Dialect dialect, double code, bool moved, GCodeModes& modes);
/** The same for a word without a number, such as TRAORI. */
std::string takeKeyword(Dialect dialect, const std::string& word, GCodeModes& modes);

} // namespace pcl_spiral
