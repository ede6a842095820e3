// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/radial_lines_engine.h>

#include "surface_centre.h"
#include <pcl_spiral/common/impl/message.h>

#include "line_gaps.h"
#include "line_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr int most_rounds = 7;               // of halving the gaps between lines
constexpr double closest_in_spacings = 0.75; // lines at the rim
constexpr double largest_jump = 1.0;         // spacings between a line and what its neighbours foretell
constexpr double clear_of_rim = 3.0;         // spacings: a centre closer to it is to blame where no lines are found
constexpr double narrowest = 1.5;            // spacings from the middle of a surface to its rim: three points across or fewer
constexpr double foreseeable = 0.5;          // spacings it may have been off in a gap twice as wide to start from that

/** Where line 0 ends: nearest to the user's point; else the corner, else the rim point, farthest from \p centre. */
Eigen::Vector3d
startOnRim(const RadialLineRequest& request, const Eigen::Vector3d& centre)
{
  if (request.start_point)
    return *request.start_point;
  const BoundaryLoop& rim = request.rim;
  Polyline choices;
  for (const std::size_t k : rim.corners)
    choices.push_back(rim.curve[k]);
  if (choices.empty())
    choices = rim.curve;
  return *std::max_element(choices.begin(), choices.end(),
                           [&](const auto& a, const auto& b) { return (a - centre).squaredNorm() < (b - centre).squaredNorm(); });
}

/** Where neighbouring lines change sides, if anywhere. */
std::optional<Eigen::Vector3d>
crossing(const std::vector<RadialLine>& lines, double slack)
{
  const std::size_t n = lines.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto &a = lines[i].feet, &b = lines[(i + 1) % n].feet;
    for (std::size_t k = 1; k + 1 < a.size(); ++k) {
      const Eigen::Vector3d left = a[k].normal.cross((a[k + 1].position - a[k - 1].position).normalized());
      if ((b[k].position - a[k].position).dot(left) < -slack)
        return a[k].position;
    }
  }
  return std::nullopt;
}

/** How far each line is round a turn: on the mean of its shares of the rim and of the whole angle at the centre, so that
 *  turns advance evenly about the centre too when a far tip takes most of the rim; of the rim alone without a centre. */
void
shareOutTurns(const RadialLineRequest& request, std::vector<RadialLine>& lines)
{
  constexpr double reach = 3.0; // spacings from the centre, where lines have spread
  std::vector<double> angle(1, 0.0);
  const std::size_t n = lines.size();
  const auto direction = [&](std::size_t i) {
    const RadialLine& line = lines[i % n];
    const double s = std::min(reach * request.surface.graph().spacing(), 0.25 * line.length());
    return Eigen::Vector3d(line.curve.positionAt(s) - line.curve.positionAt(0.0));
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d a = direction(i), b = direction(i + 1);
    angle.push_back(angle.back() + std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  for (std::size_t i = 0; i < n; ++i)
    lines[i].turn_share = request.inner ? lines[i].rim_share : 0.5 * (lines[i].rim_share + angle[i] / angle.back());
}

/** Coarse lines, then halved gaps, by one method. */
Status
linesByMethod(const RadialLineRequest& request, const SurfaceCentre& found, bool harmonic, RadialLineSet& set)
{
  const Eigen::Vector3d& centre = found.position;
  const double spacing = request.surface.graph().spacing();
  const RimCurve rim(request.rim, startOnRim(request, centre));
  LineSource source(request, found, harmonic);
  if (const Status status = source.prepare(); !status.ok())
    return status;
  std::vector<Place> places = coarsePlaces(rim);
  const auto make = [&](const std::vector<Place>& wanted, std::vector<Polyline> guesses, std::vector<RadialLine>& lines) {
    Polyline ends;
    for (const Place& place : wanted)
      ends.push_back(rim.at(place.s));
    const Status status = source.make(ends, std::move(guesses), lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      lines[i].rim_share = wanted[i].s / rim.length();
      lines[i].corner = wanted[i].corner;
      lines[i].level = wanted[i].level;
    }
    return status;
  };
  std::vector<RadialLine> lines;
  if (const Status status = make(places, {}, lines); !status.ok())
    return status;

  // Halved, a gap of smooth lines is foretold at least four times better.
  const double settled = (source.takesGuesses() ? 4.0 : 1.0) * request.tolerance;
  double worst = 0.0, jump = 0.0;
  Eigen::Vector3d jump_place = centre;
  for (int round = 1;; ++round) {
    if (request.progress && !request.progress(static_cast<double>(round) / (most_rounds + 1)))
      return {StatusCode::Cancelled, "cancelled"};
    std::vector<Place> wanted;
    std::vector<Polyline> guesses;
    std::vector<std::size_t> gaps;
    worst = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const LineGap gap(places, rim, i);
      const double rim_error = gap.rimError(rim);
      worst = std::max({worst, rim_error, places[i].misfit / 16.0});
      if ((places[i].misfit <= settled && rim_error <= request.tolerance) || gap.width() < 2.0 * closest_in_spacings * spacing)
        continue;
      wanted.push_back({gap.middle(), false, round});
      gaps.push_back(i);
      guesses.emplace_back();
      if (source.takesGuesses() && places[i].surprise < foreseeable * spacing)
        guesses.back() = gap.foretold(lines, rim);
    }
    if (wanted.empty() || round > most_rounds)
      break;
    std::vector<RadialLine> added;
    if (const Status status = make(wanted, std::move(guesses), added); !status.ok())
      return status;
    jump = 0.0;
    for (std::size_t a = 0; a < wanted.size(); ++a) {
      wanted[a].surprise = LineGap(places, rim, gaps[a]).surprise(lines, added[a], wanted[a].misfit);
      if (wanted[a].surprise > jump) {
        jump = wanted[a].surprise;
        jump_place = added[a].feet[added[a].feet.size() / 2].position;
      }
    }
    std::vector<Place> all_places;
    std::vector<RadialLine> all_lines;
    for (std::size_t i = 0, a = 0; i < places.size(); ++i) {
      all_places.push_back(places[i]);
      all_lines.push_back(std::move(lines[i]));
      if (a == gaps.size() || gaps[a] != i)
        continue;
      all_places.back().misfit = wanted[a].misfit;
      all_places.back().surprise = wanted[a].surprise;
      all_places.push_back(wanted[a]);
      all_lines.push_back(std::move(added[a++]));
    }
    places.swap(all_places);
    lines.swap(all_lines);
  }
  if (!harmonic && jump > largest_jump * spacing) // behind a hill the shortest way jumps from one side to the other
    return {StatusCode::Failed, textOf("neighbouring radial lines jump by ", jump, " mm about ", placeText(jump_place))};
  // Harmonic lines converge into narrow tips, closer than they are known; turns there leave most of them out.
  if (const auto place = crossing(lines, (harmonic ? 0.5 : 0.05) * spacing))
    return {StatusCode::Failed, textOf("radial lines cross at ", placeText(*place))};
  shareOutTurns(request, lines);
  set.lines = std::move(lines);
  set.centre = centre;
  set.centre_settled = found.settled;
  set.harmonic = harmonic;
  set.rim = rim.points();
  set.rim_corners = rim.corners();
  set.largest_interpolation_error = worst;
  if (request.inner) {
    BoundaryLoop inner = *request.inner;
    const Eigen::Vector3d first = set.lines[0].feet.front().position;
    // The inner loop has the surface on its left too, so it runs against the rim: turn it round.
    std::reverse(inner.curve.begin(), inner.curve.end());
    for (std::size_t& k : inner.corners)
      k = inner.curve.size() - 1 - k;
    const RimCurve curve(inner, first);
    set.inner = curve.points();
    set.inner_corners = curve.corners();
    set.inner.front() = first;
  }
  return Status::success();
}

Eigen::Vector3d
meanOf(const Polyline& line)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : line)
    sum += p;
  return sum / static_cast<double>(line.size());
}

/** A setting is only to blame where the centre is one. */
StatusCode
blame(const RadialLineRequest& request, StatusCode code)
{
  return code == StatusCode::InvalidArgument && !request.centre ? StatusCode::Failed : code;
}

/** Geodesics, whose starts are refined where coarse ones fail. */
Status
geodesicLines(const RadialLineRequest& request, SurfaceCentre& centre, RadialLineSet& set)
{
  if (request.inner)
    return linesByMethod(request, centre, false, set);
  bool ready = centre.lines.has_value(); // not of a centre that was given
  if (!ready)
    centre.lines.emplace(request.surface.graph());
  for (;; ready = false) {
    if (!ready && !centre.lines->setCentre(centre.position))
      return {StatusCode::Failed, textOf("the centre ", placeText(centre.position), " does not lie on the surface")};
    const Status status = linesByMethod(request, centre, false, set);
    if (status.ok() || status.code() == StatusCode::Cancelled || centre.lines->usesEveryPoint())
      return status;
    centre.lines->useEveryPoint();
  }
}

/** The centre given is off the surface. */
Status
offSurface(const RadialLineRequest& request)
{
  const SurfaceGraph& graph = request.surface.graph();
  const Eigen::Vector3d nearest = graph.position(graph.blocks().nearest(*request.centre));
  return {StatusCode::InvalidArgument,
          textOf("the centre ", placeText(*request.centre), " does not lie on the surface, whose nearest point is ", placeText(nearest),
                 ", ", (nearest - *request.centre).norm(), " mm off: give a point within three spacings (", 3.0 * graph.spacing(),
                 " mm) of the cloud, inside its rim and out of its holes, or none")};
}

/** Refuse a centre less than \p least spacings from the rim, or the surface too narrow for one clear of it. */
Status
checkClearance(const RadialLineRequest& request, const Eigen::Vector3d& centre, double least)
{
  const double spacing = request.surface.graph().spacing();
  double clear = std::numeric_limits<double>::max();
  for (const Eigen::Vector3d& p : request.rim.curve)
    clear = std::min(clear, (p - centre).norm());
  if (request.inner || clear >= least * spacing)
    return Status::success();
  if (request.centre)
    return {StatusCode::InvalidArgument,
            textOf("the centre ", placeText(*request.centre), " lies ", clear, " mm from the rim, less than three spacings (",
                   least * spacing, " mm): radial lines cannot lead round it; move it inwards, or leave it out")};
  return {StatusCode::InvalidInput,
          textOf("the surface is too narrow for its points: its middle ", placeText(centre), " lies only ", clear,
                 " mm from the rim, and points lie ", spacing,
                 " mm apart: scan more densely, for at least seven points across, or machine the part by other means")};
}

} // namespace

Status
buildRadialLines(const RadialLineRequest& request, RadialLineSet& set)
{
  std::optional<SurfaceCentre> centre;
  if (request.inner)
    centre = SurfaceCentre{meanOf(request.inner->curve), std::nullopt, true};
  else if (request.centre) {
    const SurfaceFoot foot = request.surface.project(*request.centre);
    if (!foot.valid)
      return offSurface(request);
    centre = SurfaceCentre{foot.position, std::nullopt, true};
  }
  else
    centre = balancedCentre(request.surface, request.rim.curve);
  if (centre && !request.centre && !request.inner)
    if (const Status clearance = checkClearance(request, centre->position, narrowest); !clearance.ok())
      return clearance;

  if (request.method != LineMethod::Harmonic && centre) {
    const Status status = geodesicLines(request, *centre, set);
    if (status.ok() || status.code() == StatusCode::Cancelled)
      return status;
    set.why_harmonic = status.message();
    if (request.method == LineMethod::Geodesic)
      return {blame(request, status.code()), status.message() + "; harmonic lines cope with such outlines"};
  }
  if (!centre)
    return {StatusCode::Failed, "no centre was found on the surface: give one"};
  const Status status = linesByMethod(request, *centre, true, set);
  if (!status.ok() && status.code() != StatusCode::Cancelled)
    if (const Status clearance = checkClearance(request, centre->position, clear_of_rim); !clearance.ok())
      return clearance;
  if (status.ok() || set.why_harmonic.empty() || status.code() == StatusCode::Cancelled)
    return {blame(request, status.code()), status.message()};
  return {blame(request, status.code()), "no radial lines were found: as geodesics, " + set.why_harmonic + "; as harmonic lines, " +
                                             status.message() +
                                             "; give a centre from which the rim is easier to reach, or machine the part in pieces"};
}

} // namespace pcl_spiral
