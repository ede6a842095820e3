// SPDX-License-Identifier: BSD-3-Clause
#include "half_turn.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/machine/impl/rotary_path.h>

#include "core/angle_between.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace pcl_spiral {
namespace {

struct BranchPath {
  std::vector<RotaryAngles> angles;
  std::size_t beyond = 0; ///< poses beyond the limits of the second axis
};

Status
checkPoses(const ToolPoses& poses)
{
  if (poses.size() < 2)
    return {StatusCode::InvalidInput, Diagnostic("the path has ", poses.size(), " poses; a program needs at least 2")};
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (!poses[i].tip.allFinite() || !poses[i].contact.allFinite() || !(std::abs(poses[i].axis.norm() - 1.0) < 1e-6))
      return {StatusCode::InvalidInput, Diagnostic("pose ", i, " is not finite or its axis is not a unit vector; remove it")};
  return Status::success();
}

/** The equal angle of the second axis that is nearest to the middle of its limits. */
double
withinLimits(double angle, const AxisRange& range)
{
  if (!std::isfinite(range.lower) || !std::isfinite(range.upper))
    return angle;
  return nearestTurn(angle, 0.5 * (range.lower + range.upper));
}

/** Angles on one branch; the index of the first pose that cannot be reached, if there is one. */
std::optional<std::size_t>
branchPath(const Kinematics& kinematics, const ToolPoses& poses, Branch branch, BranchPath& path)
{
  const AxisRange& range = kinematics.machine().rotary[1].range;
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::optional<RotaryAngles> angles = kinematics.anglesOf(poses[i].axis, branch);
    if (!angles)
      return i;
    const double second = i == 0 ? withinLimits(angles->second, range) : nearestTurn(angles->second, path.angles.back().second);
    path.beyond += second < range.lower - rounding || second > range.upper + rounding;
    path.angles.push_back({angles->first, second});
  }
  return std::nullopt;
}

/** Makes first angles go the shorter way from one to the next, evenly over poses at the pole, which have
 *  none. */
void
unwind(std::vector<RotaryAngles>& angles, double home)
{
  double last = home;
  std::size_t known = angles.size();
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (std::isnan(angles[i].first))
      continue;
    last = angles[i].first = nearestTurn(angles[i].first, last);
    const std::size_t begin = known == angles.size() ? 0 : known + 1;
    const double from = known == angles.size() ? last : angles[known].first;
    for (std::size_t j = begin; j < i; ++j)
      angles[j].first = from + (last - from) * static_cast<double>(j + 1 - begin) / static_cast<double>(i + 1 - begin);
    known = i;
  }
  for (std::size_t j = known == angles.size() ? 0 : known + 1; j < angles.size(); ++j)
    angles[j].first = last;
}

/** Whether the move to location \p i turns the first axis faster than it can, near the pole. */
bool
exceeds(const Kinematics& kinematics, const MachineLocations& path, std::size_t i, const RotaryPathSettings& settings)
{
  const double minutes = (path[i].arc_length - path[i - 1].arc_length) / settings.feed;
  return std::abs(path[i].angles.first - path[i - 1].angles.first) > kinematics.machine().rotary[0].range.largest_rate * minutes + 1e-9 &&
         kinematics.poleAngle(path[i].pose.axis) < settings.pole_cone && kinematics.poleAngle(path[i - 1].pose.axis) < settings.pole_cone;
}

void
setFirst(const Kinematics& kinematics, double first, double pivot, MachineLocation& location, PoleZone& zone)
{
  location.angles.first = first;
  const Eigen::Vector3d axis = kinematics.toolAxis(location.angles);
  zone.largest_change = std::max(zone.largest_change, angleBetween(axis, location.pose.axis));
  location.pose.tip += pivot * (location.pose.axis - axis);
  location.pose.axis = axis;
}

/** Lead the first angle evenly over locations \p zone.first_pose to last_pose. */
void
blend(const Kinematics& kinematics, double pivot, MachineLocations& path, PoleZone& zone)
{
  const bool at_begin = zone.first_pose == 0, at_end = zone.last_pose + 1 == path.size();
  const double enter = path[zone.first_pose].angles.first, leave = path[zone.last_pose].angles.first;
  const double from = at_begin ? leave : enter;
  const double to = at_begin ? leave : at_end ? enter : nearestTurn(leave, enter);
  for (std::size_t i = zone.first_pose; i <= zone.last_pose; ++i) {
    const double share = zone.end > zone.begin ? (path[i].arc_length - zone.begin) / (zone.end - zone.begin) : 1.0;
    setFirst(kinematics, from + share * (to - from), pivot, path[i], zone);
  }
  if (!at_begin)
    for (std::size_t i = zone.last_pose + 1; i < path.size(); ++i)
      path[i].angles.first += to - leave;
}

void
blendPoles(const Kinematics& kinematics, const RotaryPathSettings& settings, RotaryPath& path)
{
  MachineLocations& locations = path.locations;
  for (std::size_t i = 1; i < locations.size(); ++i) {
    if (!exceeds(kinematics, locations, i, settings))
      continue;
    PoleZone zone;
    zone.first_pose = i - 1;
    while (i + 1 < locations.size() && exceeds(kinematics, locations, i + 1, settings))
      ++i;
    zone.last_pose = i;
    zone.begin = locations[zone.first_pose].arc_length;
    zone.end = locations[zone.last_pose].arc_length;
    blend(kinematics, settings.pivot, locations, zone);
    path.poles.push_back(zone);
  }
}

} // namespace

Status
rotaryPath(const Kinematics& kinematics, const ToolPoses& poses, const RotaryPathSettings& settings, RotaryPath& path)
{
  path = RotaryPath();
  if (const Status status = checkPoses(poses); !status.ok())
    return status;
  BranchPath larger, smaller;
  if (const std::optional<std::size_t> i = branchPath(kinematics, poses, Branch::Larger, larger)) {
    const auto& rotary = kinematics.machine().rotary;
    if (kinematics.machine().three_axes)
      return {StatusCode::InvalidInput, Diagnostic("pose ", *i, " at ", Place(poses[*i].tip), ": the tool axis ", Direction(poses[*i].axis),
                                                   " leans by ", angleBetween(poses[*i].axis, Eigen::Vector3d::UnitZ()) * in_degrees,
                                                   " {degrees}, and a machine with three axes cannot tilt the tool; make the path with the "
                                                   "tool axis along +Z ({setFixedAxis})")};
    return {StatusCode::InvalidInput,
            Diagnostic("pose ", *i, " at ", Place(poses[*i].tip), ": no angles of ", rotary[0].letter, " and ", rotary[1].letter,
                       " reach the tool axis ", Direction(poses[*i].axis), "; turn the part, or tilt the tool less")};
  }
  branchPath(kinematics, poses, Branch::Smaller, smaller);
  path.branch = smaller.beyond < larger.beyond ? Branch::Smaller : Branch::Larger;
  std::vector<RotaryAngles>& angles = path.branch == Branch::Smaller ? smaller.angles : larger.angles;
  unwind(angles, kinematics.machine().rotary[0].home);
  path.locations.resize(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double step = i == 0 ? 0.0 : (poses[i].contact - poses[i - 1].contact).norm();
    path.locations[i] = {poses[i], angles[i], i == 0 ? 0.0 : path.locations[i - 1].arc_length + step};
  }
  blendPoles(kinematics, settings, path);
  const double begin = path.locations.front().angles.first, shift = nearestTurn(begin, kinematics.machine().rotary[0].home) - begin;
  for (MachineLocation& location : path.locations) // a pole zone at the start took whole turns away
    location.angles.first += shift;
  return Status::success();
}

} // namespace pcl_spiral
