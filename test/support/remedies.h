// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Jobs that are refused or warned of, with a trial of each remedy that the message names.
 */
#pragma once

#include <pcl_spiral/common/status.h>

#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl_spiral::test {

/** What a job has to say. */
struct Said {
  Status status;
  Diagnostics warnings;
};

/** The job with one remedy applied. */
struct Trial {
  std::string setting;                        ///< as the diagnostic names it
  std::function<Said(const Diagnostic&)> run; ///< the job with the change, by what the diagnostic says
  std::string refusal; ///< words of another refusal that is meant to come, as when a setting asks for one; empty: the job succeeds
};

/** A job about which a diagnostic is given that names settings as remedies. */
struct RemediedJob {
  std::string words; ///< in the diagnostic's id, and in no other one of the job
  std::function<Said()> run;
  std::vector<Trial> trials;
};

/** What is wrong: the diagnostic does not come; it names a setting that no job with these words tries; a trial is of none that it names;
 *  after a trial it comes again, or the job is refused for something else. Remedies for different causes need a job for each. */
std::vector<std::string> faultsOf(const std::vector<RemediedJob>& jobs);

/** The test fails with each of them. */
void expectNoFaults(const std::vector<RemediedJob>& jobs);

/** A change of a job: any function of the planner, and of the diagnostic if it says how much. */
template <typename Planner>
class Change {
public:
  Change() = default; ///< None.
  template <typename Function>
  Change(Function change)
  {
    if constexpr (std::is_invocable_v<Function, Planner&, const Diagnostic&>)
      change_ = std::move(change);
    else
      change_ = [change = std::move(change)](Planner& planner, const Diagnostic&) { change(planner); };
  }
  void operator()(Planner& planner, const Diagnostic& said = {}) const
  {
    if (change_)
      change_(planner, said);
  }

private:
  std::function<void(Planner&, const Diagnostic&)> change_;
};

/** A change, named as the setting in the diagnostic. */
template <typename Planner>
struct Remedy {
  const char* setting;
  Change<Planner> change;
  const char* refusal = "";
};

/** The job that \p prepare makes of a new \p Planner. \p say runs it. */
template <typename Planner>
RemediedJob
remediedJob(const char* words, Said (*say)(Planner&), const Change<Planner>& prepare, const std::vector<Remedy<Planner>>& remedies)
{
  const auto runWith = [=](const Change<Planner>& change, const Diagnostic& said) {
    Planner planner;
    planner.setQuiet(true);
    prepare(planner);
    change(planner, said);
    return say(planner);
  };
  RemediedJob job{words, [=] { return runWith({}, {}); }, {}};
  for (const Remedy<Planner>& remedy : remedies)
    job.trials.push_back({remedy.setting, [=](const Diagnostic& said) { return runWith(remedy.change, said); }, remedy.refusal});
  return job;
}

} // namespace pcl_spiral::test
