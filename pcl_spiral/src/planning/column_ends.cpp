// SPDX-License-Identifier: BSD-3-Clause
#include "planning/column_ends.h"

#include "planning/scallop_check.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pcl_spiral {
namespace {

constexpr int sectors = 72;

} // namespace

ColumnEnds::ColumnEnds(const DriveCylinder& cylinder)
: cylinder_(cylinder), e1_(referenceAcross(cylinder.direction)), e2_(cylinder.direction.cross(e1_)), along_(sectors)
{}

void
ColumnEnds::add(const Eigen::Vector3d& place)
{
  const Eigen::Vector3d y = place - cylinder_.origin;
  const double turn = std::atan2(y.dot(e2_), y.dot(e1_)) / (2.0 * pi) + 0.5;
  along_[std::min(sectors - 1, static_cast<int>(turn * sectors))].push_back(y.dot(cylinder_.direction));
}

double
ColumnEnds::missedBy(ColumnEnds& inner)
{
  constexpr std::size_t outliers = 2;
  double missed = 0.0;
  for (int k = 0; k < sectors; ++k) {
    std::vector<double>&outer = along_[k], &reached = inner.along_[k];
    if (outer.size() <= 2 * outliers)
      continue;
    std::sort(outer.begin(), outer.end());
    std::sort(reached.begin(), reached.end());
    const double first = outer[outliers], last = outer[outer.size() - 1 - outliers];
    missed = std::max(missed, reached.empty() ? last - first : std::max(reached.front() - first, last - reached.back()));
  }
  return missed;
}

void
warnOfEnds(const DrivePlanInput& input, const std::vector<ToolLocations>& located, PassPlan& plan)
{
  ColumnEnds scan(plan.drive.column->cylinder), contacts(plan.drive.column->cylinder);
  for (const pcl::PointXYZ& p : *plan.cloud)
    if (p.getVector3fMap().allFinite())
      scan.add(p.getVector3fMap().cast<double>());
  for (const ToolLocations& pass : located)
    for (const ToolLocation& location : pass)
      if (location.state != LocationState::NoCloud)
        contacts.add(location.contact);
  // At the distance d from the last contact, d^2 / (2 R) is left: the scallop height at half a step-over.
  const double missed = scan.missedBy(contacts), most_missed = 0.5 * std::sqrt(more_left) * plan.drive.step_over;
  if (!(missed > most_missed))
    return;
  const double most = input.tool.cutter.radius + plan.drive.step_over, overrun = std::min(input.drive.overrun + missed, most);
  const bool helps = input.drive.axisMode() == DriveAxisMode::Cylinder && input.drive.overrun < most;
  plan.warnings.push_back(Diagnostic("up to ", missed, " {mm} at an end of the column are not cut",
                                     helps ? Diagnostic("; where the wall leans, the cutter touches it beside the cutter's axis: "
                                                        "extend the path beyond the ends, such as {setOverrun} ",
                                                        std::ceil(10.0 * overrun) / 10.0)
                                           : Diagnostic(": check the path there")));
}

} // namespace pcl_spiral
