// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/tight_places.h>
#include <pcl_spiral/spiral/impl/turn_function.h>

#include <pcl_spiral/common/impl/message.h>
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

/** Derivative at u[at] of Lagrange's polynomial through points p at u. */
Eigen::Vector3d
lagrangeSlope(const std::vector<double>& u, const Polyline& p, std::size_t at)
{
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  for (std::size_t j = 0; j < u.size(); ++j) {
    if (j == at)
      continue;
    double weight = 1.0 / (u[j] - u[at]);
    for (std::size_t k = 0; k < u.size(); ++k)
      if (k != at && k != j)
        weight *= (u[at] - u[k]) / (u[j] - u[k]);
    slope += weight * p[j] + p[at] / (u[at] - u[j]);
  }
  return slope;
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

double
TurnFunction::shareAt(std::size_t i, double s) const
{
  const auto& stations = stations_[i];
  const double ds = 1.0 / static_cast<double>(stations.size() - 1);
  const double at = std::clamp(s / lines_[i].stationSpacing(), 0.0, static_cast<double>(stations.size() - 1));
  const std::size_t k = std::min(stations.size() - 2, static_cast<std::size_t>(at));
  const double f = at - static_cast<double>(k);
  const double r0 = stations[k].rate, r1 = stations[k + 1].rate;
  return stations[k].share + ds * f * (r0 + 0.5 * f * (r1 - r0));
}

double
TurnFunction::arcLengthAtShare(std::size_t i, double share) const
{
  const auto& stations = stations_[i];
  const double ds = 1.0 / static_cast<double>(stations.size() - 1);
  const double wanted = std::clamp(share, 0.0, 1.0);
  const auto above = std::upper_bound(stations.begin() + 1, stations.end() - 1, wanted,
                                      [](double t, const Station& station) { return t < station.share; });
  const auto k = static_cast<std::size_t>(above - stations.begin()) - 1;
  // The rate is linear between stations: the share grows as a quadratic, solved for its root in [0, 1].
  const double r0 = stations[k].rate, change = stations[k + 1].rate - r0;
  const double y = (wanted - stations[k].share) / ds;
  const double root = std::sqrt(std::max(0.0, r0 * r0 + 2.0 * change * y));
  const double f = 2.0 * y / (r0 + root);
  return lines_[i].stationSpacing() * (static_cast<double>(k) + std::clamp(f, 0.0, 1.0));
}

double
TurnFunction::arcLengthAt(std::size_t i, double tau) const
{
  return arcLengthAtShare(i, tau / static_cast<double>(turns_));
}

double
TurnFunction::feedStepAt(std::size_t i, double s) const
{
  const auto& stations = stations_[i];
  const double at = std::clamp(s / lines_[i].stationSpacing(), 0.0, static_cast<double>(stations.size() - 1));
  const std::size_t k = std::min(stations.size() - 2, static_cast<std::size_t>(at));
  const double f = at - static_cast<double>(k);
  return (1.0 - f) * stations[k].feed_step + f * stations[k + 1].feed_step;
}

Eigen::Vector3d
TurnFunction::positionOn(std::size_t line, double share) const
{
  const double s = arcLengthAtShare(line, share);
  const auto& feet = lines_[line].feet;
  const double at = s / lines_[line].stationSpacing();
  const std::size_t k = std::min(feet.size() - 2, static_cast<std::size_t>(at));
  const double f = at - static_cast<double>(k);
  return (1.0 - f) * feet[k].position + f * feet[k + 1].position;
}

std::optional<Eigen::Vector3d>
TurnFunction::contourDirection(std::size_t line, std::size_t station, int side) const
{
  const std::size_t n = lines_.size();
  const double share = shareAt(line, lines_[line].stationSpacing() * static_cast<double>(station));
  const Eigen::Vector3d p = positionOn(line, share);
  // A line some steps away, with its place along the rim; at most to the next corner.
  const auto reach = [&](int direction, std::size_t steps, double& u) {
    std::size_t i = line;
    u = lines_[line].rim_share;
    for (std::size_t step = 0; step < steps && (step == 0 || !lines_[i].corner); ++step) {
      const std::size_t next = direction > 0 ? (i + 1) % n : (i + n - 1) % n;
      const double gap = lines_[next].rim_share - lines_[i].rim_share;
      u += direction > 0 ? (gap > 0.0 ? gap : gap + 1.0) : (gap < 0.0 ? gap : gap - 1.0);
      i = next;
    }
    return i;
  };
  for (std::size_t stride = 1;; stride *= 2) {
    std::vector<double> u{lines_[line].rim_share};
    Polyline points{p};
    double closest = std::numeric_limits<double>::max();
    for (const int direction : {-1, 1}) {
      if (side == -direction)
        continue;
      double last = u[0];
      for (std::size_t m = 1; m <= 2; ++m) {
        double place = 0.0;
        const std::size_t i = reach(direction, m * stride, place);
        if (place == last)
          break;
        last = place;
        u.push_back(place);
        points.push_back(positionOn(i, share));
        closest = std::min(closest, (points.back() - p).norm());
      }
    }
    if (u.size() < 2)
      return std::nullopt;
    const bool widest = stride >= n / 16;
    if (closest >= spacing_ || widest)
      return closest > 0.0 ? std::optional<Eigen::Vector3d>(lagrangeSlope(u, points, 0)) : std::nullopt;
  }
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
    const auto step = stepOver(radius, spacingCurvature(radius, foot.normalCurvature(direction)), settings_.scallop_height);
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
        return {StatusCode::Failed, textOf("radial line ", i, " leaves the scanned surface at ", placeText(foot.position),
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
