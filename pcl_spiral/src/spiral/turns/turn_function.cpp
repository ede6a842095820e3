// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/tight_places.h>
#include <pcl_spiral/spiral/impl/turn_function.h>

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/step_over.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double smoothing_share = 1.0 / 64.0; // of the rim: standard deviation of what smooths rates across lines
constexpr double steepest_cosine = 0.05;       // of psi: a line nearly along its contour gives no information
constexpr double most_turns = 1e15;            // upper limit of the count: no path has so many
constexpr double reserve = 0.997;              // of the step-over: leaves room for the error of interpolation between lines

/** Curvature along \p direction by which turns are spaced. Where the ball does not fit at the foot, it is the plane's or a convex one: in
 *  oblique sections of a hollow the ball seems to fit, but barely, with step-overs of several times the plane's. Where some lines meet such
 *  sections and others do not, all turns would become closer. */
double
turnCurvature(const SurfaceFoot& foot, const Eigen::Vector3d& direction, double radius)
{
  const double across = foot.normalCurvature(direction), hollowest = std::min(foot.curvature1, foot.curvature2);
  const bool fits = spacingCurvature(radius, hollowest) == hollowest;
  return spacingCurvature(radius, fits ? across : std::max(across, 0.0));
}

} // namespace

TurnFunction::TurnFunction(const std::vector<RadialLine>& lines, const SpiralSettings& settings, double spacing)
: lines_(lines), settings_(settings), spacing_(spacing), max_step_(settings.max_step > 0.0 ? settings.max_step : settings.tool_radius)
{
  for (const RadialLine& line : lines)
    stations_.emplace_back(line.feet.size());
}

void
TurnFunction::setEvenSteps(double step_over, double step)
{
  even_step_over_ = step_over;
  max_step_ = step;
}

std::optional<TurnFunction::Station>
TurnFunction::stationAt(std::size_t line, std::size_t station, bool with_contours) const
{
  const auto& feet = lines_[line].feet;
  const SurfaceFoot& foot = footAt(line, station);
  const Eigen::Vector3d chord = feet[std::min(station + 1, feet.size() - 1)].position - feet[station > 0 ? station - 1 : 0].position;
  const Eigen::Vector3d tangent = (chord - chord.dot(foot.normal) * foot.normal).normalized();
  std::vector<Eigen::Vector3d> across;
  if (with_contours)
    for (const int side : lines_[line].corner ? std::vector<int>{-1, 1} : std::vector<int>{0})
      if (const auto contour = contourDirection(line, station, side))
        across.push_back(foot.normal.cross(*contour).normalized());
  if (across.empty())
    across.push_back(tangent);

  Station result;
  result.feed_step = max_step_;
  const double radius = settings_.tool_radius;
  for (const Eigen::Vector3d& direction : across) { // both sides of a corner: the closer pitch counts
    const double cos_psi = std::max(steepest_cosine, std::abs(tangent.dot(direction)));
    if (even_step_over_ > 0.0) {
      result.rate = std::max(result.rate, cos_psi / even_step_over_);
      continue;
    }
    const auto step = stepOver(radius, turnCurvature(foot, direction, radius), settings_.scallop_height);
    if (!step)
      return std::nullopt;
    result.rate = std::max(result.rate, cos_psi / (reserve * *step));
    const double along_feed = spacingCurvature(radius, foot.normalCurvature(direction.cross(foot.normal)));
    result.feed_step = std::min(result.feed_step, stepFromChordErrorAtCentre(radius, along_feed, settings_.chord_error, max_step_));
  }
  return result;
}

void
TurnFunction::smoothRates()
{
  const auto n = static_cast<std::int64_t>(lines_.size());
  const auto before = stations_;
  const auto gapAfter = [&](std::size_t j) {
    const double gap = lines_[(j + 1) % n].rim_share - lines_[j].rim_share;
    return gap > 0.0 ? gap : gap + 1.0;
  };
#pragma omp parallel for schedule(dynamic, 8)
  for (std::int64_t i = 0; i < n; ++i) {
    std::vector<double> sum(before[i].size(), 0.0);
    double whole = 0.0;
    const auto add = [&](std::size_t j, double apart) {
      const double share = 0.5 * (gapAfter(j) + gapAfter((j + n - 1) % n));
      const double w = share * std::exp(-0.5 * apart * apart / (smoothing_share * smoothing_share));
      for (std::size_t k = 0; k < sum.size(); ++k)
        sum[k] += w * before[j][k].rate;
      whole += w;
    };
    add(i, 0.0);
    for (const bool forward : {true, false}) {
      double apart = 0.0;
      for (std::size_t j = i;;) {
        const std::size_t next = forward ? (j + 1) % n : (j + n - 1) % n;
        apart += gapAfter(forward ? j : next);
        if (apart > 3.0 * smoothing_share)
          break;
        add(next, apart);
        j = next;
      }
    }
    for (std::size_t k = 0; k < sum.size(); ++k)
      stations_[i][k].rate = sum[k] / whole;
  }
}

void
TurnFunction::integrate(std::size_t line)
{
  auto& stations = stations_[line];
  const auto& other = lines_[(line + 1) % lines_.size()];
  if (lines_[line].feet[0].position == other.feet[0].position)
    stations[0].rate = stations[1].rate; // lines meet at the centre: no contour there
  const double ds = 1.0 / static_cast<double>(stations.size() - 1);
  stations[0].share = 0.0;
  for (std::size_t k = 1; k < stations.size(); ++k)
    stations[k].share = stations[k - 1].share + 0.5 * ds * (stations[k - 1].rate + stations[k].rate);
  const double whole = stations.back().share;
  for (Station& station : stations) {
    station.rate /= whole;
    station.share /= whole;
  }
}

double
TurnFunction::turnsNeeded(const std::vector<std::vector<Station>>& measured) const
{
  double needed = 0.0;
  for (std::size_t i = 0; i < stations_.size(); ++i)
    for (std::size_t k = 1; k < stations_[i].size(); ++k)
      needed = std::max(needed, lines_[i].length() * measured[i][k].rate / stations_[i][k].rate);
  return needed;
}

const SurfaceFoot&
TurnFunction::footAt(std::size_t line, std::size_t station) const
{
  const auto& feet = lines_[line].feet;
  const bool beyond = !feet[station].valid && (station == 0 || station + 1 == feet.size());
  return feet[!beyond ? station : station == 0 ? 1 : station - 1];
}

Status
TurnFunction::checkFeet() const
{
  TightPlaces tight(settings_.tool_radius);
  for (std::size_t i = 0; i < lines_.size(); ++i)
    for (std::size_t k = 0; k < lines_[i].feet.size(); ++k) {
      const SurfaceFoot& foot = footAt(i, k);
      if (!foot.valid)
        return {StatusCode::Failed, Diagnostic("radial line ", i, " leaves the {scanned surface} at ", Place(foot.position),
                                               ": scan the surface there, or leave the line out")};
      if (!(even_step_over_ > 0.0) && settings_.tight == TightHandling::Refuse)
        tight.add(foot);
    }
  return tight.empty() ? Status::success() : tight.refusal("points of the radial lines", nullptr);
}

void
TurnFunction::findStepOvers()
{
  smallest_step_over_ = largest_step_over_ = even_step_over_;
  if (even_step_over_ > 0.0)
    return;
  smallest_step_over_ = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < lines_.size(); ++i)
    for (std::size_t k = 0; k < lines_[i].feet.size(); ++k)
      for (const double curvature : {footAt(i, k).curvature1, footAt(i, k).curvature2})
        if (const auto step =
                stepOver(settings_.tool_radius, spacingCurvature(settings_.tool_radius, curvature), settings_.scallop_height)) {
          smallest_step_over_ = std::min(smallest_step_over_, *step);
          largest_step_over_ = std::max(largest_step_over_, *step);
        }
}

Status
TurnFunction::compute()
{
  const auto n = static_cast<std::int64_t>(lines_.size());
  if (const Status status = checkFeet(); !status.ok())
    return status;
  const auto measure = [&](bool across_feed, std::vector<std::vector<Station>>& measured) {
    measured = stations_;
    bool fits = true;
#pragma omp parallel for schedule(dynamic, 8) reduction(&& : fits)
    for (std::int64_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < measured[i].size(); ++k) {
        const auto station = stationAt(i, k, across_feed);
        fits = fits && station.has_value();
        if (station)
          measured[i][k] = *station;
      }
    return fits;
  };
  const Status no_step(StatusCode::Failed, "no step-over exists for this tool on the surface: use a smaller tool");
  if (!measure(false, stations_))
    return no_step;
  const auto integrateAll = [&] {
#pragma omp parallel for schedule(static)
    for (std::int64_t i = 0; i < n; ++i)
      integrate(i);
  };
  integrateAll();
  const bool across_feed = settings_.pitch == Pitch::AcrossFeed;
  if (across_feed) {
    smoothRates();
    integrateAll();
  }
  std::vector<std::vector<Station>> measured;
  if (!measure(across_feed, measured))
    return no_step;
  turns_ = static_cast<std::size_t>(std::ceil(std::min(turnsNeeded(measured), most_turns)));
  for (std::int64_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < measured[i].size(); ++k)
      stations_[i][k].feed_step = measured[i][k].feed_step;
  findStepOvers();
  return Status::success();
}

} // namespace pcl_spiral
