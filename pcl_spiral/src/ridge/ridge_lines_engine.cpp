// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/ridge/impl/ridge_lines_engine.h>

#include "crest_sections.h"
#include "ridge_misfit.h"
#include "section_rounds.h"

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** Finds the lines from rough points. */
class ScanSearch {
public:
  ScanSearch(const Surface& surface, const ScanRidgeSettings& settings, ScanRidge& result)
  : surface_(surface), settings_(settings), result_(result), report_(result.report)
  {}

  Status run(const ProgressCallback& progress)
  {
    report_.noise = surface_.noise();
    if (progress && !progress(0.0, "crest"))
      return {StatusCode::Cancelled, "cancelled"};
    if (const Status status = findCrest(surface_, settings_, crest_); !status.ok())
      return status;
    report_.crest = crest_.places;
    SectionBand band;
    SmoothLine generator;
    if (const Status status = firstLines(band, generator); !status.ok())
      return status;
    SectionRounds rounds({report_.noise, surface_.spacing(), settings_.half_width, settings_.most_rounds}, std::move(band), generator);
    if (const Status status = rounds.run(partOf(progress, 0.3, 1.0)); !status.ok())
      return status;
    return finish(rounds);
  }

private:
  Status firstLines(SectionBand& band, SmoothLine& generator);
  Status finish(SectionRounds& rounds);
  Status makeRidge(const SectionRounds& rounds);
  void warnOfReach();

  const Surface& surface_;
  const ScanRidgeSettings& settings_;
  ScanRidge& result_;
  ScanRidgeReport& report_;
  CrestSections crest_;
};

/** The crest, and the section in the middle. */
Status
ScanSearch::firstLines(SectionBand& band, SmoothLine& generator)
{
  band.rail = crest_.line;
  const double u = meeting_share * crest_.line.length();
  const Vector3d tangent = crest_.line.tangent(u), origin = crest_.line.position(u);
  const std::size_t n = crest_.sections.size();
  const auto section = std::min(n - 1, static_cast<std::size_t>(meeting_share * static_cast<double>(settings_.closed ? n : n - 1) + 0.5));
  std::size_t worst = 0;
  const int right = std::min(commonReach(crest_.sections, -1, worst), crest_.sections.reach(section, -1)),
            left = std::min(commonReach(crest_.sections, 1, worst), crest_.sections.reach(section, 1));
  Vector3d chord = crest_.sections.foot(section, left).position - crest_.sections.foot(section, -right).position;
  chord = (chord - chord.dot(tangent) * tangent).normalized();
  band.chord = ridgeChord(tangent, chord, settings_.reference.normalized());
  const std::optional<RidgeFrame> frame = ridgeFrame(tangent, band.chord);
  if (!frame)
    return {StatusCode::InvalidInput,
            Diagnostic("the ridge at ", Place(origin),
                       " and its section there have the same slope to the reference plane, so no frame is possible: "
                       "set a reference normal across the ridge ({setReferenceNormal})")};
  Polyline points;
  for (int k = -right; k <= left; ++k)
    points.push_back(frame->localOf(crest_.sections.foot(section, k).position - origin).cwiseProduct(Vector3d(0.0, 1.0, 1.0)));
  generator = fitLine({points, false, 0.0}).line;
  const StationLine stations(band.rail, std::max(surface_.spacing(), 0.1 * settings_.half_width));
  band.points = bandPoints(surface_, stations, 1.3 * settings_.half_width);
  return Status::success();
}

void
ScanSearch::warnOfReach()
{
  constexpr double short_share = 0.1, spacings = 3.0; // of the half width, of the scan
  const double least = std::min(report_.reach_left, report_.reach_right);
  if (least < settings_.half_width - std::max(short_share * settings_.half_width, spacings * surface_.spacing()))
    report_.warnings.push_back(Diagnostic("the generator reaches ", report_.reach_left, " and ", report_.reach_right,
                                          " {mm} to its two sides, because the scan ends there; the half width is ", settings_.half_width,
                                          " {mm} ({setHalfWidth})"));
}

/** Make the ridge from points of both lines; up is the outer side of the scan. */
Status
ScanSearch::makeRidge(const SectionRounds& rounds)
{
  constexpr double most_points = 4000.0, fewest_points = 40.0;
  const double spacing = settings_.point_spacing > 0.0 ? settings_.point_spacing : 2.0 * surface_.spacing();
  const SmoothLine &rail = rounds.rail(), &generator = rounds.generator();
  const auto pieces = [&](double whole) { return static_cast<int>(std::clamp(std::ceil(whole / spacing), fewest_points, most_points)); };
  const int along = pieces(rail.length()), across = pieces(generator.length());
  for (int i = 0; i < along + (rail.closed() ? 0 : 1); ++i)
    result_.rail.push_back(rail.position(rail.length() * i / along));
  const double u = meeting_share * rail.length();
  const RidgeFrame frame = ridgeFrame(rail.tangent(u), rounds.chord()).value_or(RidgeFrame());
  for (int i = 0; i <= across; ++i)
    result_.generator.push_back(rail.position(u) + frame.turned(generator.position(generator.length() * i / across)));
  RidgeSettings settings;
  settings.reference = settings_.reference;
  for (const bool flip : {false, true}) {
    settings.flip = flip;
    if (const Status status = RidgeSurface::make(result_.rail, result_.generator, settings, result_.ridge); !status.ok())
      return status;
    const RidgeSurface& ridge = *result_.ridge;
    if (ridge.normal(ridge.report().meeting, 0.5 * ridge.generator().length()).dot(frame.up) > 0.0)
      break;
  }
  return Status::success();
}

Status
ScanSearch::finish(SectionRounds& rounds)
{
  report_.rounds = rounds.rounds();
  report_.last_move = rounds.lastMove();
  report_.sections = rounds.sections();
  const double origin = rounds.generator().nearest(Vector3d::Zero());
  report_.reach_right = origin;
  report_.reach_left = rounds.generator().length() - origin;
  const StationLine stations(rounds.rail(), surface_.spacing());
  double squares = 0.0;
  std::size_t count = 0;
  for (const Vector3d& p : report_.crest) {
    std::uint32_t station = stations.nearestStation(p, 1e30);
    const LineFoot foot = stations.foot(p, station);
    if (const auto frame = ridgeFrame(foot.tangent, rounds.chord()); foot.inside && frame) {
      squares += std::pow(frame->localOf(p - foot.position).y(), 2);
      ++count;
    }
  }
  report_.crest_wander = count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
  warnOfReach();
  findMisfit(rounds, settings_.half_width, report_);
  return makeRidge(rounds);
}

} // namespace

Status
checkScanRidgeSettings(const ScanRidgeSettings& settings)
{
  const std::size_t least = settings.closed ? 3 : 2;
  if (settings.rough_points.size() < least)
    return {StatusCode::InvalidInput, Diagnostic("there are ", settings.rough_points.size(), " rough points; ",
                                                 settings.closed ? "a closed ridge needs three" : "a ridge needs two",
                                                 " or more: give places on it in their order along it ({setRoughPoints})")};
  for (std::size_t i = 0; i < settings.rough_points.size(); ++i) {
    if (!settings.rough_points[i].allFinite())
      return {StatusCode::InvalidInput, Diagnostic("rough point ", i, " is not finite: remove it ({setRoughPoints})")};
    const std::size_t before = i > 0 ? i - 1 : settings.rough_points.size() - 1;
    if ((i > 0 || settings.closed) && settings.rough_points[i] == settings.rough_points[before])
      return {StatusCode::InvalidInput, Diagnostic("rough points ", before, " and ", i, " are both at ", Place(settings.rough_points[i]),
                                                   ": remove one of them ({setRoughPoints})")};
  }
  if (!(settings.half_width > 0.0) || !std::isfinite(settings.half_width))
    return {StatusCode::InvalidArgument,
            Diagnostic("the half width is ", settings.half_width,
                       " {mm}: set how far the generator reaches to either side of the crest ({setHalfWidth})")};
  if (!settings.reference.allFinite() || !(settings.reference.norm() > 0.0))
    return {StatusCode::InvalidArgument, "the reference normal has no direction: set a vector such as (0, 0, 1) ({setReferenceNormal})"};
  if (!(settings.point_spacing >= 0.0) || !std::isfinite(settings.point_spacing))
    return {StatusCode::InvalidArgument, Diagnostic("the point spacing is ", settings.point_spacing,
                                                    " {mm}: set it above 0, or 0 for twice that of the scan ({setPointSpacing})")};
  if (settings.most_rounds < 1)
    return {StatusCode::InvalidArgument,
            Diagnostic("the limit of rounds is ", settings.most_rounds, ": set 1 or more ({setMaximumIterations})")};
  return Status::success();
}

Status
findScanRidge(const Surface& surface, const ScanRidgeSettings& settings, const ProgressCallback& progress, ScanRidge& result)
{
  result = ScanRidge();
  if (const Status status = checkScanRidgeSettings(settings); !status.ok())
    return status;
  const Status status = ScanSearch(surface, settings, result).run(progress);
  if (!status.ok())
    result = ScanRidge();
  return status;
}

} // namespace pcl_spiral
