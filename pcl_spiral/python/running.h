// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Runs of the library while other threads of Python go on.
 */
#pragma once

#include "errors.h"

#include <functional>
#include <memory>
#include <string>

namespace pcl_spiral::python {

/** One run of the library, in a thread of its own: the thread of the caller looks for signals meanwhile, so Ctrl-C comes through at once.
 *  The library then stops at its next step of progress, and nobody waits for it. */
class Run {
public:
  /** \p function: called with the share done and the name of the stage; it cancels by an answer that
   *  is false, but for None, or by an exception. None: none. */
  explicit Run(const py::object& function);

  ProgressCallback progress() const;

  /** Calls Python from the run. What is raised cancels the run, and comes through. */
  Status call(const std::function<void()>& python) const;

  /** Runs \p compute without the lock of the interpreter, then raises what stopped it. It must own what it uses. */
  void operator()(const std::function<void()>& compute) const;

private:
  struct State;
  std::shared_ptr<State> state_;
};

/** Cancels all runs and waits for them: before the interpreter ends. A signal, such as Ctrl-C, ends the process at once. */
void finishRuns();

/** In the child of a fork: the runs of the parent are not there. */
void forgetRuns();

} // namespace pcl_spiral::python
