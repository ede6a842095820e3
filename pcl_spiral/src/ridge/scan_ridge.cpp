#include <pcl_spiral/ridge/scan_ridge.h>

#include "crest_line.h"
#include "ridge_misfit.h"
#include "rough_line.h"
#include "scan_sections.h"
#include "section_rounds.h"

#include <pcl_spiral/common/message.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** Straight fits to \p line within \p reach to either side, at each of its points: the crest of a noisy scan wanders from point to point. */
Polyline
evened(const Polyline& line, double reach, bool closed)
{
  const auto n = static_cast<std::ptrdiff_t>(line.size());
  const auto most = std::min(static_cast<std::ptrdiff_t>(reach * static_cast<double>(n) / length(line, closed)), (n - 1) / 2);
  Polyline result;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const std::ptrdiff_t first = closed ? i - most : std::max<std::ptrdiff_t>(0, i - most), last = closed ? i + most : std::min(n - 1, i + most);
    const double count = static_cast<double>(last - first + 1), middle = 0.5 * static_cast<double>(first + last);
    Vector3d mean = Vector3d::Zero(), rise = Vector3d::Zero();
    double squares = 0.0;
    for (std::ptrdiff_t j = first; j <= last; ++j) {
      const Vector3d& p = line[static_cast<std::size_t>((j + n) % n)];
      const double off = static_cast<double>(j) - middle;
      mean += p / count;
      rise += off * p;
      squares += off * off;
    }
    result.push_back(mean + (squares > 0.0 ? (static_cast<double>(i) - middle) / squares : 0.0) * rise);
  }
  return result;
}

/** From rough points to lines. */
class ScanSearch {
public:
  ScanSearch(const Surface& surface, const ScanRidgeSettings& settings, ScanRidge& result)
  : surface_(surface), settings_(settings), result_(result), report_(result.report)
  {
  }

  Status
  run(const ProgressCallback& progress)
  {
    report_.noise = surface_.noise();
    if (const Status status = checkOnScan(); !status.ok())
      return status;
    if (progress && !progress(0.0, "crest"))
      return {StatusCode::Cancelled, "cancelled"};
    if (const Status status = findCrest(); !status.ok())
      return status;
    RidgeBand band;
    SmoothLine generator;
    if (const Status status = firstLines(band, generator); !status.ok())
      return status;
    SectionRounds rounds({report_.noise, surface_.spacing(), settings_.half_width, settings_.most_rounds}, std::move(band), generator);
    if (const Status status = rounds.run(partOf(progress, 0.3, 1.0)); !status.ok())
      return status;
    return finish(rounds);
  }

private:
  Status checkOnScan() const;
  Status findCrest();
  Status checkSections() const;
  Status firstLines(RidgeBand& band, SmoothLine& generator);
  Status finish(SectionRounds& rounds);
  Status makeRidge(const SectionRounds& rounds);
  void warnOfReach();
  ScanSections walkAbout(const Polyline& line, double reach, Polyline& places);
  /** Steps to where the scan ends on \p side in all but a tenth of the sections; \p worst: a section that reaches no further. */
  int commonReach(int side, std::size_t& worst) const;

  const Surface& surface_;
  const ScanRidgeSettings& settings_;
  ScanRidge& result_;
  ScanRidgeReport& report_;
  SmoothLine crest_line_;
  ScanSections sections_; ///< across it
  Polyline places_, tangents_; ///< of the sections
};

Status
ScanSearch::checkOnScan() const
{
  std::vector<SurfaceFoot> feet;
  const ScanSections found = walkSections(surface_, settings_.rough_points,
                                          Polyline(settings_.rough_points.size(), Vector3d::UnitX()), surface_.spacing(), 0);
  for (std::size_t i = 0; i < settings_.rough_points.size(); ++i)
    if (const double off = (found.foot(i, 0).position - settings_.rough_points[i]).norm(); !(off <= settings_.half_width))
      return {StatusCode::InvalidInput, textOf("rough point ", i, " at ", placeText(settings_.rough_points[i]), " is ", off,
                                               " mm off the scan, more than the half width, ", settings_.half_width,
                                               " mm: give places on the ridge, in the scan's unit (setRoughPoints)")};
  return Status::success();
}

/** Walk sections about \p line, no closer than a few spacings. */
ScanSections
ScanSearch::walkAbout(const Polyline& line, double reach, Polyline& places)
{
  constexpr double steps_across = 24.0, spacings_along = 2.0, most_along = 2000.0;
  const double whole = length(line, settings_.closed);
  const double along = std::clamp(whole / (spacings_along * surface_.spacing()), 16.0, most_along);
  places = resampled(line, static_cast<std::size_t>(along) + 1, settings_.closed);
  tangents_.clear();
  const std::size_t n = places.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = settings_.closed ? (i + n - 1) % n : (i > 0 ? i - 1 : 0), after = settings_.closed ? (i + 1) % n : std::min(i + 1, n - 1);
    tangents_.push_back((places[after] - places[before]).normalized());
  }
  const double step = std::max(surface_.spacing(), reach / steps_across);
  return walkSections(surface_, places, tangents_, step, static_cast<int>(std::ceil(reach / step)));
}

Status
ScanSearch::findCrest()
{
  const double step = std::max(surface_.spacing(), 0.1 * settings_.half_width);
  Polyline line = throughPlaces(settings_.rough_points, settings_.closed, step);
  for (int round = 0; round < 2; ++round) {
    const ScanSections walked = walkAbout(line, settings_.half_width, places_);
    line = crestOf(surface_, walked, settings_.closed);
    if (2 * line.size() < places_.size())
      return {StatusCode::InvalidInput, textOf("the scan ends within a fit of the rough points at ", placeText(places_[places_.size() / 2]),
                                               ": no crest can be told; choose rough points where the ridge was scanned (setRoughPoints)")};
    crest_line_ = fitLine({evened(line, settings_.half_width, settings_.closed), settings_.closed, 0.0}).line;
    line.clear();
    for (std::size_t i = 0; i < places_.size(); ++i)
      line.push_back(crest_line_.position(crest_line_.length() * static_cast<double>(i) /
                                          static_cast<double>(settings_.closed ? places_.size() : places_.size() - 1)));
  }
  report_.crest = line;
  sections_ = walkAbout(line, settings_.half_width, places_);
  return checkSections();
}

int
ScanSearch::commonReach(int side, std::size_t& worst) const
{
  std::vector<std::pair<int, std::size_t>> reach;
  for (std::size_t i = 0; i < sections_.size(); ++i)
    reach.emplace_back(sections_.reach(i, side), i);
  std::sort(reach.begin(), reach.end());
  worst = reach.front().second;
  return reach[reach.size() / 10].first;
}

/** Wide enough, and bent. */
Status
ScanSearch::checkSections() const
{
  constexpr double least_share = 0.2; // of the half width
  constexpr double least_bend = 8.0;  // degrees
  std::size_t worst = 0;
  for (const int side : {-1, 1})
    if (const double reach = sections_.step * commonReach(side, worst); reach < least_share * settings_.half_width)
      return {StatusCode::InvalidInput, textOf("the band of the ridge runs off the scan at ", placeText(places_[worst]), ": on one side it ends ",
                                               sections_.step * sections_.reach(worst, side), " mm from the crest, where ", least_share * settings_.half_width,
                                               " mm are the least for a half width of ", settings_.half_width,
                                               ": choose rough points farther from the rim, or a smaller half width (setHalfWidth)")};
  std::vector<std::pair<double, std::size_t>> bends;
  for (std::size_t i = 0; i < sections_.size(); ++i)
    bends.emplace_back(bendOf(sections_, i, sections_.most, tangents_[i]), i);
  std::sort(bends.begin(), bends.end());
  if (const auto& [bend, where] = bends[bends.size() / 3]; bend < least_bend)
    return {StatusCode::InvalidInput, textOf("there is no crest between the rough points at ", placeText(places_[where]), ": across it the scan bends by ",
                                             bend, " degrees within the half width, and a ridge bends by ", least_bend,
                                             " or more: move the rough points to the ridge (setRoughPoints), take a larger half width "
                                             "(setHalfWidth), or, where it is a hollow, the other side (setFlipNormals)")};
  return Status::success();
}

/** The crest, and the section in the middle. */
Status
ScanSearch::firstLines(RidgeBand& band, SmoothLine& generator)
{
  band.rail = crest_line_;
  const double u = meeting_share * crest_line_.length();
  const Vector3d tangent = crest_line_.tangent(u), origin = crest_line_.position(u);
  const std::size_t n = sections_.size();
  const auto section = std::min(n - 1, static_cast<std::size_t>(meeting_share * static_cast<double>(settings_.closed ? n : n - 1) + 0.5));
  std::size_t worst = 0;
  const int right = std::min(commonReach(-1, worst), sections_.reach(section, -1)), left = std::min(commonReach(1, worst), sections_.reach(section, 1));
  Vector3d chord = sections_.foot(section, left).position - sections_.foot(section, -right).position;
  chord = (chord - chord.dot(tangent) * tangent).normalized();
  band.chord = ridgeChord(tangent, chord, settings_.reference.normalized());
  const std::optional<RidgeFrame> frame = ridgeFrame(tangent, band.chord);
  if (!frame)
    return {StatusCode::InvalidInput, textOf("the ridge at ", placeText(origin), " stands as steeply to the reference plane as its section there: "
                                             "take a reference normal across the ridge (setReferenceNormal)")};
  Polyline points;
  for (int k = -right; k <= left; ++k)
    points.push_back(frame->localOf(sections_.foot(section, k).position - origin).cwiseProduct(Vector3d(0.0, 1.0, 1.0)));
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
    report_.warnings.push_back(textOf("the generator goes ", report_.reach_left, " and ", report_.reach_right, " mm to both sides, for the scan ends there; ",
                                      settings_.half_width, " mm were asked for (setHalfWidth)"));
}

/** Both lines by points; the side that is up is the scan's. */
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
    return {StatusCode::InvalidInput, textOf("there are ", settings.rough_points.size(), " rough points; ", settings.closed ? "a closed ridge takes three" : "a ridge takes two",
                                             " or more: give places on it in their order along it (setRoughPoints)")};
  for (std::size_t i = 0; i < settings.rough_points.size(); ++i) {
    if (!settings.rough_points[i].allFinite())
      return {StatusCode::InvalidInput, textOf("rough point ", i, " is not finite: leave it out (setRoughPoints)")};
    const std::size_t before = i > 0 ? i - 1 : settings.rough_points.size() - 1;
    if ((i > 0 || settings.closed) && settings.rough_points[i] == settings.rough_points[before])
      return {StatusCode::InvalidInput, textOf("rough points ", before, " and ", i, " are both at ", placeText(settings.rough_points[i]),
                                               ": leave one out (setRoughPoints)")};
  }
  if (!(settings.half_width > 0.0) || !std::isfinite(settings.half_width))
    return {StatusCode::InvalidArgument, textOf("the half width is ", settings.half_width,
                                                " mm: say how far the generator goes to either side of the crest (setHalfWidth)")};
  if (!settings.reference.allFinite() || !(settings.reference.norm() > 0.0))
    return {StatusCode::InvalidArgument, "the reference normal has no direction: set a vector such as (0, 0, 1) (setReferenceNormal)"};
  if (!(settings.point_spacing >= 0.0) || !std::isfinite(settings.point_spacing))
    return {StatusCode::InvalidArgument, textOf("the point spacing is ", settings.point_spacing,
                                                " mm: set it above 0, or 0 for twice that of the scan (setPointSpacing)")};
  if (settings.most_rounds < 1)
    return {StatusCode::InvalidArgument, textOf("the most rounds are ", settings.most_rounds, ": set 1 or more (setMaximumIterations)")};
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
