// SPDX-License-Identifier: BSD-3-Clause
#include "planning.h"
#include "joined_regions.h"
#include "single_run.h"
#include "way_check.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>

#include <exception>

using namespace pcl_spiral;

namespace {

/** The path over the region without \p strips; absent if there is none, or if no point is left. Adds to \p late if it failed late. */
std::optional<Result>
tried(const Job& job, const StripChoice& strips, ProgressBar& bar, const Result& input, int& late)
{
  try {
    return planned(job, strips, bar, input);
  }
  catch (const NoPath& refusal) {
    late += refusal.late ? 1 : 0;
  }
  catch (const FileError&) {
    ++late; // the path that was found enters something
  }
  catch (const UsageError&) { // no point is left
  }
  return std::nullopt;
}

/** Cuts as many of the strips that \p result leaves uncut as can be. */
Result
withStrips(const Job& job, StripChoice strips, ProgressBar& bar, const Result& input, Result result)
{
  const std::size_t found = result.part.strips.size();
  int late = 0;
  for (std::size_t i = 0; i < found && result.part.strips.size() > 1; ++i) {
    strips.cut.push_back(i);
    if (std::optional<Result> with = tried(job, strips, bar, input, late))
      result = std::move(*with);
    else
      strips.cut.pop_back();
  }
  return result;
}

/** The path over the whole region. If there is none, or if it crosses a keep-out, the narrowest strips beside keep-outs are left out,
 *  and no more of them than must be. A try that fails soon costs a third of a path or less, so all of these are made. */
Result
plannedWithLeastUncut(const Job& job, ProgressBar& bar, const Result& input)
{
  constexpr int most_late = 2; // runs, so that a refusal takes about twice as long as a path
  std::exception_ptr first;
  int late = 0;
  try {
    return planned(job, {}, bar, input);
  }
  catch (const NoPath& refusal) {
    if (job.part.keep_outs.empty())
      throw;
    first = std::current_exception();
    late = refusal.late ? 1 : 0;
  }
  catch (const EntersKeepOut& entry) {
    if (!entry.crosses())
      throw;
    first = std::current_exception();
  }
  Surface::ConstPtr surface;
  for (StripChoice strips{2.0, {}, &surface}; strips.width <= 5.0 && late < most_late; strips.width += 1.0)
    if (std::optional<Result> result = tried(job, strips, bar, input, late))
      return withStrips(job, strips, bar, input, std::move(*result));
  std::rethrow_exception(first);
}

/** The same. Where the outline lies farther beyond the last points than is usual, the ball enters a keep-out: then it stays farther away
 *  from all of them. */
Result
plannedBesideKeepOuts(Job job, ProgressBar& bar, const Result& input)
{
  constexpr int most_runs = 4;
  for (int run = 1;; ++run)
    try {
      Result result = plannedWithLeastUncut(job, bar, input);
      if (job.part.margin > 0.0)
        result.report.warnings.push_back(Diagnostic("the ball stays ", job.part.margin,
                                                    " mm farther from the keep-outs than it must: nearer, the ",
                                                    "path, which runs a little beyond the last points, would enter one"));
      return result;
    }
    catch (const EntersKeepOut& entry) {
      if (run == most_runs)
        throw;
      job.part.margin += entry.room();
    }
}

} // namespace

Result
plan(const Job& job)
{
  ProgressBar bar(job.quiet);
  Result input;
  std::vector<StageCost> stages;
  StageClock clock(stages);
  readInput(job, bar, input);
  clock.end("reading");
  const std::vector<NamedRegion> named = regionsOf(job.part, job.regions, job.read);
  std::vector<Result> regions;
  for (const NamedRegion& region : named) {
    Job one = job;
    one.part = region.part;
    regions.push_back(inRegion(region.name, [&] { return plannedBesideKeepOuts(one, bar, input); }));
    regions.back().region = region.name;
  }
  Result result = regions.size() == 1 ? std::move(regions.front()) : joined(job, input, std::move(regions));
  addStage(stages.front(), result.report.stages);
  return result;
}
