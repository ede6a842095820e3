// SPDX-License-Identifier: BSD-3-Clause
// Common to all kinds of drive paths: equal steps, equal spacing, size.
#include "drive_kinds.h"

#include "common/available_memory.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/spiral/impl/path_size.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

EqualSteps
equalSteps(double low, double high, double most)
{
  const double count = std::max(1.0, std::ceil((high - low) / most - 1e-9));
  EqualSteps steps{(high - low) / count, std::vector<double>(static_cast<std::size_t>(count))};
  for (std::size_t k = 0; k < steps.middles.size(); ++k)
    steps.middles[k] = low + (static_cast<double>(k) + 0.5) * steps.step;
  return steps;
}

Status
checkDriveSize(double points, double crossings, const DriveSettings& settings)
{
  const double bytes = 2.0 * sizeof(DrivePoint) * points + 64.0 * crossings;
  const auto memory = availableMemory();
  const bool too_many = !(points <= most_path_points) || !(crossings <= 10.0 * most_path_points);
  if (!too_many && !(memory && bytes > *memory))
    return Status::success();
  return {StatusCode::InvalidArgument,
          Diagnostic("this drive path would be too large: about ", points, " points and ", bytes / 1e9, " GB of memory, but at most ",
                     most_path_points, " points are possible", (memory ? Diagnostic(" and ", *memory / 1e9, " GB are free") : Diagnostic()),
                     "; is the part in another unit than {mm} ({ReadOptions::unit})? Otherwise raise ",
                     (settings.kind == DriveKind::Curve ? Diagnostic()
                      : settings.rows == DriveRows::Kept
                          ? Diagnostic("the scallop height, now ", settings.scallop_height, " {mm} ({setScallopHeight}), or ")
                          : Diagnostic("the step-over, now ", settings.step_over, " {mm} ({setStepOver}), or ")),
                     "the spacing of points, now ", settings.point_spacing, " {mm} ({setPointSpacing})")};
}

DrivePass
passAlong(const Polyline& line, bool closed, double spacing)
{
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(length(line, closed) / spacing - 1e-9)));
  DrivePass pass;
  pass.closed = closed;
  for (const Eigen::Vector3d& p : resampled(line, closed ? std::max<std::size_t>(3, steps) : steps + 1, closed)) {
    DrivePoint point;
    point.position = p;
    pass.points.push_back(point);
  }
  return pass;
}

} // namespace pcl_spiral
