// SPDX-License-Identifier: BSD-3-Clause
#include "running.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <thread>

namespace pcl_spiral::python {
namespace {

std::mutex mutex; ///< of all below, and of State::done
std::condition_variable ended;
int running = 0;
std::atomic<bool> is_ending{false}; ///< the interpreter is

} // namespace

/** What both threads see. The objects of Python belong to who has the lock of the interpreter; a run that nobody waits for has none. */
struct Run::State {
  py::object function;
  std::optional<py::error_already_set> raised;
  std::exception_ptr failed;
  std::atomic<bool> stop{false};
  bool done = false;

  /** Calls Python unless the run is to stop. Whether it goes on. */
  template <typename Python>
  bool call(Python python)
  {
    if (stop || is_ending)
      return false;
    const py::gil_scoped_acquire acquire;
    if (stop || is_ending)
      return false;
    try {
      try {
        python();
      }
      catch (const py::builtin_exception& error) {
        error.set_error();
        throw py::error_already_set();
      }
    }
    catch (const py::error_already_set& error) {
      if (!stop)
        raised = error;
      stop = true;
    }
    return !stop;
  }

  bool goesOn(double share, const std::string& stage)
  {
    if (!function)
      return !stop && !is_ending;
    return call([&] {
      const py::object called = function, answer = called(share, stage);
      const int is_true = answer.is_none() ? 1 : PyObject_IsTrue(answer.ptr());
      if (is_true < 0)
        throw py::error_already_set();
      stop = stop || is_true == 0;
    });
  }

  /** Waits a little; true if the run has ended. */
  bool wait()
  {
    const py::gil_scoped_release release;
    std::unique_lock<std::mutex> lock(mutex);
    const bool is_done = ended.wait_for(lock, std::chrono::milliseconds(20), [this] { return done; });
    lock.unlock();
    while (is_ending) // a daemon thread, which must not ask for the lock of the interpreter any more
      std::this_thread::sleep_for(std::chrono::hours(1));
    return is_done;
  }
};

Run::Run(const py::object& function) : state_(std::make_shared<State>())
{
  if (!function.is_none() && PyCallable_Check(function.ptr()) == 0)
    raiseType("progress= must be a function of the share done and the name of the stage, such as progress=print");
  if (!function.is_none())
    state_->function = function;
}

ProgressCallback
Run::progress() const
{
  return [state = state_](double share, const std::string& stage) { return state->goesOn(share, stage); };
}

Status
Run::call(const std::function<void()>& python) const
{
  return state_->call(python) ? Status::success() : Status(StatusCode::Cancelled, "cancelled");
}

void
Run::operator()(const std::function<void()>& compute) const
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    ++running;
  }
  std::thread([state = state_, work = compute]() mutable {
    try {
      work();
    }
    catch (...) {
      state->failed = std::current_exception();
    }
    work = nullptr; // what nobody waits for is freed before the end is told
    const std::lock_guard<std::mutex> lock(mutex);
    state->done = true;
    --running;
    ended.notify_all();
  }).detach();
  bool is_signalled = false;
  while (!is_signalled && !state_->wait())
    is_signalled = PyErr_CheckSignals() != 0;
  state_->stop = true;
  state_->function = py::object();
  std::optional<py::error_already_set> raised = std::move(state_->raised);
  state_->raised.reset();
  if (is_signalled)
    throw py::error_already_set();
  if (state_->failed)
    std::rethrow_exception(state_->failed);
  if (raised)
    throw py::error_already_set(*raised);
}

void
finishRuns()
{
  is_ending = true;
  const auto areDone = [] {
    const py::gil_scoped_release release;
    std::unique_lock<std::mutex> lock(mutex);
    return ended.wait_for(lock, std::chrono::milliseconds(20), [] { return running == 0; });
  };
  while (!areDone())
    if (PyErr_CheckSignals() != 0)
      std::_Exit(130); // as a shell names an interrupted process
}

void
forgetRuns()
{
  new (&mutex) std::mutex; // a thread that is not here may hold the old ones
  new (&ended) std::condition_variable;
  running = 0;
}

} // namespace pcl_spiral::python
