// From the spiral's curve to a path on the surface.
#include <pcl_spiral/toolpath/spiral_planner.h>

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/core/axis_field.h>
#include <pcl_spiral/core/self_crossing.h>
#include <pcl_spiral/core/tool_axis.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double gap_in_spacings = 2.7; // on random points one in 10^9 lies so far from the next
constexpr double slack = 1.05;         // steps stretch a little when put on the surface
constexpr std::size_t chunk = 1u << 16; // path points between progress reports

double
radians(double degrees)
{
  return degrees * M_PI / 180.0;
}

double
degrees(double radians)
{
  return radians * 180.0 / M_PI;
}

} // namespace

Status
SpiralPlanner::putOnSurface(const std::vector<SpiralPoint>& curve, SpiralPath& path)
{
  const double hollowest = -1.0 / settings_.tool_radius;
  path.contacts.resize(curve.size());
  path.normals.resize(curve.size());
  path.turns.resize(curve.size());
  path.over_gap.resize(curve.size());
  std::vector<Eigen::Vector3d> queries;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < curve.size(); begin += chunk) {
    const std::size_t end = std::min(curve.size(), begin + chunk);
    const auto count = static_cast<std::int64_t>(end - begin);
    queries.resize(end - begin);
    for (std::int64_t i = 0; i < count; ++i)
      queries[i] = curve[begin + i].position;
    surface_->project(queries, feet);
    std::int64_t first_bad = count;
#pragma omp parallel for schedule(static) reduction(min : first_bad)
    for (std::int64_t i = 0; i < count; ++i) {
      if (!feet[i].valid || feet[i].curvature2 <= hollowest)
        first_bad = std::min(first_bad, i);
      path.contacts[begin + i] = feet[i].position;
      path.normals[begin + i] = feet[i].normal;
      path.over_gap[begin + i] = isOverGap(feet[i]);
      path.turns[begin + i] = static_cast<float>(curve[begin + i].turn);
    }
    if (first_bad < count) {
      const SurfaceFoot& foot = feet[first_bad];
      const SpiralPoint& asked = curve[begin + first_bad];
      if (!foot.valid)
        return {StatusCode::Failed,
                textOf("the path leaves the scanned surface at ", placeText(asked.position), " in turn ", asked.turn,
                       ": the scan has a gap or a ragged rim there; scan it again, more densely, or cut the ragged part away")};
      return {StatusCode::Failed,
              textOf("the surface is hollow with radius ", -1.0 / foot.curvature2, " mm at ", placeText(foot.position),
                   ", tighter than the tool radius ", settings_.tool_radius,
                   " mm: the cutter would gouge; use a smaller tool")};
    }
    if (!report(0.65 + 0.25 * static_cast<double>(end) / static_cast<double>(curve.size()), "projection"))
      return {StatusCode::Cancelled, "cancelled"};
  }
  halveStretchedSteps(path);
  path.arc_lengths = arcLengths(path.contacts); // serial: a sum whose rounding depends on its order
  return reportGaps(path);
}

/** Steps that projection stretched beyond the longest one get a point in their middle. Those beyond the slack are left for
 *  checkPath to refuse. */
void
SpiralPlanner::halveStretchedSteps(SpiralPath& path)
{
  const double longest = report_.largest_allowed_step;
  std::vector<std::size_t> ends; // of the steps
  std::vector<Eigen::Vector3d> queries;
  for (std::size_t i = 1; i < path.contacts.size(); ++i) {
    const double step = (path.contacts[i] - path.contacts[i - 1]).norm();
    if (step > longest && step <= slack * longest) {
      ends.push_back(i);
      queries.push_back(0.5 * (path.contacts[i] + path.contacts[i - 1]));
    }
  }
  if (ends.empty())
    return;
  std::vector<SurfaceFoot> feet;
  surface_->project(queries, feet);
  SpiralPath halved;
  const auto add = [&halved](const Eigen::Vector3d& contact, const Eigen::Vector3d& normal, float turn, bool over_gap) {
    halved.contacts.push_back(contact);
    halved.normals.push_back(normal);
    halved.turns.push_back(turn);
    halved.over_gap.push_back(over_gap);
  };
  std::size_t next = 0;
  for (std::size_t i = 0; i < path.contacts.size(); ++i) {
    if (next < ends.size() && ends[next] == i) {
      if (feet[next].valid)
        add(feet[next].position, feet[next].normal, 0.5f * (path.turns[i - 1] + path.turns[i]), isOverGap(feet[next]));
      ++next;
    }
    add(path.contacts[i], path.normals[i], path.turns[i], path.over_gap[i] != 0);
  }
  path = std::move(halved);
}

/** Whether there is no point of the scan near, but perhaps one that was put into a gap. */
bool
SpiralPlanner::isOverGap(const SurfaceFoot& foot) const
{
  return foot.nearest_distance > gap_in_spacings * graph_.spacing(foot.nearest) ||
         (!bridges_.empty() && source_.indices[graph_.blocks().originalIndex(foot.nearest)] >= first_bridge_);
}

Status
SpiralPlanner::reportGaps(const SpiralPath& path)
{
  for (std::size_t i = 0; i < path.contacts.size(); ++i) {
    report_.gap_points += path.over_gap[i];
    if (i > 0 && (path.over_gap[i - 1] || path.over_gap[i]))
      report_.gap_length += path.arc_lengths[i] - path.arc_lengths[i - 1];
    if (path.over_gap[i] && settings_.gaps == GapHandling::Refuse)
      return {StatusCode::InvalidInput, textOf("the scan has a gap at ", placeText(path.contacts[i]),
                                               ": no point of it lies near the path there; rescan it, or allow gaps to be "
                                               "bridged")};
  }
  if (report_.gap_points > 0)
    report_.warnings.push_back(textOf(report_.gap_points, " path points, ", report_.gap_length,
                                      " mm, lie over gaps of the scan, where the surface is a guess; they are marked"));
  return Status::success();
}

Status
SpiralPlanner::setAxes(SpiralPath& path)
{
  const auto wanted =
      tiltedAxes(path.contacts, path.normals, radians(settings_.tilt_angle), radians(settings_.lead_angle));
  const double rate = radians(settings_.max_axis_rate);
  const SmoothAxes field = smoothAxes(path.contacts, wanted,
                                      {settings_.axis_smoothing, radians(settings_.axis_deviation), rate});
  const AxisLean lean = largestLean(path.normals, field.axes);
  if (liesInSurface(lean, path.normals, wanted))
    return {StatusCode::Failed,
            textOf("the tool axis would lean ", degrees(lean.angle), " degrees off the surface at ",
                   placeText(path.contacts[lean.point]), " so as to turn no faster than the largest axis rate of ",
                   settings_.max_axis_rate, " degrees per mm: raise the rate")};
  const auto count = static_cast<std::int64_t>(field.axes.size());
  path.axes.resize(field.axes.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i)
    path.axes[i] = field.axes[i].cast<float>();
  report_.largest_axis_change = degrees(field.largest_change);
  report_.largest_axis_rate = degrees(field.largest_rate);
  report_.largest_axis_deviation = degrees(field.largest_deviation);
  report_.largest_axis_lean = degrees(lean.angle);
  report_.deviating_points = field.deviating_points;
  if (const std::size_t moves = movesTurningFaster(path.contacts, path.normals, rate); moves > 0)
    report_.warnings.push_back(textOf("on ", moves, " of ", count - 1,
                                      " moves the surface alone turns faster than the largest axis rate of ",
                                      settings_.max_axis_rate,
                                      " degrees per mm: the tool axis cannot follow it there and leaves the tilt "
                                      "asked for by up to ",
                                      report_.largest_axis_deviation, " degrees; allow a higher rate, or smooth the scan"));
  return Status::success();
}

Status
SpiralPlanner::checkPath(const SpiralPath& path)
{
  for (std::size_t i = 1; i < path.contacts.size(); ++i) {
    const double gap = (path.contacts[i] - path.contacts[i - 1]).norm();
    report_.largest_gap = std::max(report_.largest_gap, gap);
    if (!(gap <= slack * report_.largest_allowed_step))
      return {StatusCode::Failed,
              textOf("the path jumps by ", gap, " mm at ", placeText(path.contacts[i]), " in turn ", path.turns[i],
                   ", above the longest step ", report_.largest_allowed_step,
                   " mm: the surface is too rough or too sparse there; scan more densely or raise the longest step")};
  }
  report_.turns = static_cast<std::size_t>(std::lround(std::abs(path.turns.back() - path.turns.front())));
  report_.path_points = path.contacts.size();
  report_.path_length = path.arc_lengths.back();
  // Turns that are not in order cross somewhere: each goes once round.
  bool cancelled = false;
  const auto go_on = [&](double share) {
    cancelled = !report(0.96 + 0.04 * share, "crossings");
    return !cancelled;
  };
  const auto crossing = firstSelfCrossing(path.contacts, path.normals, settings_.chord_error, go_on);
  if (cancelled)
    return {StatusCode::Cancelled, "cancelled"};
  if (crossing)
    return {StatusCode::Failed,
            textOf("the path crosses itself at ", placeText(path.contacts[*crossing]), " in turn ", path.turns[*crossing],
                 ": the radial lines there are not in order; give another centre, or machine the part in pieces")};
  return Status::success();
}

} // namespace pcl_spiral
