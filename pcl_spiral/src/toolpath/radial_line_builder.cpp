#include <pcl_spiral/toolpath/radial_line_builder.h>

#include <pcl_spiral/toolpath/surface_centre.h>

#include "line_source.h"
#include "rim_curve.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pcl_spiral {
namespace {

constexpr int coarse_lines = 32;
constexpr int most_rounds = 7;            // of halving the gaps between lines
constexpr double closest_in_spacings = 0.75; // lines at the rim
constexpr double largest_jump = 1.0;      // spacings between a line and what its neighbours foretell

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
  return *std::max_element(choices.begin(), choices.end(), [&](const auto& a, const auto& b) {
    return (a - centre).squaredNorm() < (b - centre).squaredNorm();
  });
}

/** A planned line: its place on the rim. */
struct Place {
  double s; ///< arc length on the rim
  bool corner;
  int level;
};

/** Corners, and between them places at equal distances, about coarse_lines in all. */
std::vector<Place>
coarsePlaces(const RimCurve& rim)
{
  std::vector<double> stops{0.0};
  std::vector<bool> is_corner{!rim.corners().empty() && rim.corners()[0] == 0};
  for (const std::size_t k : rim.corners())
    if (k != 0) {
      stops.push_back(rim.arcLengthOf(k));
      is_corner.push_back(true);
    }
  stops.push_back(rim.length());
  std::vector<Place> places;
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    const double span = stops[i + 1] - stops[i];
    const int pieces = std::max(1, static_cast<int>(std::lround(coarse_lines * span / rim.length())));
    for (int p = 0; p < pieces; ++p)
      places.push_back({stops[i] + span * p / pieces, p == 0 && is_corner[i], 0});
  }
  return places;
}

/** Lagrange's cubic (or lower, between corners) through neighbouring lines at a share of their length. */
Eigen::Vector3d
foretold(const std::vector<RadialLine>& lines, const std::vector<std::size_t>& from, const std::vector<double>& s,
         double at, std::size_t station)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t a = 0; a < from.size(); ++a) {
    double weight = 1.0;
    for (std::size_t b = 0; b < from.size(); ++b)
      if (a != b)
        weight *= (at - s[b]) / (s[a] - s[b]);
    sum += weight * lines[from[a]].feet[station].position;
  }
  return sum;
}

/** Largest distance between a new line at rim place \p s and what the lines about gap i foretell. */
double
surprise(const std::vector<RadialLine>& lines, const std::vector<Place>& places, double rim_length, std::size_t i,
         double s, const RadialLine& line)
{
  const std::size_t n = lines.size();
  std::vector<std::size_t> from{i, (i + 1) % n};
  std::vector<double> at{places[i].s, i + 1 < n ? places[i + 1].s : rim_length};
  if (!places[i].corner && n > 3) {
    from.insert(from.begin(), (i + n - 1) % n);
    at.insert(at.begin(), i > 0 ? places[i - 1].s : places[n - 1].s - rim_length);
  }
  if (!places[(i + 1) % n].corner && n > 3) {
    from.push_back((i + 2) % n);
    at.push_back(places[(i + 2) % n].s + (i + 2 >= n ? rim_length : 0.0));
  }
  double largest = 0.0;
  const std::size_t last = line.feet.size() - 1;
  for (const std::size_t station : {last / 4, last / 2, 3 * last / 4, last})
    largest = std::max(largest,
                       (foretold(lines, from, at, s, station) - line.feet[station].position).norm());
  return largest;
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
  const auto make = [&](const std::vector<Place>& wanted, std::vector<RadialLine>& lines) {
    Polyline ends;
    for (const Place& place : wanted)
      ends.push_back(rim.at(place.s));
    const Status status = source.make(ends, lines);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      lines[i].rim_share = wanted[i].s / rim.length();
      lines[i].corner = wanted[i].corner;
      lines[i].level = wanted[i].level;
    }
    return status;
  };
  std::vector<RadialLine> lines;
  if (const Status status = make(places, lines); !status.ok())
    return status;

  std::vector<std::uint8_t> settled(places.size(), 0); // the gap after each line
  double worst = 0.0, jump = 0.0;
  Eigen::Vector3d jump_place = centre;
  for (int round = 1; round <= most_rounds; ++round) {
    if (request.progress && !request.progress(static_cast<double>(round) / (most_rounds + 1)))
      return {StatusCode::Cancelled, "cancelled"};
    std::vector<Place> wanted;
    std::vector<std::size_t> gap;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double next = i + 1 < places.size() ? places[i + 1].s : rim.length();
      if (settled[i] || next - places[i].s < 2.0 * closest_in_spacings * spacing)
        continue;
      wanted.push_back({0.5 * (places[i].s + next), false, round});
      gap.push_back(i);
    }
    if (wanted.empty())
      break;
    std::vector<RadialLine> added;
    if (const Status status = make(wanted, added); !status.ok())
      return status;
    worst = jump = 0.0;
    std::vector<std::uint8_t> gap_settled(places.size(), 0);
    for (std::size_t a = 0; a < wanted.size(); ++a) {
      const double error = surprise(lines, places, rim.length(), gap[a], wanted[a].s, added[a]);
      gap_settled[gap[a]] = error <= request.tolerance;
      worst = std::max(worst, error / 16.0);
      if (error > jump) {
        jump = error;
        jump_place = added[a].feet[added[a].feet.size() / 2].position;
      }
    }
    std::vector<Place> all_places;
    std::vector<RadialLine> all_lines;
    std::vector<std::uint8_t> all_settled;
    for (std::size_t i = 0, a = 0; i < places.size(); ++i) {
      const bool halved = a < gap.size() && gap[a] == i;
      const std::uint8_t done = halved ? gap_settled[i] : 1;
      all_places.push_back(places[i]);
      all_lines.push_back(std::move(lines[i]));
      all_settled.push_back(done);
      if (halved) {
        all_places.push_back(wanted[a]);
        all_lines.push_back(std::move(added[a]));
        all_settled.push_back(done);
        ++a;
      }
    }
    places.swap(all_places);
    lines.swap(all_lines);
    settled.swap(all_settled);
  }
  if (!harmonic && jump > largest_jump * spacing) { // behind a hill the shortest way jumps from one side to the other
    std::ostringstream message;
    message << "neighbouring radial lines jump by " << jump << " mm about (" << jump_place.transpose() << ")";
    return {StatusCode::Failed, message.str()};
  }
  // Harmonic lines converge into narrow tips, closer than they are known; turns there leave most of them out.
  if (const auto place = crossing(lines, (harmonic ? 0.5 : 0.05) * spacing)) {
    std::ostringstream message;
    message << "radial lines cross at (" << place->transpose() << ")";
    return {StatusCode::Failed, message.str()};
  }
  shareOutTurns(request, lines);
  set.lines = std::move(lines);
  set.centre = centre;
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

} // namespace

Status
buildRadialLines(const RadialLineRequest& request, RadialLineSet& set)
{
  std::optional<SurfaceCentre> centre;
  if (request.inner)
    centre = SurfaceCentre{meanOf(request.inner->curve), {}};
  else if (request.centre) {
    const SurfaceFoot foot = request.surface.project(*request.centre);
    if (!foot.valid) {
      std::ostringstream message;
      message << "the centre (" << request.centre->transpose()
              << ") does not lie on the surface: give a point within three spacings ("
              << 3.0 * request.surface.graph().spacing() << " mm) of the cloud, inside its rim, or none";
      return {StatusCode::InvalidArgument, message.str()};
    }
    centre = SurfaceCentre{foot.position, {}};
  }
  else
    centre = balancedCentre(request.surface, request.rim.curve);

  if (request.method != LineMethod::Harmonic && centre) {
    const Status status = linesByMethod(request, *centre, false, set);
    if (status.ok() || status.code() == StatusCode::Cancelled)
      return status;
    set.why_harmonic = status.message();
    if (request.method == LineMethod::Geodesic)
      return {blame(request, status.code()), status.message() + "; harmonic lines cope with such outlines"};
  }
  if (!centre)
    return {StatusCode::Failed, "no centre was found on the surface: give one"};
  const Status status = linesByMethod(request, *centre, true, set);
  if (status.ok() || set.why_harmonic.empty() || status.code() == StatusCode::Cancelled)
    return {blame(request, status.code()), status.message()};
  return {blame(request, status.code()),
          "no radial lines were found: as geodesics, " + set.why_harmonic + "; as harmonic lines, " + status.message() +
              "; give a centre from which the rim is easier to reach, or machine the part in pieces"};
}

} // namespace pcl_spiral
