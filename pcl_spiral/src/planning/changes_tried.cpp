// SPDX-License-Identifier: BSD-3-Clause
#include "planning/changes_tried.h"

#include "planning/scan_clearance.h"

#include "graph/local_shape.h"
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

constexpr double all_points = 0.98; // share of the points: a path over fewer does not cut the whole scan

/** Whether turns were made. */
bool
wasLate(const std::vector<PlanAttempt>& attempts)
{
  return std::any_of(attempts.begin(), attempts.end(), [](const PlanAttempt& one) { return one.late; });
}

/** What the path of \p plan is like. */
Diagnostic
figuresOf(const SpiralPlan& plan)
{
  const SpiralReport& report = plan.report;
  Diagnostic text("a path of ", std::round(report.path_length), " {mm}");
  const std::size_t all = plan.whole ? plan.whole->size() : report.input_points;
  if (static_cast<double>(report.used_points) < all_points * static_cast<double>(all))
    text += Diagnostic(" over ", report.used_points, " of ", all, " points");
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

/** Whether the ball of \p plan stays out of all points of its scan but single false echoes, also out of those that are left out. */
bool
isClear(const SpiralPlan& plan)
{
  if (plan.mesh || !plan.whole)
    return true;
  std::vector<Eigen::Vector3f> points;
  for (const pcl::PointXYZ& p : *plan.whole)
    if (pcl::isFinite(p))
      points.push_back(p.getVector3fMap());
  pcl::PointCloud<pcl::PointXYZ> things;
  for (const Eigen::Vector3f& p : withoutEchoes(points, largest_echo))
    things.push_back({p.x(), p.y(), p.z()});
  const SpiralSettings& s = plan.settings;
  return deepestPoint(*plan.path, plan.report.pass_begins, s.tool_radius, things).depth <= gougeTolerance(s.chord_error, plan.report.noise);
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

/** What another scan has to show, by the first place of what was \p said, and what of the choice of the part is in the way. */
Diagnostic
lackOf(const PlanInput& input, const Diagnostic& said)
{
  Diagnostic lack = ". What the {scan} lacks: {scan it again, more densely}";
  if (!said.places().empty()) {
    const Eigen::Vector3d place = said.places().front();
    lack = Diagnostic(". What the {scan} lacks is at ", Place(place));
    if (!input.mesh && input.cloud)
      lack += Diagnostic(", where its points lie ", spacingAt(*input.cloud, place), " {mm} apart");
    lack += ": {scan it again, more densely}";
  }
  if (!input.mesh)
    lack += ", or from another side";
  if (!input.choice.keep_outs.empty())
    lack += ", or give smaller keep-outs ({addKeepOut})";
  if (input.choice.crop || input.choice.crop_box)
    lack += Diagnostic(", or another crop (", input.choice.crop ? "{setCrop}" : "{setCropBox}", ")");
  return lack;
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
      return ". Of single changes that were tried, one gives " + *found;
    const Diagnostic alone = words_;
    const std::vector<Step> steps = std::move(refused_);
    surface_.reset();
    for (const Step& step : steps)
      if (std::optional<Diagnostic> found = tryEach(step.change.input, step.refused, &step.change.words))
        return ". Of single changes that were tried, none gives a path, but two together give " + *found;
    if (stopped_)
      return ". The search for a change that gives a path was stopped";
    const Diagnostic lack = lackOf(input_, refused.status.diagnostic());
    return alone.empty() ? lack : ". Of changes that were tried, none gives a path: " + alone + lack;
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
      if (stopped_ || !(*left_ > 0.0))
        return std::nullopt;
      change.input.kept_surface = change.keeps_surface ? surface_ : nullptr;
      change.input.paths_left = left_;
      change.input.progress = progressOfTry();
      SpiralPlan with;
      const Status status = plan_(change.input, with);
      const Diagnostic words = before ? Diagnostic(*before, " and ", change.words) : change.words;
      if (status.ok() && isClear(with))
        return Diagnostic(figuresOf(with), ": ", words);
      words_ += Diagnostic(words_.empty() ? "" : "; ", change.words);
      if (!status.ok() && status.code() != StatusCode::InvalidArgument && status.diagnostic() != refused.status.diagnostic())
        refused_.push_back({change, {status, wasLate(with.attempts)}});
    }
    return std::nullopt;
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
  Diagnostic words_;                           ///< of the changes tried
  std::shared_ptr<double> left_;               ///< PlanInput::paths_left
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
