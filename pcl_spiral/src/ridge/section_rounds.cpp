// SPDX-License-Identifier: BSD-3-Clause
#include "section_rounds.h"

#include "rail_step.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr std::size_t extra_cells = 2;   // the generator may grow by this many cells a round, at each end
constexpr double section_spacings = 5.0; // length of a section, in spacings of the scan
constexpr double section_share = 0.3;    // least length, of the half width: a rail that bends within less would fold the band
constexpr double section_points = 30.0;  // least number of scan points to either side
constexpr double cell_spacings = 1.5;
constexpr std::size_t fewest_sections = 8, most_sections = 4000;
constexpr int rounds_of_ends = 5;   // after these the generator's ends are fixed, and the rail is fitted as closely as in the round before
constexpr double held_share = 1.02; // of the error of that fit, so that a tiny difference does not change the number of spans

Vector3d
turnedBy(double angle, const Vector3d& local)
{
  return Eigen::AngleAxisd(angle, Vector3d::UnitX()) * local;
}

} // namespace

SectionRounds::SectionRounds(const RoundSettings& settings, SectionBand band, const SmoothLine& generator)
: settings_(settings), band_(std::move(band)), generator_(generator)
{
  const double spacing = settings_.spacing, width = settings_.half_width;
  const double length = std::max({section_spacings * spacing, section_share * width, section_points * spacing * spacing / width});
  const double pieces = std::clamp(band_.rail.length() / length, static_cast<double>(fewest_sections), static_cast<double>(most_sections));
  count_ = static_cast<std::size_t>(pieces) + (band_.rail.closed() ? 0 : 1);
  Polyline points;
  const auto cells = static_cast<int>(std::max(12.0, generator.length() / (cell_spacings * settings_.spacing)));
  for (int k = 0; k <= cells; ++k)
    points.push_back(generator.position(generator.length() * k / cells));
  setGenerator(points);
}

/** Fit the generator through \p points, one a cell, and turn the chord to it. */
void
SectionRounds::setGenerator(const Polyline& points)
{
  generator_ = fitLine({points, false, 0.0}).line;
  const Vector3d chord = generator_.position(generator_.length()) - generator_.position(0.0);
  const double angle = std::atan2(chord.z(), chord.y());
  Polyline turned;
  for (const Vector3d& p : points)
    turned.push_back(turnedBy(-angle, p));
  generator_ = fitLine({turned, false, 0.0}).line;
  profile_.line = StationLine(generator_, generator_.length() / static_cast<double>(points.size() - 1), extra_cells);
  profile_.length = generator_.length();
  const Vector3d tangent = band_.rail.tangent(meeting_share * band_.rail.length());
  if (const std::optional<RidgeFrame> frame = ridgeFrame(tangent, band_.chord))
    band_.chord = ridgeChord(tangent, frame->turned(turnedBy(angle, Vector3d::UnitY())), band_.chord.reference);
}

Status
SectionRounds::place()
{
  length_ = band_.rail.length() / static_cast<double>(band_.rail.closed() ? count_ : count_ - 1);
  rail_stations_ = StationLine(band_.rail, std::min(length_, std::max(settings_.spacing, 0.2 * length_)));
  for (std::size_t i = 0; i < rail_stations_.size(); ++i)
    if (!ridgeFrame(rail_stations_.tangent(i), band_.chord))
      return {
          StatusCode::InvalidInput,
          Diagnostic(
              "the ridge is too steep at ", Place(rail_stations_.position(i)), " for a chord at ",
              std::asin(std::clamp(band_.chord.sin_angle, -1.0, 1.0)) * 180.0 / pi,
              " {degrees} to the reference plane: set a reference normal across the ridge ({setReferenceNormal}), or make it in pieces")};
  placePoints(rail_stations_, band_);
  section_points_ = pointsBySection(band_, count_, length_);
  return Status::success();
}

std::vector<SectionShift>
SectionRounds::shifts(int most_steps)
{
  std::vector<SectionShift> result(count_);
#pragma omp parallel for schedule(dynamic, 8)
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(count_); ++i)
    result[i] =
        shiftOnto(band_, section_points_, static_cast<std::size_t>(i), profile_, settings_.noise, 0.5 * settings_.half_width, most_steps);
  return result;
}

std::vector<SectionShift>
SectionRounds::unmoved()
{
  return shifts(0);
}

/** The run of cells about the origin that nine sections in ten reach. */
std::pair<std::size_t, std::size_t>
SectionRounds::coveredCells(const std::vector<SectionShift>& shifts) const
{
  const std::size_t cells = profile_.line.size();
  std::vector<std::size_t> have(cells, 0);
  std::size_t found = 0;
  for (const SectionShift& shift : shifts)
    if (shift.found) {
      ++found;
      const auto has = [](std::uint32_t count) { return count > 0; };
      const auto first = std::find_if(shift.count.begin(), shift.count.end(), has) - shift.count.begin();
      const auto last = shift.count.rend() - std::find_if(shift.count.rbegin(), shift.count.rend(), has);
      for (auto k = first; k < last; ++k)
        ++have[static_cast<std::size_t>(k)];
    }
  const std::size_t origin = profile_.line.nearestStation(Vector3d::Zero(), 1e30);
  const double at = profile_.line.s(origin);
  const auto goes = [&](std::size_t k) {
    return 10 * have[k] >= 9 * found && std::abs(profile_.line.s(k) - at) <= settings_.half_width + 0.5 * profile_.line.step();
  };
  std::size_t first = origin, last = origin;
  while (first > 0 && goes(first - 1))
    --first;
  while (last + 1 < cells && goes(last + 1))
    ++last;
  return {first, last};
}

/** The place of the origin on the new generator: its nearest place, moved back by the common shift of all sections. Otherwise the rail
 *  would slide along a generator that every round smooths a little. */
Vector3d
SectionRounds::gaugeOf(const std::vector<SectionShift>& shifts, const Polyline& generator) const
{
  if (rounds_ <= rounds_of_ends) {
    const SmoothLine mean = fitLine({generator, false, 0.0}).line;
    return mean.position(mean.nearest(Vector3d::Zero()));
  }
  Vector3d sum = Vector3d::Zero();
  double found = 0.0;
  for (const SectionShift& shift : shifts)
    if (shift.found) {
      sum -= shift.shift;
      found += 1.0;
    }
  return found > 0.0 ? Vector3d(sum / found) : sum;
}

/** The mean of the shifted sections, relative to \p gauge, its new origin. */
bool
SectionRounds::meanSection(const std::vector<SectionShift>& shifts, Polyline& points, Vector3d& gauge)
{
  constexpr std::size_t fewest_cells = 6;
  if (rounds_ <= rounds_of_ends)
    std::tie(first_cell_, last_cell_) = coveredCells(shifts);
  else
    std::tie(first_cell_, last_cell_) = std::pair(extra_cells, profile_.line.size() - 1 - extra_cells);
  if (last_cell_ < first_cell_ + fewest_cells)
    return false;
  for (std::size_t k = first_cell_; k <= last_cell_; ++k) {
    double sum = 0.0, weights = 0.0;
    for (const SectionShift& shift : shifts)
      if (shift.found) {
        sum += shift.count[k] * static_cast<double>(shift.mean[k]);
        weights += shift.count[k];
      }
    const Vector3d& along = profile_.line.tangent(k);
    points.push_back(profile_.line.position(k) + (weights > 0.0 ? sum / weights : 0.0) * Vector3d(0.0, -along.z(), along.y()));
  }
  gauge = gaugeOf(shifts, points);
  for (Vector3d& p : points)
    p -= gauge;
  return true;
}

/** Rms move of the rail's stations since \p before, in its frames, without the common move of all stations: that belongs to the generator
 *  and does not change the ridge. */
double
SectionRounds::moveSince(const SmoothLine& before) const
{
  const StationLine stations(band_.rail, length_);
  Vector3d sum = Vector3d::Zero();
  double squares = 0.0;
  std::uint32_t station = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const Vector3d p = before.position(stationOf(i));
    const RidgeFrame frame = ridgeFrame(before.tangent(stationOf(i)), band_.chord).value_or(RidgeFrame());
    const Vector3d move = frame.localOf(stations.foot(p, station).position - p);
    sum += move;
    squares += move.squaredNorm();
  }
  const auto n = static_cast<double>(count_);
  return std::sqrt(std::max(0.0, squares / n - sum.squaredNorm() / (n * n)));
}

/** Move the end stations half way to the places extrapolated from the stations before them, in their planes. */
void
SectionRounds::carryEndsOn(const std::vector<RidgeFrame>& frames, Polyline& origins) const
{
  const std::size_t last = origins.size() - 1;
  for (const bool first : {true, false}) {
    const std::size_t end = first ? 0 : last;
    Vector3d p = Vector3d::Zero();
    for (std::size_t k = 0; k < carry_on.size(); ++k)
      p += carry_on[k] * origins[first ? k + 1 : last - k - 1];
    p -= (p - origins[end]).dot(frames[end].tangent) * frames[end].tangent;
    origins[end] = 0.5 * (origins[end] + p);
  }
}

Status
SectionRounds::moveRail(const std::vector<SectionShift>& shifts, const Vector3d& gauge)
{
  const bool closed = band_.rail.closed();
  std::vector<SectionShift> all;
  if (const std::optional<std::size_t> missing = allShifts(shifts, closed, all))
    return {StatusCode::InvalidInput,
            Diagnostic("the band of the ridge has too few points of the scan, or no bend, at ",
                       Place(band_.rail.position(stationOf(*missing))),
                       ": choose rough points where the ridge was scanned, or a larger half width ({setHalfWidth})")};
  std::vector<RidgeFrame> frames;
  for (std::size_t i = 0; i < count_; ++i)
    frames.push_back(ridgeFrame(band_.rail.tangent(stationOf(i)), band_.chord).value_or(RidgeFrame()));
  const Polyline steps = railSteps(all, frames, band_.chord.reference, length_, closed);
  MeasuredLine origins;
  origins.closed = closed;
  for (std::size_t i = 0; i < count_; ++i)
    origins.points.push_back(band_.rail.position(stationOf(i)) + frames[i].turned(steps[i] + gauge));
  if (!closed)
    carryEndsOn(frames, origins.points);
  const SmoothLine before = band_.rail;
  const LineFit fit = fitLine(origins, held_error_);
  band_.rail = fit.line;
  if (rounds_ > rounds_of_ends)
    held_error_ = std::max(held_error_, held_share * fit.error);
  last_move_ = moveSince(before);
  return Status::success();
}

Status
SectionRounds::round()
{
  if (const Status status = place(); !status.ok())
    return status;
  const std::vector<SectionShift> found = shifts(10);
  still_ = stillness(found);
  Polyline generator;
  Vector3d gauge;
  if (!meanSection(found, generator, gauge))
    return {StatusCode::InvalidInput, Diagnostic("the sections at ", Place(band_.rail.position(0.5 * band_.rail.length())),
                                                 " have no common part about the crest: is the whole band of the ridge on the scan?")};
  if (const Status status = moveRail(found, gauge); !status.ok())
    return status;
  setGenerator(generator);
  return Status::success();
}

/** A rail that moves by less than this has converged. */
double
SectionRounds::stillness(const std::vector<SectionShift>& shifts) const
{
  constexpr double of_error = 0.3, of_misfit = 0.2; // of the standard error of a section's shift; of the misfit that no shift removes
  double squares = 0.0, points = 0.0;
  for (const SectionShift& shift : shifts) {
    squares += shift.squares;
    points += static_cast<double>(shift.points);
  }
  const double noise = settings_.noise, variance = points > 0.0 ? squares / points : 0.0;
  const double error = noise / std::sqrt(std::max(1.0, points / static_cast<double>(count_)));
  const double misfit = std::sqrt(std::max(0.0, variance - noise * noise * (1.0 + 4.0 / std::sqrt(std::max(1.0, points)))));
  return std::max({of_error * error, of_misfit * misfit, 1e-5 * settings_.half_width});
}

Status
SectionRounds::run(const ProgressCallback& progress)
{
  for (rounds_ = 1; rounds_ <= settings_.most_rounds; ++rounds_) {
    if (progress && !progress(static_cast<double>(rounds_) / (settings_.most_rounds + 1), "sections"))
      return {StatusCode::Cancelled, "cancelled"};
    if (const Status status = round(); !status.ok())
      return status;
    if (last_move_ < still_ && rounds_ > rounds_of_ends)
      return place();
  }
  return {StatusCode::InvalidInput,
          Diagnostic("after ", settings_.most_rounds, " rounds the rail at ", Place(band_.rail.position(0.5 * band_.rail.length())),
                     " still moves by ", last_move_, " {mm} a round, more than the limit of ", still_,
                     " {mm}: the sections have no common shape; "
                     "set a smaller half width ({setHalfWidth}), use a part of the ridge, or allow more rounds ({setMaximumIterations})")};
}

} // namespace pcl_spiral
