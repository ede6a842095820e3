// SPDX-License-Identifier: BSD-3-Clause
#include "machine/machine_bodies.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** The turn of \p axis by \p angle, with its point at \p point. */
Eigen::Isometry3d
turnAbout(const RotaryAxis& axis, const Eigen::Vector3d& point, double angle)
{
  return Eigen::Translation3d(point) * Eigen::AngleAxisd(angle, axis.direction.normalized()) * Eigen::Translation3d(-point);
}

bool
turnsTable(const Machine& machine, int axis)
{
  return !machine.three_axes && machine.rotary[axis].mount == RotaryMount::Table;
}

bool
turnsHead(const Machine& machine, int axis)
{
  return !machine.three_axes && machine.rotary[axis].mount == RotaryMount::Head;
}

/** Makes the solids of one machine. Shares are of the size of the part. */
class SolidMaker {
public:
  SolidMaker(const Machine& machine, const Eigen::AlignedBox3d& part, double tool_height)
  : machine_(machine), part_(part), size_(std::max(part.diagonal().norm(), 1.0)), tool_top_(0.0, 0.0, tool_height - machine.tool_length),
    nose_(0.0, 0.0, std::max(0.0, tool_top_.z()))
  {}

  std::vector<MachineSolid> make()
  {
    turnsTable(machine_, 0) ? addRoundTable() : addBedTable();
    addHead();
    return std::move(solids_);
  }

private:
  void addCylinder(MachineBody body, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius, bool is_axis = false)
  {
    if ((to - from).norm() > 1e-6 * size_)
      solids_.push_back({body, from, to, radius, is_axis});
  }

  /** A table that stands. */
  void addBedTable()
  {
    const Eigen::Vector3d beyond(0.2 * size_, 0.2 * size_, 0.0);
    const double top = part_.min().z() - gap * size_;
    Eigen::Vector3d low = part_.min() - beyond, high = part_.max() + beyond;
    low.z() = top - 0.1 * size_;
    high.z() = top;
    solids_.push_back({MachineBody::Table, low, high, 0.0, false});
  }

  /** A disc that turns below the part, and what carries it. */
  void addRoundTable()
  {
    const RotaryAxis& axis = machine_.rotary[0];
    Eigen::Vector3d up = axis.direction.normalized();
    if (up.z() < 0.0)
      up = -up;
    const Eigen::Vector3d point = axis.point - machine_.work_zero;
    double radius = 0.0, low = 1e300;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d corner = part_.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)) - point;
      low = std::min(low, corner.dot(up));
      radius = std::max(radius, 1.08 * (corner - corner.dot(up) * up).norm());
    }
    const Eigen::Vector3d top = point + (low - gap * size_) * up;
    const double thick = 0.1 * radius;
    addCylinder(MachineBody::Table, top - thick * up, top, radius);
    addCylinder(MachineBody::Table, top - 2.0 * thick * up, top - thick * up, 0.3 * radius, true);
    const Eigen::Vector3d below = top - 2.0 * thick * up;
    turnsTable(machine_, 1) ? addTrunnion(below, radius) : addCylinder(MachineBody::Ground, below - thick * up, below, 0.6 * radius);
  }

  /** A cradle that carries the round table at \p below, between the two ends of its axis. */
  void addTrunnion(const Eigen::Vector3d& below, double radius)
  {
    const RotaryAxis& axis = machine_.rotary[1];
    const Eigen::Vector3d along = axis.direction.normalized(), point = axis.point - machine_.work_zero;
    const Eigen::Vector3d middle = point + along.dot(below - point) * along;
    addCylinder(MachineBody::Trunnion, below - 1.2 * radius * along, below + 1.2 * radius * along, 0.1 * radius);
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector3d end = middle + side * 1.2 * radius * along;
      addCylinder(MachineBody::Trunnion, below + side * 1.2 * radius * along, end, 0.1 * radius);
      addCylinder(MachineBody::Trunnion, end - side * 0.1 * radius * along, end + side * 0.1 * radius * along, 0.2 * radius, true);
      addCylinder(MachineBody::Ground, end + side * 0.1 * radius * along, end + side * 0.35 * radius * along, 0.3 * radius);
    }
  }

  /** Spindle, head axes and slide; from the gauge point. */
  void addHead()
  {
    const double radius = 0.1 * size_;
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ(), top = nose_ + 0.45 * size_ * z;
    addCylinder(MachineBody::Spindle, tool_top_, nose_, 0.4 * radius); // what the tool is longer than its given holder
    addCylinder(MachineBody::Spindle, nose_, nose_ + 0.08 * size_ * z, 0.6 * radius);
    addCylinder(MachineBody::Spindle, nose_ + 0.08 * size_ * z, top, radius);
    Eigen::Vector3d hung = nose_ + 0.35 * size_ * z; // what the carrier holds
    if (turnsHead(machine_, 1))
      hung =
          addHeadAxis(machine_.rotary[1], MachineBody::Spindle, turnsHead(machine_, 0) ? MachineBody::OuterHead : MachineBody::Slide, hung);
    if (turnsHead(machine_, 0))
      hung = addHeadAxis(machine_.rotary[0], MachineBody::OuterHead, MachineBody::Slide, hung);
    const Eigen::Vector3d half(0.16 * size_, 0.16 * size_, 0.0);
    solids_.push_back({MachineBody::Slide, hung - half, hung + half + 0.3 * size_ * z, 0.0, false});
  }

  /** A head axis, at the place of it that is nearest to \p held, from which \p carrier holds \p body. Returns where the carrier ends. */
  Eigen::Vector3d addHeadAxis(const RotaryAxis& axis, MachineBody body, MachineBody carrier, const Eigen::Vector3d& held)
  {
    const Eigen::Vector3d along = axis.direction.normalized(), place = axis.point + along.dot(held - axis.point) * along;
    const double radius = 0.1 * size_;
    const bool upright = std::abs(along.z()) > 0.7;
    const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
    addCylinder(body, held, place, 0.6 * radius);
    if (upright) { // the axis of a fork: a disc above what it turns
      const Eigen::Vector3d up = along.z() < 0.0 ? Eigen::Vector3d(-along) : along;
      addCylinder(body, place, place + 0.06 * size_ * up, 1.5 * radius, true);
      return place + 0.06 * size_ * up;
    }
    addCylinder(body, place - 0.16 * size_ * along, place + 0.16 * size_ * along, 0.7 * radius, true);
    const Eigen::Vector3d over = place + 0.4 * size_ * z;
    for (const double side : {-0.19, 0.19})
      addCylinder(carrier, place + side * size_ * along, over + side * size_ * along, 0.45 * radius);
    addCylinder(carrier, over - 0.22 * size_ * along, over + 0.22 * size_ * along, 0.6 * radius);
    return over;
  }

  static constexpr double gap = 0.01; // between part and table

  const Machine& machine_;
  const Eigen::AlignedBox3d part_;
  double size_;
  Eigen::Vector3d tool_top_, nose_; ///< upper end of the tool, lower end of the spindle
  std::vector<MachineSolid> solids_;
};

} // namespace

MachineStand::MachineStand(const Kinematics& kinematics, const Eigen::Vector3d& tip, const RotaryAngles& angles)
{
  const Machine& machine = kinematics.machine();
  poses_.fill(Eigen::Isometry3d::Identity());
  const auto& [first, second] = machine.rotary;
  if (turnsTable(machine, 1))
    at(MachineBody::Trunnion) = turnAbout(second, second.point - machine.work_zero, angles.second);
  at(MachineBody::Table) = of(MachineBody::Trunnion);
  if (turnsTable(machine, 0))
    at(MachineBody::Table) = of(MachineBody::Trunnion) * turnAbout(first, first.point - machine.work_zero, angles.first);
  const Eigen::Vector3d gauge = kinematics.gaugePoint(kinematics.programmed(tip, angles)) - machine.work_zero;
  at(MachineBody::Slide) = Eigen::Translation3d(gauge) * Eigen::Isometry3d::Identity();
  at(MachineBody::OuterHead) = of(MachineBody::Slide);
  if (turnsHead(machine, 0))
    at(MachineBody::OuterHead) = of(MachineBody::Slide) * turnAbout(first, first.point, angles.first);
  at(MachineBody::Spindle) = of(MachineBody::OuterHead);
  if (turnsHead(machine, 1))
    at(MachineBody::Spindle) = of(MachineBody::OuterHead) * turnAbout(second, second.point, angles.second);
  tool_ = of(MachineBody::Spindle) * Eigen::Translation3d(0.0, 0.0, -machine.tool_length);
}

std::vector<MachineSolid>
machineSolids(const Machine& machine, const Eigen::AlignedBox3d& part, double tool_height)
{
  return SolidMaker(machine, part, tool_height).make();
}

} // namespace pcl_spiral
