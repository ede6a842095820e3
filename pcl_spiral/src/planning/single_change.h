// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Single changes of an input that was refused. Private to planning.
 */
#pragma once

#include <pcl_spiral/planning/impl/spiral_planning.h>

#include <vector>

namespace pcl_spiral {

/** One change of an input. */
struct SingleChange {
  Diagnostic words;           ///< as a user gives it: "{setMethod} radial"
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
