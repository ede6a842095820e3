// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Runs of the library while other threads of Python go on.
 */
#pragma once

#include "errors.h"

#include <chrono>
#include <optional>
#include <string>

namespace pcl_spiral::python {

/** Progress of one call: the user's function, and signals such as that of Ctrl-C, which both can cancel. */
class Progress {
public:
  /** \p function: called with the share done and the name of the stage; it cancels by False, or by an exception. None: none. */
  explicit Progress(const py::object& function) : function_(function)
  {
    if (!function.is_none() && PyCallable_Check(function.ptr()) == 0)
      raiseType("progress= must be a function of the share done and the name of the stage, such as progress=print");
  }

  ProgressCallback callback()
  {
    return [this](double share, const std::string& stage) { return goesOn(share, stage); };
  }

  /** Runs \p compute without the lock of the interpreter, then raises what stopped it. */
  template <typename Compute>
  void run(Compute compute)
  {
    {
      const py::gil_scoped_release release;
      compute();
    }
    if (raised_)
      throw *raised_;
  }

private:
  bool goesOn(double share, const std::string& stage)
  {
    const auto now = std::chrono::steady_clock::now();
    if (raised_ || (function_.is_none() && now - looked_ < std::chrono::milliseconds(20)))
      return !raised_;
    looked_ = now;
    const py::gil_scoped_acquire acquire;
    try {
      if (PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      if (!function_.is_none()) {
        const py::object answer = function_(share, stage);
        return !(py::isinstance<py::bool_>(answer) && !answer.cast<bool>());
      }
    }
    catch (const py::error_already_set& error) {
      raised_ = error;
    }
    return !raised_;
  }

  py::object function_;
  std::chrono::steady_clock::time_point looked_;
  std::optional<py::error_already_set> raised_;
};

} // namespace pcl_spiral::python
