// SPDX-License-Identifier: BSD-3-Clause
#include "support/control_angles.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace pcl_spiral::test {
namespace {

constexpr double along = 1e-7; ///< radians: closer to a rotary axis its angle is free

Eigen::Vector3d
lengthOf(const MachineChain& chain)
{
  return {0.0, 0.0, chain.tool_length};
}

/** Degrees about the unit vector \p about from \p from to \p to, no number if one of them is along \p about. */
double
turning(const Eigen::Vector3d& about, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  const Eigen::Vector3d a = from - from.dot(about) * about, b = to - to.dot(about) * about;
  return std::min(a.norm(), b.norm()) < along ? std::nan("") : std::atan2(about.dot(a.cross(b)), a.dot(b)) * 180.0 / M_PI;
}

double
nearTo(double degrees, double from)
{
  return std::isnan(degrees) ? from : degrees + 360.0 * std::round((from - degrees) / 360.0);
}

} // namespace

TipAndAxis
toolAt(const MachineChain& chain, const AxisPosition& at)
{
  return forward(chain, {at.gauge - chain.work_zero - lengthOf(chain), at.degrees[0], at.degrees[1]});
}

Eigen::Vector3d
gaugeFor(const MachineChain& chain, const Eigen::Vector3d& tip, const std::array<double, 2>& degrees)
{
  const auto tipAt = [&](const Eigen::Vector3d& xyz) { return forward(chain, {xyz, degrees[0], degrees[1]}).tip; };
  const Eigen::Vector3d origin = tipAt(Eigen::Vector3d::Zero());
  Eigen::Matrix3d slides; // the tip moves with the slides by a rotation
  for (int i = 0; i < 3; ++i)
    slides.col(i) = tipAt(Eigen::Vector3d::Unit(i)) - origin;
  return slides.transpose() * (tip - origin) + chain.work_zero + lengthOf(chain);
}

std::array<double, 2>
nearestAngles(const MachineChain& chain, const Eigen::Vector3d& axis, const std::array<double, 2>& from)
{
  // Paden and Kahan's second subproblem: z turned about the second axis to c, then c about the first to the tool axis.
  const Eigen::Vector3d d1 = chain.rotary.at(0).direction.normalized(), d2 = chain.rotary.at(1).direction.normalized();
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const double k = d1.dot(d2), a = (d1.dot(axis) - k * z.dot(d2)) / (1.0 - k * k), b = (z.dot(d2) - k * d1.dot(axis)) / (1.0 - k * k);
  const double rest = (1.0 - a * a - b * b - 2.0 * a * b * k) / (1.0 - k * k);
  if (rest < -1e-7)
    throw std::runtime_error("no angles of the machine reach the tool axis");
  std::array<double, 2> best{};
  double least = std::numeric_limits<double>::infinity();
  for (const double side : {1.0, -1.0}) {
    const Eigen::Vector3d c = a * d1 + b * d2 + side * std::sqrt(std::max(0.0, rest)) * d1.cross(d2);
    const double first = turning(d1, c, axis), second = turning(d2, z, c);
    const std::array<double, 2> found = {nearTo(chain.rotary[0].table ? -first : first, from[0]),
                                         nearTo(chain.rotary[1].table ? -second : second, from[1])};
    const double turn = std::abs(found[0] - from[0]) + std::abs(found[1] - from[1]);
    if (turn < least) {
      least = turn;
      best = found;
    }
  }
  return best;
}

} // namespace pcl_spiral::test
