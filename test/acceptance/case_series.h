// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Random cases in sequence, each in a separate process, so that a crash or a hang is an outcome like others.
 */
#pragma once

#include "cases.h"
#include "random_case.h"

#include <functional>
#include <string>

namespace pcl_spiral::acceptance {

/** The outcome of a case: the faults found, if any. */
struct Outcome {
  std::string kind; ///< "path", or the reason of the refusal without its numbers
  std::string faults;
};

/** The first clause without numbers, so that refusals of one kind are counted together. */
std::string reasonOf(const std::string& message);

/** The result of \p judge in a separate process with at most \p longest seconds of processor time; kind "crash" or
 *  "hang" if it does not return. No other threads may run. */
Outcome isolated(unsigned int longest, const std::function<Outcome()>& judge);

/** Judges the cases of \p options; prints those with faults, and the number of each outcome.
 *  \p longest: s of processor time; a case that takes longer hangs. Returns the number of cases with faults. */
int judgeSeries(const std::string& name, const Options& options, unsigned int longest,
                const std::function<Outcome(const RandomCase&)>& judge);

} // namespace pcl_spiral::acceptance
