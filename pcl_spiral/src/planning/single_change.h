// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Single changes of an input that was refused. Private to planning.
 */
#pragma once

#include <pcl_spiral/planning/impl/spiral_planning.h>

#include <vector>

namespace pcl_spiral {

/** What a user does to change an input. */
struct ChangeWords {
  Diagnostic settings;   ///< as a face takes them: "{setMethod} radial"
  Diagnostic aside = {}; ///< what comes with them, and settings to leave out: "without {setHoleHandling}"
  int changes = 1;       ///< single ones

  Diagnostic all() const; ///< First the settings, so that they can be copied.
};

/** What \p first and \p second do one after the other: \p second alone, if it sets the only setting of \p first again. */
ChangeWords together(const ChangeWords& first, const ChangeWords& second);

/** One change of an input. */
struct SingleChange {
  ChangeWords words;
  PlanInput input;            ///< with the change
  bool keeps_surface = false; ///< the surface of the scan stays as it is
  bool named = false;         ///< the refusal names it
};

/** A refusal, and how far the path had come. */
struct Refused {
  Status status;
  bool late = false; ///< turns were made
};

/** Changes of \p input that may lead to a path where it is \p refused: what the refusal names, with the values and places that it tells;
 *  then what often helps where it does not say how. In both, those that cost little come first. */
std::vector<SingleChange> singleChanges(const PlanInput& input, const Refused& refused);

} // namespace pcl_spiral
