// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/planning/impl/spiral_planning.h>

#include "planning/changes_tried.h"
#include "planning/closed_scan.h"
#include "planning/input_tables.h"
#include "planning/joined_plan.h"
#include "planning/mesh_samples.h"
#include "planning/plan_attempt.h"
#include "planning/plan_regions.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr int most_late = 2;                                  // tries refused late, so that a refusal takes about twice as long as a path
constexpr double early_cost = 1.0 / 3.0;                      // of a path: a try refused before turns are made, at the longest
constexpr int most_runs = 4;                                  // of a path that enters keep-outs a little, each time farther away from them
constexpr double narrowest_strips = 2.0, widest_strips = 5.0; // point spacings

/** The tries to plan one region. */
class RegionTries {
public:
  /** \p base: a plan with the whole scan. */
  RegionTries(const PlanInput& input, PartChoice choice, const SpiralPlan& base, ProgressCallback progress)
  : input_(input), choice_(std::move(choice)), base_(base), progress_(std::move(progress))
  {}

  /** The path. Where the outline lies farther beyond the last points than is usual, the ball enters a keep-out: then it stays farther away
   *  from all of them. */
  Status run(SpiralPlan& plan)
  {
    for (int run = 1;; ++run) {
      const AttemptResult result = leastUncut(plan);
      if (result.refusal != Refusal::KeepOut || run == most_runs || exhausted()) {
        plan.attempts = std::move(attempts_);
        if (result.status.ok() && choice_.margin > 0.0)
          plan.report.warnings.push_back(Diagnostic("the ball stays ", choice_.margin,
                                                    " {mm} farther from the keep-outs than it must: nearer, the ",
                                                    "path, which runs a little beyond the last points, would enter one"));
        return result.status;
      }
      choice_.margin += result.room;
    }
  }

private:
  AttemptResult tryWith(const StripChoice& strips, SpiralPlan& plan)
  {
    plan = base_;
    const AttemptResult result = attempt(input_, choice_, strips, progress_, plan);
    if (input_.paths_left)
      *input_.paths_left -= result.status.ok() || result.late ? 1.0 : early_cost;
    attempts_.push_back(
        {choice_.margin, strips.width, strips.cut, result.status.ok() ? Diagnostic() : result.status.diagnostic(), result.late});
    return result;
  }

  /** Whether no more tries are allowed. */
  bool exhausted() const { return input_.paths_left && !(*input_.paths_left > 0.0); }

  /** The path over the whole region. If there is none, or if it crosses a keep-out, the narrowest strips beside keep-outs are left out,
   *  and no more of them than must be. A try that fails soon costs a third of a path or less, so all of these are made. */
  AttemptResult leastUncut(SpiralPlan& plan)
  {
    const AttemptResult first = tryWith({}, plan);
    const bool may_help =
        first.refusal == Refusal::NoPath ? !choice_.keep_outs.empty() : first.refusal == Refusal::KeepOut && first.crosses;
    if (!may_help)
      return first;
    int late = first.refusal == Refusal::NoPath && first.late ? 1 : 0;
    Surface::ConstPtr surface;
    for (StripChoice strips{narrowest_strips, {}, &surface}; strips.width <= widest_strips && late < most_late && !exhausted();
         strips.width += 1.0) {
      const AttemptResult result = tryWith(strips, plan);
      if (result.status.ok()) {
        cutStrips(strips, plan);
        return result;
      }
      if (result.status.code() == StatusCode::Cancelled)
        return result;
      late += result.late ? 1 : 0;
    }
    return first;
  }

  /** Cuts as many of the strips that \p plan leaves uncut as can be. */
  void cutStrips(StripChoice strips, SpiralPlan& plan)
  {
    const std::size_t found = plan.part.strips.size();
    for (std::size_t i = 0; i < found && plan.part.strips.size() > 1 && !exhausted(); ++i) {
      strips.cut.push_back(i);
      SpiralPlan with;
      if (tryWith(strips, with).status.ok())
        plan = std::move(with);
      else
        strips.cut.pop_back();
    }
  }

  const PlanInput& input_;
  PartChoice choice_;
  const SpiralPlan& base_;
  ProgressCallback progress_;
  std::vector<PlanAttempt> attempts_;
};

/** What a mesh cannot have: its own faces say what is cut, and which side is outside. */
Status
checkMesh(const PlanInput& input)
{
  const SpiralSettings& s = input.settings;
  const char* const setter = s.view_point               ? "{setViewPoint}"
                             : s.thinning > 0.0         ? "{setThinning}"
                             : s.outlier_neighbours > 0 ? "{setOutlierRemoval}"
                                                        : nullptr;
  if (setter != nullptr)
    return {StatusCode::InvalidArgument,
            Diagnostic(setter, " belongs to scans, and a mesh is given ({setInputMesh}): leave one of the two out")};
  return checkPartOfMesh(input.choice, input.regions);
}

/** What planning needs beside the settings of the spiral, which the generator checks. */
Status
checkSettings(const PlanInput& input)
{
  if (!input.holder.empty() && !(input.flank_length > 0.0))
    return {StatusCode::InvalidArgument,
            Diagnostic("the distance from the ball to the holder is ", input.flank_length, " {mm}: set it above 0 ({setFlankLength})")};
  if (!(input.sample_spacing >= 0.0))
    return {StatusCode::InvalidArgument, Diagnostic("the distance of samples is ", input.sample_spacing,
                                                    " {mm}: set it above 0 ({setSampleSpacing}), or 0 to find it from the mesh")};
  if (int tries = input.remedy_tries; !remedyTries(tries).range.takes(tries))
    return {StatusCode::InvalidArgument, Diagnostic("a search for a remedy may cost ", tries, " paths ({setRemedyTries}): it ",
                                                    ruleOf(remedyTries(tries)), " for no search")};
  if (input.regions.size() > 1 && input.settings.centre)
    return {StatusCode::InvalidArgument, "a centre ({setCenter}) belongs to one region, and several are given ({addRegion}): plan each "
                                         "region by its own, or leave the centre out"};
  return Status::success();
}

/** \p progress with shares that do not fall when a path is tried again. */
ProgressCallback
neverLess(const ProgressCallback& progress)
{
  if (!progress)
    return {};
  const auto most = std::make_shared<double>(0.0);
  return [progress, most](double share, const std::string& stage) {
    *most = std::max(*most, share);
    return progress(*most, stage);
  };
}

/** Plans every region of \p input; \p plan has the whole scan, or the samples of the mesh. The paths are made over a surface that is
 *  raised by \p rounding, mm. */
Status
planAll(const PlanInput& input, double rounding, const ProgressCallback& progress, SpiralPlan& plan)
{
  const SpiralPlan base = plan;
  const std::vector<PlanRegion> regions = namedRegions(input.regions);
  std::vector<SpiralPlan> made;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    made.emplace_back();
    RegionTries tries(input, choiceOf(input.choice, regions[i]), base, progressOf(progress, i, regions.size()));
    if (const Status status = tries.run(made.back()); !status.ok()) {
      plan = SpiralPlan();
      plan.attempts = std::move(made.back().attempts);
      return {status.code(), textOfRegion(regions[i].name, status.diagnostic())};
    }
    if (rounding > 0.0)
      moveToScan(rounding, made.back());
    made.back().region = regions[i].name;
  }
  if (made.size() == 1) {
    plan = std::move(made.front());
    return Status::success();
  }
  const Status status = joinPlans(std::move(made), plan);
  if (!status.ok())
    plan = SpiralPlan();
  return status;
}

/** Plans every region of \p input as it is, over a scan that is closed by the ball in \p closings ways at most. */
Status
planOnce(const PlanInput& input, std::size_t closings, SpiralPlan& plan)
{
  plan = SpiralPlan();
  if (const Status status = checkSettings(input); !status.ok())
    return status;
  std::vector<StageCost> stages;
  StageClock clock(stages);
  if (input.mesh && !input.ball_closing) {
    if (const Status status = checkMesh(input); !status.ok())
      return status;
    if (const Status status = sampleMesh(input.mesh, input.sample_spacing, input.settings, input.progress, plan); !status.ok())
      return status;
    clock.end("samples");
  }
  const auto run = [&](const PlanInput& with, double rounding, SpiralPlan& result) {
    if (!input.mesh) {
      result = SpiralPlan();
      result.whole = input.cloud;
      result.cloud = with.cloud;
    }
    return planAll(with, rounding, input.progress, result);
  };
  const Status status = input.ball_closing ? planClosed(input, closings, run, plan) : run(input, 0.0, plan);
  if (status.ok())
    for (const StageCost& stage : stages)
      addStage(stage, plan.report.stages);
  return status;
}

} // namespace

Status
planSpiral(const PlanInput& input, SpiralPlan& plan)
{
  PlanInput given = input;
  given.progress = neverLess(input.progress);
  chooseOnly(given.regions, given.choice);
  const Status status = planOnce(given, closing_tries, plan);
  const bool final = status.ok() || status.code() == StatusCode::InvalidArgument || status.code() == StatusCode::Cancelled;
  if (final || input.remedy_tries == 0)
    return status;
  const auto changed = [](const PlanInput& with, SpiralPlan& result) { return planOnce(with, closing_tries_of_a_change, result); };
  return {status.code(), status.diagnostic() + changeThatHelps(given, status, plan.attempts, changed)};
}

} // namespace pcl_spiral
