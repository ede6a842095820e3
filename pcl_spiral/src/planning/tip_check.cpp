// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tip_check.h"

#include <pcl_spiral/common/tool_tip.h>
#include <pcl_spiral/verify/impl/profile_depth.h>
#include <pcl_spiral/verify/impl/profile_sweep.h>

#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double rounding = 0.001; // mm: of the single precision of contacts, on parts of a few metres

/** Counts the tip of path point \p i, which is \p off by some mm. */
void
countTip(double off, const Eigen::Vector3d& contact, std::size_t i, Verification& verification)
{
  if (!(off > rounding))
    return;
  ++verification.tips_off;
  if (off > verification.tip_error.value)
    verification.tip_error = {off, contact, i};
}

Diagnostic
checkContacts(const pcl::PointCloud<ToolpathPoint>& path, const Polyline& tips, const CutterShape& cutter, Verification& verification)
{
  const ProfileDepth profile{CutterProfile(cutter)};
  for (std::size_t i = 0; i < tips.size(); ++i) {
    const ToolpathPoint& point = path[i];
    const Eigen::Vector3d contact = point.getVector3fMap().cast<double>();
    const double off = std::abs(profile.at(contact, tips[i], point.getAxisVector3fMap().cast<double>()));
    countTip(off, contact, i, verification);
  }
  if (verification.tips_off == 0)
    return {};
  return Diagnostic(verification.tips_off, " of ", tips.size(), " tool tips do not bring this cutter to their contact, by up to ",
                    verification.tip_error.value, " {mm} at path point ", verification.tip_error.index,
                    ": give the cutter that the path was made for ({setCutter})");
}

Diagnostic
checkBall(const pcl::PointCloud<ToolpathPoint>& path, const Polyline& tips, double tool_radius, Verification& verification)
{
  double along = 0.0, squared = 0.0; // least squares of tip - contact = radius (normal - axis)
  for (std::size_t i = 0; i < tips.size(); ++i) {
    const ToolpathPoint& point = path[i];
    const Eigen::Vector3d contact = point.getVector3fMap().cast<double>();
    const Eigen::Vector3d arm = toolTip(point, 1.0) - contact;
    along += arm.dot(tips[i] - contact);
    squared += arm.squaredNorm();
    const double off = (tips[i] - toolTip(point, tool_radius)).norm();
    countTip(off, contact, i, verification);
  }
  if (verification.tips_off == 0)
    return {};
  const Diagnostic fault(verification.tips_off, " of ", tips.size(), " tool tips are not where a ball of radius ", tool_radius,
                         " {mm} has them, by up to ", verification.tip_error.value, " {mm} at path point ", verification.tip_error.index);
  const double radius = squared > 0.0 ? along / squared : 0.0;
  if (2 * verification.tips_off > tips.size() && radius > 0.01 * tool_radius)
    return Diagnostic(fault, ": the path seems made for a radius of ", radius, " {mm}");
  return Diagnostic(fault, ": the machine would not go where the contacts say; make the file again");
}

} // namespace

Diagnostic
checkTips(const pcl::PointCloud<ToolpathPoint>& path, const Polyline& tips, const CutterShape& cutter, Verification& verification)
{
  if (!(cutter.radius > 0.0))
    return {};
  return isBall(cutter) ? checkBall(path, tips, cutter.radius, verification) : checkContacts(path, tips, cutter, verification);
}

} // namespace pcl_spiral
