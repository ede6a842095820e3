// What all kinds of drive paths have in common: equal steps, equal spacing, size, a surface without flaws.
#include "drive_kinds.h"

#include <pcl_spiral/common/available_memory.h>
#include <pcl_spiral/common/message.h>
#include <pcl_spiral/toolpath/path_size.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
          textOf("the drive path asked for is too large: about ", points, " points and ", bytes / 1e9,
                 " GB of memory, where ", most_path_points, " points are the most") +
              (memory ? textOf(" and ", *memory / 1e9, " GB are free") : std::string()) +
              "; is the scan in another unit than mm? Otherwise raise " +
              (settings.kind == DriveKind::Curve
                   ? std::string()
                   : textOf("the step-over (", settings.step_over, " mm) or ")) +
              textOf("the spacing of points (", settings.point_spacing, " mm)")};
}

DrivePass
passAlong(const Polyline& line, bool closed, double spacing)
{
  const auto steps =
      static_cast<std::size_t>(std::max(1.0, std::ceil(length(line, closed) / spacing - 1e-9)));
  DrivePass pass;
  pass.closed = closed;
  for (const Eigen::Vector3d& p :
       resampled(line, closed ? std::max<std::size_t>(3, steps) : steps + 1, closed)) {
    DrivePoint point;
    point.position = p;
    pass.points.push_back(point);
  }
  return pass;
}

Triangulation
withoutFlaws(const SurfaceGraph& graph)
{
  constexpr double shortest_loop = 8.0; // in spacings
  Triangulation mesh = graph.triangulation();
  std::vector<std::size_t> sizes;
  const std::vector<std::uint32_t> part = mesh.parts(sizes);
  const auto loops = mesh.boundaryLoops();
  std::vector<double> lengths, longest(sizes.size(), 0.0);
  for (const auto& loop : loops) {
    double length = 0.0;
    for (const std::uint32_t h : loop)
      length += (graph.position(mesh.target(h)) - graph.position(mesh.origin(h))).norm();
    lengths.push_back(length);
    longest[part[loop.front() / 3]] = std::max(longest[part[loop.front() / 3]], length);
  }
  std::vector<Triangulation::Triangle> fans;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (lengths[l] > shortest_loop * graph.spacing() || lengths[l] >= longest[part[loops[l].front() / 3]])
      continue;
    const std::uint32_t hub = mesh.origin(loops[l].front());
    for (const std::uint32_t h : loops[l])
      if (mesh.origin(h) != hub && mesh.target(h) != hub)
        fans.push_back({hub, mesh.target(h), mesh.origin(h)});
  }
  mesh.append(fans);
  return mesh;
}

} // namespace pcl_spiral
