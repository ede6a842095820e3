// SPDX-License-Identifier: BSD-3-Clause
#include "half_turn.h"

#include <pcl_spiral/machine/impl/block_spacing.h>

#include "core/angle_between.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl_spiral {
namespace {

constexpr double largest_turn = 1.57079632679489661923; ///< of a rotary axis in one block, radians
constexpr int most_halvings = 20;

RotaryAngles
linear(const RotaryAngles& a, const RotaryAngles& b, double t)
{
  return {a.first + t * (b.first - a.first), a.second + t * (b.second - a.second)};
}

/** The tip on the move from \p a to \p b with the rotary axes at \p angles. */
Eigen::Vector3d
tipOnMove(const Kinematics& kinematics, const MachineLocation& a, const MachineLocation& b, const RotaryAngles& angles, double t)
{
  if (kinematics.machine().rtcp)
    return a.pose.tip + t * (b.pose.tip - a.pose.tip);
  const Eigen::Vector3d from = kinematics.programmed(a.pose.tip, a.angles), to = kinematics.programmed(b.pose.tip, b.angles);
  return kinematics.tipOf(from + t * (to - from), angles);
}

bool
staysNear(const Kinematics& kinematics, const MachineLocation& a, const MachineLocation& b, const BlockTolerance& tolerance)
{
  if (std::max(std::abs(b.angles.first - a.angles.first), std::abs(b.angles.second - a.angles.second)) > largest_turn)
    return false;
  for (double t : {0.5, 0.25, 0.75}) {
    const RotaryAngles angles = linear(a.angles, b.angles, t);
    const Eigen::Vector3d tip = a.pose.tip + t * (b.pose.tip - a.pose.tip);
    if ((tipOnMove(kinematics, a, b, angles, t) - tip).norm() > tolerance.tip ||
        angleBetween(kinematics.toolAxis(angles), arcBetween(a.pose.axis, b.pose.axis, t)) > tolerance.axis)
      return false;
  }
  return true;
}

MachineLocation
middle(const Kinematics& kinematics, Branch branch, const MachineLocation& a, const MachineLocation& b)
{
  MachineLocation m{between(a.pose, b.pose, 0.5), linear(a.angles, b.angles, 0.5), 0.5 * (a.arc_length + b.arc_length)};
  if (const std::optional<RotaryAngles> angles = kinematics.anglesOf(m.pose.axis, branch)) {
    if (!std::isnan(angles->first))
      m.angles.first = nearestTurn(angles->first, m.angles.first);
    m.angles.second = nearestTurn(angles->second, m.angles.second);
  }
  return m;
}

void
split(const Kinematics& kinematics, Branch branch, const MachineLocation& a, const MachineLocation& b, const BlockTolerance& tolerance,
      int halvings, MachineLocations& out)
{
  if (halvings < most_halvings && !staysNear(kinematics, a, b, tolerance)) {
    const MachineLocation m = middle(kinematics, branch, a, b);
    split(kinematics, branch, a, m, tolerance, halvings + 1, out);
    split(kinematics, branch, m, b, tolerance, halvings + 1, out);
    return;
  }
  out.push_back(b);
}

/** Length of the way to each location in units of the tolerance, tip and axis together. */
std::vector<double>
measuredWay(const MachineLocations& path, const BlockTolerance& tolerance)
{
  std::vector<double> way(path.size(), 0.0);
  for (std::size_t i = 1; i < path.size(); ++i)
    way[i] = way[i - 1] + (path[i].pose.tip - path[i - 1].pose.tip).norm() / tolerance.tip +
             angleBetween(path[i].pose.axis, path[i - 1].pose.axis) / tolerance.axis;
  return way;
}

/** An upper bound of the angle between tool axes at two rotary angles: a rotary axis moves the tool axis by
 *  its own angle times the sine of the angle between the two, which for the first axis is the pole angle. */
double
axisBound(const RotaryAngles& a, const RotaryAngles& b, double sine)
{
  return std::abs(a.second - b.second) + std::abs(a.first - b.first) * sine;
}

/** Whether one block from \p i to \p j keeps every location between them within \p tolerance. */
bool
canSkip(const Kinematics& kinematics, const MachineLocations& path, const std::vector<double>& way, std::size_t i, std::size_t j,
        const BlockTolerance& tolerance)
{
  const MachineLocation &a = path[i], &b = path[j];
  if (std::max(std::abs(b.angles.first - a.angles.first), std::abs(b.angles.second - a.angles.second)) > largest_turn)
    return false;
  double sine = 0.0; // the pole angle is largest at a location, or changes by less than the second angle on the way
  for (std::size_t k = i; k <= j; ++k)
    sine = std::max(sine, std::sin(std::min(largest_turn, kinematics.poleAngle(path[k].pose.axis) + tolerance.axis)));
  for (std::size_t k = i + 1; k < j; ++k) {
    const double t = way[j] > way[i] ? (way[k] - way[i]) / (way[j] - way[i]) : 0.0;
    if ((interpolated(kinematics, a, b, t).tip - path[k].pose.tip).norm() > tolerance.tip ||
        axisBound(linear(a.angles, b.angles, t), path[k].angles, sine) > tolerance.axis)
      return false;
  }
  return true;
}

} // namespace

ToolPose
interpolated(const Kinematics& kinematics, const MachineLocation& a, const MachineLocation& b, double t)
{
  const RotaryAngles angles = linear(a.angles, b.angles, t);
  ToolPose pose = between(a.pose, b.pose, t);
  pose.axis = kinematics.toolAxis(angles);
  pose.tip = tipOnMove(kinematics, a, b, angles, t);
  return pose;
}

MachineLocations
splitBlocks(const Kinematics& kinematics, Branch branch, const MachineLocations& path, const BlockTolerance& tolerance)
{
  constexpr std::size_t together = 4096; // moves that one thread takes at a time
  MachineLocations out;
  if (path.empty())
    return out;
  std::vector<MachineLocations> runs((path.size() + together - 2) / together);
  const auto count = static_cast<std::int64_t>(runs.size());
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t r = 0; r < count; ++r)
    for (std::size_t i = r * together + 1; i <= std::min(path.size() - 1, (r + 1) * together); ++i)
      split(kinematics, branch, path[i - 1], path[i], tolerance, 0, runs[r]);
  out.reserve(path.size());
  out.push_back(path.front());
  for (MachineLocations& run : runs) {
    out.insert(out.end(), run.begin(), run.end());
    MachineLocations().swap(run);
  }
  return out;
}

MachineLocations
thinnedBlocks(const Kinematics& kinematics, const MachineLocations& path, const BlockTolerance& tolerance)
{
  const BlockTolerance least{std::max(tolerance.tip, 1e-9), std::max(tolerance.axis, 1e-12)};
  const std::vector<double> way = measuredWay(path, least);
  MachineLocations out;
  if (!(tolerance.tip > 0.0))
    out.reserve(path.size()); // hardly any is left out
  for (std::size_t i = 0; i < path.size();) {
    out.push_back(path[i]);
    std::size_t reach = i + 1, step = 1; // the farthest location known to be allowed; then steps that halve
    for (; reach + step < path.size() && canSkip(kinematics, path, way, i, reach + step, least); step *= 2)
      reach += step;
    for (; step > 0; step /= 2)
      if (reach + step < path.size() && canSkip(kinematics, path, way, i, reach + step, least))
        reach += step;
    i = reach;
  }
  return out;
}

} // namespace pcl_spiral
