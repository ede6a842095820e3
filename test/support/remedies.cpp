// SPDX-License-Identifier: BSD-3-Clause
#include "support/remedies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace pcl_spiral::test {
namespace {

/** The diagnostic of \p said whose id has \p words; null if there is none. */
const Diagnostic*
diagnosticOf(const Said& said, const std::string& words)
{
  const auto has = [&](const Diagnostic& diagnostic) { return diagnostic.id().find(words) != std::string::npos; };
  if (has(said.status.diagnostic()))
    return &said.status.diagnostic();
  const auto found = std::find_if(said.warnings.begin(), said.warnings.end(), has);
  return found == said.warnings.end() ? nullptr : &*found;
}

std::string
textOf(const Said& said)
{
  std::string text = said.status.message();
  for (const Diagnostic& warning : said.warnings)
    text += "\n    " + warning.text();
  return text;
}

/** Adds what is wrong with the trials of \p job to \p faults, and the settings named to \p named. */
void
tryEach(const RemediedJob& job, std::set<std::string>& named, std::vector<std::string>& faults)
{
  const Said first = job.run();
  const Diagnostic* const diagnostic = diagnosticOf(first, job.words);
  if (!diagnostic) {
    faults.push_back("\"" + job.words + "\" does not come, but: " + textOf(first));
    return;
  }
  const std::vector<std::string> settings = diagnostic->settings();
  named.insert(settings.begin(), settings.end());
  for (const Trial& trial : job.trials) {
    if (std::find(settings.begin(), settings.end(), trial.setting) == settings.end())
      faults.push_back(trial.setting + " is tried, but not named: " + diagnostic->text());
    const Said then = trial.run(*diagnostic);
    const bool as_meant = trial.refusal.empty()
                              ? then.status.ok()
                              : !then.status.ok() && then.status.diagnostic().id().find(trial.refusal) != std::string::npos;
    if (!as_meant || diagnosticOf(then, job.words))
      faults.push_back(trial.setting + " does not help:\n  " + diagnostic->text() + "\n  then: " + textOf(then));
  }
}

} // namespace

std::vector<std::string>
faultsOf(const std::vector<RemediedJob>& jobs)
{
  std::vector<std::string> faults;
  std::map<std::string, std::set<std::string>> named, tried; // of words
  for (const RemediedJob& job : jobs) {
    tryEach(job, named[job.words], faults);
    for (const Trial& trial : job.trials)
      tried[job.words].insert(trial.setting);
  }
  for (const auto& [words, settings] : named)
    for (const std::string& setting : settings)
      if (tried[words].count(setting) == 0)
        faults.push_back(setting + " is named, but not tried: " + words);
  return faults;
}

void
expectNoFaults(const std::vector<RemediedJob>& jobs)
{
  for (const std::string& fault : faultsOf(jobs))
    ADD_FAILURE() << fault;
}

} // namespace pcl_spiral::test
