// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Random cases one after the other, each in a process of its own, so that a crash or a hang is an outcome like others.
 */
#pragma once

#include "cases.h"
#include "random_case.h"

#include <functional>
#include <string>

namespace pcl_spiral::acceptance {

/** What a case came to: nothing wrong, or the faults found. */
struct Outcome {
  std::string kind; ///< "path", or the reason of the refusal with its numbers left out
  std::string faults;
};

/** Numbers left out, so that refusals of one kind are counted together; the first clause alone. */
std::string reasonOf(const std::string& message);

/** What \p judge finds in a process of its own that may use the processor for \p longest seconds; kind "crash" or
 *  "hang" where it does not come back. No threads may run beside it. */
Outcome isolated(unsigned int longest, const std::function<Outcome()>& judge);

/** Judge the cases that \p options name; prints those with faults, and how many ended in what.
 *  \p longest: s of processor time; a case that takes longer hangs. Returns how many have faults. */
int judgeSeries(const std::string& name, const Options& options, unsigned int longest,
                const std::function<Outcome(const RandomCase&)>& judge);

} // namespace pcl_spiral::acceptance
