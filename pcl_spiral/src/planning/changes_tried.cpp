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

/** What of a cloud is about a place. */
struct Neighbourhood {
  double spacing = 0.0;   ///< mm, by the distance of the eighth point; 0 of fewer
  bool is_within = false; ///< the eight points are not all on one side
};

Neighbourhood
aboutPlace(const pcl::PointCloud<pcl::PointXYZ>& cloud, const Eigen::Vector3d& place)
{
  constexpr std::size_t few = 8;
  constexpr double one_side = 0.9; // length of the mean direction: of directions within 50 degrees of one
  std::vector<std::pair<double, std::size_t>> squared;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (pcl::isFinite(cloud[i]))
      squared.emplace_back((cloud[i].getVector3fMap().cast<double>() - place).squaredNorm(), i);
  if (squared.size() < few)
    return {};
  std::nth_element(squared.begin(), squared.begin() + (few - 1), squared.end());
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < few; ++k)
    sum += (cloud[squared[k].second].getVector3fMap().cast<double>() - place).normalized();
  return {evenSpacing(std::sqrt(squared[few - 1].first), static_cast<int>(few)), sum.norm() < one_side * static_cast<double>(few)};
}

/** The usual distance between points of \p cloud, mm: the median over some of them. */
double
usualSpacing(const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  constexpr std::size_t looked_at = 32;
  std::vector<double> spacings;
  for (std::size_t k = 0; k < looked_at; ++k)
    if (const pcl::PointXYZ& p = cloud[k * cloud.size() / looked_at]; pcl::isFinite(p))
      spacings.push_back(aboutPlace(cloud, p.getVector3fMap().cast<double>()).spacing);
  if (spacings.empty())
    return 0.0;
  std::nth_element(spacings.begin(), spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2), spacings.end());
  return spacings[spacings.size() / 2];
}

/** Where the scan has fewer points than elsewhere, if the first place of what was \p said is such a place; else nothing: then it is not
 *  the scan that keeps the path from being made. */
Diagnostic
lackOf(const PlanInput& input, const Diagnostic& said)
{
  constexpr double sparse = 2.0; // times the usual spacing: at a right corner of an even scan, with a quarter of the points about
  if (said.places().empty() || input.mesh || !input.cloud || input.cloud->empty())
    return {};
  const Eigen::Vector3d place = said.places().front();
  const Neighbourhood there = aboutPlace(*input.cloud, place);
  const double usual = usualSpacing(*input.cloud);
  if (!(there.spacing > sparse * usual) || !there.is_within)
    return {};
  return Diagnostic(". What the {scan} lacks is at ", Place(place), ", where its points lie ", there.spacing, " {mm} apart, ", usual,
                    " {mm} elsewhere: {scan it again, more densely}, or from another side");
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
    Diagnostic tried = alone.empty() ? Diagnostic() : ". Of changes that were tried, none gives a path: " + alone;
    if (spent_)
      return tried + Diagnostic("; others were not tried ({setRemedyTries})");
    return tried + lackOf(input_, refused.status.diagnostic());
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
      spent_ = spent_ || !(*left_ > 0.0);
      if (stopped_ || spent_)
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
  bool spent_ = false;                         ///< a change was not tried, because PlanInput::remedy_tries paths were made
};

} // namespace

Diagnostic
changeThatHelps(const PlanInput& input, const Status& refusal, const std::vector<PlanAttempt>& attempts, const PlanChanged& plan)
{
  return Search(input, plan).run({refusal, wasLate(attempts)});
}

} // namespace pcl_spiral
