// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/radial_lines_engine.h>

#include "line_rounds.h"
#include "surface_centre.h"

#include <pcl_spiral/core/diagnostic.h>

#include "core/angle_between.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double largest_jump = 1.0; // spacings between a line and what its neighbours predict
constexpr double clear_of_rim = 3.0; // spacings: if no lines are found, a centre closer to the rim is the cause
constexpr double narrowest = 1.5;    // spacings from the middle of a surface to its rim: at most three points across

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

/** Share of a turn of each line: the mean of its share of the rim and its share of the angle at the centre, so that
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
    angle.push_back(angle.back() + angleBetween(a, b));
  }
  for (std::size_t i = 0; i < n; ++i)
    lines[i].turn_share = request.inner ? lines[i].rim_share : 0.5 * (lines[i].rim_share + angle[i] / angle.back());
}

/** The inner loop as the lines meet it: it begins at the first line and runs as the rim does. */
void
setInner(const BoundaryLoop& given, RadialLineSet& set)
{
  BoundaryLoop inner = given;
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

/** Lines by one method, checked. */
Status
linesByMethod(const RadialLineRequest& request, const SurfaceCentre& found, bool harmonic, RadialLineSet& set)
{
  const double spacing = request.surface.graph().spacing();
  const RimCurve rim(request.rim, startOnRim(request, found.position));
  LineSource source(request, found, harmonic);
  if (const Status status = source.prepare(); !status.ok())
    return status;
  LineRounds rounds(request, rim, source);
  if (const Status status = rounds.run(); !status.ok())
    return status;
  if (!harmonic && rounds.jump() > largest_jump * spacing) // behind a hill the shortest way jumps from one side to the other
    return {StatusCode::Failed, Diagnostic("neighbouring radial lines jump by ", rounds.jump(), " {mm} near ", Place(rounds.jumpPlace()))};
  // Harmonic lines converge into narrow tips, closer than they are known; turns there leave most of them out.
  if (const auto place = crossing(rounds.lines(), (harmonic ? 0.5 : 0.05) * spacing))
    return {StatusCode::Failed, Diagnostic("radial lines cross at ", Place(*place))};
  shareOutTurns(request, rounds.lines());
  set.lines = std::move(rounds.lines());
  set.centre = found.position;
  set.centre_settled = found.settled;
  set.harmonic = harmonic;
  set.rim = rim.points();
  set.rim_corners = rim.corners();
  set.largest_interpolation_error = rounds.largestError();
  if (request.inner)
    setInner(*request.inner, set);
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

/** A setting is only the cause if the centre was given. */
StatusCode
blame(const RadialLineRequest& request, StatusCode code)
{
  return code == StatusCode::InvalidArgument && !request.centre ? StatusCode::Failed : code;
}

/** Geodesics; if coarse starts fail, finer starts are used. */
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
      return {StatusCode::Failed, Diagnostic("the centre ", Place(centre.position), " does not lie on the surface")};
    const Status status = linesByMethod(request, centre, false, set);
    if (status.ok() || status.code() == StatusCode::Cancelled || centre.lines->usesEveryPoint())
      return status;
    centre.lines->useEveryPoint();
  }
}

/** The error for a given centre that is not on the surface. */
Status
offSurface(const RadialLineRequest& request)
{
  const SurfaceGraph& graph = request.surface.graph();
  const Eigen::Vector3d nearest = graph.position(graph.blocks().nearest(*request.centre));
  return {StatusCode::InvalidArgument,
          Diagnostic("the centre ", Place(*request.centre), " does not lie on the surface, whose nearest point is ", Place(nearest), ", ",
                     (nearest - *request.centre).norm(), " {mm} away: give a point within three spacings (", 3.0 * graph.spacing(),
                     " {mm}) of the {cloud}, inside its rim and outside its holes, or no centre")};
}

/** Refuse a given centre less than \p least spacings from the rim; without one, the surface is too narrow for a centre. */
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
            Diagnostic("the centre ", Place(*request.centre), " lies ", clear, " {mm} from the rim, less than three spacings (",
                       least * spacing, " {mm}): radial lines cannot run all round it; move it inwards, or give no centre")};
  return {StatusCode::InvalidInput,
          Diagnostic("the surface is too narrow for the spacing of its points: its middle ", Place(centre), " lies only ", clear,
                     " {mm} from the rim, and the points lie ", spacing,
                     " {mm} apart: {scan more densely}, with at least seven points across, or machine the part in another way")};
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
    set.why_harmonic = status.diagnostic();
    if (request.method == LineMethod::Geodesic)
      return {blame(request, status.code()), status.diagnostic() + "; harmonic lines work on such outlines"};
  }
  if (!centre)
    return {StatusCode::Failed, "no centre was found on the surface: give one"};
  const Status status = linesByMethod(request, *centre, true, set);
  if (!status.ok() && status.code() != StatusCode::Cancelled)
    if (const Status clearance = checkClearance(request, centre->position, clear_of_rim); !clearance.ok())
      return clearance;
  if (status.ok() || set.why_harmonic.empty() || status.code() == StatusCode::Cancelled)
    return {blame(request, status.code()), status.diagnostic()};
  return {blame(request, status.code()), "no radial lines were found: as geodesics, " + set.why_harmonic + "; as harmonic lines, " +
                                             status.diagnostic() + "; " +
                                             (request.inner ? "" : "give a centre from which the rim is easier to reach, or ") +
                                             "choose constant scallop height ({setMethod})"};
}

} // namespace pcl_spiral
