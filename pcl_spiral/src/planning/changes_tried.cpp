// SPDX-License-Identifier: BSD-3-Clause
#include "planning/changes_tried.h"

#include "planning/input_tables.h"
#include "planning/lacking_points.h"
#include "planning/point_noise.h"
#include "planning/scan_clearance.h"
#include "spiral/scan_warnings.h"

#include <pcl_spiral/collision/impl/false_echoes.h>
#include <pcl_spiral/core/impl/tolerances.h>

#include <pcl/common/point_tests.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double all_points = 0.98;  // share of the points: a path over fewer does not cut the whole scan
constexpr double least_points = 0.1; // the same: a path over fewer cuts a thing on the part, or beside it, such as a clamp
constexpr double finish_share = 0.5; // of the scallop height: what is left of the finish that is asked for
constexpr double deepest = 0.3;      // radii of the ball in a point: deeper is no noise, but shape that so few points do not show

/** Whether turns were made. */
bool
wasLate(const std::vector<PlanAttempt>& attempts)
{
  return std::any_of(attempts.begin(), attempts.end(), [](const PlanAttempt& one) { return one.late; });
}

/** Points of the scan. */
std::size_t
scanPoints(const SpiralPlan& plan)
{
  return plan.whole ? plan.whole->size() : plan.report.input_points;
}

/** Whether the path runs over at least \p share of the points of the scan. */
bool
runsOver(double share, const SpiralPlan& plan)
{
  return static_cast<double>(plan.report.used_points) >= share * static_cast<double>(scanPoints(plan));
}

/** Standard deviation of the points. Where a surface misses a part of the shape, the mean square of what is left counts that, too. */
double
noiseOf(const SpiralReport& report)
{
  return report.missed.least > 0.0 ? std::min(report.noise, report.missed.noise) : report.noise;
}

/** How deep the ball of \p plan may be in its \p points, mm. Shape that a fit misses is no noise. */
double
allowedDepth(const SpiralPlan& plan, const std::vector<Eigen::Vector3f>& points)
{
  const SpiralSettings& s = plan.settings;
  const double of_fit = std::min(gougeTolerance(s.chord_error, noiseOf(plan.report)), deepest * s.tool_radius);
  const double of_points = gougeTolerance(s.chord_error, pointNoise(points));
  return std::min(of_fit, std::max(of_points, finish_share * s.scallop_height));
}

/** What the path of \p plan is like. */
Diagnostic
figuresOf(const SpiralPlan& plan)
{
  const SpiralReport& report = plan.report;
  Diagnostic text("a path of ", std::round(report.path_length), " {mm}");
  if (!runsOver(all_points, plan))
    text += Diagnostic(" over ", report.used_points, " of ", scanPoints(plan), " points");
  double tight = 0.0, uncut = 0.0;
  for (const TightPlace& place : report.tight_places)
    tight += place.area;
  for (const UncutStrip& strip : plan.part.strips)
    uncut += strip.area;
  if (!report.tight_places.empty())
    text += Diagnostic("; places that the ball does not reach: ", report.tight_places.size(), ", ", tight, " {mm2} in all");
  if (uncut > 0.0)
    text += Diagnostic("; not cut beside keep-outs: ", uncut, " {mm2}");
  return text;
}

/** A search through changes, first each alone, then two together. */
class Search {
public:
  Search(const PlanInput& input, const PlanChanged& plan) : input_(input), plan_(plan), left_(std::make_shared<double>(input.remedy_tries))
  {
    if (input.choice.keep_outs.empty() && input.regions.size() < 2 && !input.mesh && !input.ball_closing)
      surface_ = std::make_shared<Surface::ConstPtr>();
  }

  /** What to add to the refusal. */
  Diagnostic run(const Refused& refused)
  {
    if (std::optional<Diagnostic> found = tryEach(input_, refused, nullptr))
      return *found;
    const Diagnostic alone = std::exchange(words_, Diagnostic());
    const std::vector<Step> steps = std::move(refused_);
    surface_.reset();
    for (const Step& step : steps)
      if (std::optional<Diagnostic> found = tryEach(step.change.input, step.refused, &step.change.words))
        return *found;
    if (stopped_)
      return ". The search for a change that gives a path was stopped";
    Diagnostic tried = alone.empty() ? Diagnostic(". There is no single change of the settings to try")
                                     : ". Of changes that were tried, none gives a path: " + alone;
    if (!words_.empty())
      tried += "; nor do two together: " + words_;
    return tried + (spent_ ? boundText() : lackOf(input_, refused.status.diagnostic()));
  }

private:
  /** A change, and why it gave no path. */
  struct Step {
    SingleChange change;
    Refused refused;
  };

  /** What is said of the first change of the \p refused \p input that gives a path, after the change \p before (null: none). */
  std::optional<Diagnostic> tryEach(const PlanInput& input, const Refused& refused, const ChangeWords* before)
  {
    for (SingleChange& change : singleChanges(input, refused)) {
      spent_ = spent_ || !(*left_ > 0.0);
      if (stopped_ || spent_)
        return std::nullopt;
      change.input.kept_surface = change.keeps_surface ? surface_ : nullptr;
      change.input.paths_left = left_;
      change.input.progress = progressOfTry();
      SpiralPlan with;
      const Status status = plan_(change.input, with);
      const ChangeWords words = before ? together(*before, change.words) : change.words;
      if (status.ok() && runsOver(least_points, with) && isClear(with))
        return Diagnostic(". Of single changes that were tried, ",
                          words.changes == 1 ? "one gives " : "none gives a path, but two together give ", figuresOf(with), ": ",
                          words.all());
      words_ += Diagnostic(words_.empty() ? "" : "; ", words.all());
      if (!status.ok() && status.code() != StatusCode::InvalidArgument && status.diagnostic() != refused.status.diagnostic())
        refused_.push_back({change, {status, wasLate(with.attempts)}});
    }
    return std::nullopt;
  }

  /** What ended the search, and how to go on. */
  Diagnostic boundText() const
  {
    constexpr double further = 4.0; // times as far: two more commands reach what takes dozens of tries
    const double tries = input_.remedy_tries;
    return Diagnostic(". The search ended after ", Given("setRemedyTries", tries), "; ",
                      Given("setRemedyTries", std::min(further * tries, most_remedy_tries)), " tries more");
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
  Diagnostic words_;                           ///< of the changes tried: each alone, or two together
  std::shared_ptr<double> left_;               ///< PlanInput::paths_left
  std::size_t tried_ = 0;                      ///< changes
  bool stopped_ = false;                       ///< by the progress callback
  bool spent_ = false;                         ///< a change was not tried, because PlanInput::remedy_tries paths were made
};

} // namespace

bool
isClear(const SpiralPlan& plan)
{
  if (plan.mesh || !plan.cloud)
    return true;
  if (!showsHollows(plan.report.spacing, plan.settings.tool_radius))
    return false;
  std::vector<Eigen::Vector3f> points;
  for (const pcl::PointXYZ& p : plan.whole ? *plan.whole : *plan.cloud)
    if (pcl::isFinite(p))
      points.push_back(p.getVector3fMap());
  pcl::PointCloud<pcl::PointXYZ> things;
  for (const Eigen::Vector3f& p : withoutEchoes(points, largest_echo))
    things.push_back({p.x(), p.y(), p.z()});
  const double depth = deepestPoint(*plan.path, plan.report.pass_begins, plan.settings.tool_radius, things).depth;
  return depth <= allowedDepth(plan, points);
}

Diagnostic
changeThatHelps(const PlanInput& input, const Status& refusal, const std::vector<PlanAttempt>& attempts, const PlanChanged& plan)
{
  return Search(input, plan).run({refusal, wasLate(attempts)});
}

} // namespace pcl_spiral
