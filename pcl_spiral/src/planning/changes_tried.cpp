// SPDX-License-Identifier: BSD-3-Clause
#include "planning/changes_tried.h"

#include "graph/local_shape.h"

#include <pcl/common/point_tests.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double early_cost = 1.0 / 3.0; // of a path: a try refused before turns are made

/** Whether turns were made. */
bool
wasLate(const std::vector<PlanAttempt>& attempts)
{
  return std::any_of(attempts.begin(), attempts.end(), [](const PlanAttempt& one) { return one.late; });
}

/** How long the tries of \p attempts took, in paths. */
double
costOf(const std::vector<PlanAttempt>& attempts)
{
  double cost = 0.0;
  for (const PlanAttempt& one : attempts)
    cost += one.refusal.empty() || one.late ? 1.0 : early_cost;
  return std::max(cost, early_cost);
}

/** What the path of \p plan is like. */
Diagnostic
figuresOf(const SpiralPlan& plan)
{
  const SpiralReport& report = plan.report;
  Diagnostic text("a path of ", std::round(report.path_length), " {mm}");
  double tight = 0.0, uncut = 0.0;
  for (const TightPlace& place : report.tight_places)
    tight += place.area;
  for (const UncutStrip& strip : plan.part.strips)
    uncut += strip.area;
  if (!report.tight_places.empty())
    text += Diagnostic(", with ", report.tight_places.size(), " places that the ball does not reach, ", tight, " {mm2} in all");
  if (uncut > 0.0)
    text += Diagnostic(", and ", uncut, " {mm2} beside keep-outs that are not cut");
  return text;
}

/** How far the points of \p cloud about \p place are apart, mm, by the distance of the eighth of them. */
double
spacingAt(const pcl::PointCloud<pcl::PointXYZ>& cloud, const Eigen::Vector3d& place)
{
  constexpr std::size_t few = 8;
  std::vector<double> squared;
  for (const pcl::PointXYZ& p : cloud)
    if (pcl::isFinite(p))
      squared.push_back((p.getVector3fMap().cast<double>() - place).squaredNorm());
  if (squared.size() < few)
    return 0.0;
  std::nth_element(squared.begin(), squared.begin() + (few - 1), squared.end());
  return evenSpacing(std::sqrt(squared[few - 1]), static_cast<int>(few));
}

/** What another scan has to show, by the first place of what was \p said. */
Diagnostic
lackOf(const PlanInput& input, const Diagnostic& said)
{
  if (said.places().empty())
    return ". What helps is another scan: {scan it again, more densely}";
  const Eigen::Vector3d place = said.places().front();
  if (input.mesh || !input.cloud || input.cloud->empty())
    return Diagnostic(". What is missing is at ", Place(place), ": {scan it again, more densely}");
  return Diagnostic(". What the {scan} lacks is at ", Place(place), ", where its points lie ", spacingAt(*input.cloud, place),
                    " {mm} apart and do not show one surface for this ball: {scan it again, more densely}, or from another side");
}

/** A search through changes, first each alone, then two together. */
class Search {
public:
  Search(const PlanInput& input, const PlanChanged& plan) : input_(input), plan_(plan)
  {
    if (input.choice.keep_outs.empty() && input.regions.size() < 2 && !input.mesh && !input.ball_closing)
      surface_ = std::make_shared<Surface::ConstPtr>();
  }

  /** What to add to the refusal. */
  Diagnostic run(const Refused& refused)
  {
    if (std::optional<Diagnostic> found = tryEach(input_, refused, nullptr))
      return ". Of single changes that were tried, this one alone gives a path: " + *found;
    const std::vector<Step> alone = std::move(refused_);
    surface_.reset();
    for (const Step& step : alone)
      if (std::optional<Diagnostic> found = tryEach(step.change.input, step.refused, &step.change.words))
        return ". Of single changes that were tried, none gives a path, but two together do: " + *found;
    if (stopped_)
      return ". The search for a change that gives a path was stopped";
    const Diagnostic lack = lackOf(input_, refused.status.diagnostic());
    return alone.empty() ? lack : ". Of changes that were tried, none gives a path: " + listOf(alone) + lack;
  }

private:
  /** A change, and why it gave no path. */
  struct Step {
    SingleChange change;
    Refused refused;
  };

  /** The first change of the \p refused \p input that gives a path, after the change \p before (null: none), with what it is like. */
  std::optional<Diagnostic> tryEach(const PlanInput& input, const Refused& refused, const Diagnostic* before)
  {
    for (SingleChange& change : singleChanges(input, refused)) {
      if (stopped_ || !(spent_ < input_.remedy_tries))
        return std::nullopt;
      change.input.kept_surface = change.keeps_surface ? surface_ : nullptr;
      change.input.progress = progressOfTry();
      SpiralPlan with;
      const Status status = plan_(change.input, with);
      const Diagnostic words = before ? Diagnostic(*before, " and ", change.words) : change.words;
      if (status.ok())
        return Diagnostic(words, ": ", figuresOf(with));
      spent_ += costOf(with.attempts);
      if (status.code() != StatusCode::InvalidArgument && status.diagnostic() != refused.status.diagnostic())
        refused_.push_back({change, {status, wasLate(with.attempts)}});
    }
    return std::nullopt;
  }

  static Diagnostic listOf(const std::vector<Step>& steps)
  {
    Diagnostic list;
    for (const Step& step : steps)
      list += Diagnostic(list.empty() ? "" : "; ", step.change.words);
    return list;
  }

  /** The share stays where it was. */
  ProgressCallback progressOfTry()
  {
    if (!input_.progress)
      return {};
    return [this, stage = "trying change " + std::to_string(++tried_)](double share, const std::string&) {
      stopped_ = stopped_ || !input_.progress(share, stage);
      return !stopped_;
    };
  }

  const PlanInput& input_;
  const PlanChanged& plan_;
  std::shared_ptr<Surface::ConstPtr> surface_; ///< of the input, once it is made; null: each try makes its own
  std::vector<Step> refused_;                  ///< changes that gave no path
  double spent_ = 0.0;                         ///< paths
  std::size_t tried_ = 0;                      ///< changes
  bool stopped_ = false;                       ///< by the progress callback
};

} // namespace

Diagnostic
changeThatHelps(const PlanInput& input, const Status& refusal, const std::vector<PlanAttempt>& attempts, const PlanChanged& plan)
{
  return Search(input, plan).run({refusal, wasLate(attempts)});
}

} // namespace pcl_spiral
