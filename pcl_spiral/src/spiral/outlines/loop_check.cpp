// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/loop_check.h>

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>

namespace pcl_spiral {
namespace {

constexpr double farthest = 4.0; // from a loop to the cloud, in spacings of the points there
constexpr double aside = 1.5;    // spacings to either side at which the surface is searched
constexpr double covered = 0.9;  // spacings from there to the cloud, mean: a half within it, above one beyond its rim
constexpr double flattest = 0.5; // length of the mean normal of a loop with a plane

template <typename... Parts>
Status
refused(std::size_t loop, const Parts&... parts)
{
  return {StatusCode::InvalidInput, Diagnostic("loop ", loop, parts...)};
}

double
distanceToCloud(const SurfaceGraph& graph, const Eigen::Vector3d& p)
{
  return (graph.position(graph.blocks().nearest(p)) - p).norm();
}

/** Whether \p p belongs to another cloud. It compares with the local spacing, so sparser parts of a scan pass too. */
bool
isAway(const SurfaceGraph& graph, const Eigen::Vector3d& p)
{
  const std::uint32_t near = graph.blocks().nearest(p);
  return (graph.position(near) - p).norm() > farthest * std::max(graph.spacing(), graph.spacing(near));
}

/** The first point that is not finite or is away from the cloud; the number of points if there is none. */
std::size_t
firstAway(const SurfaceGraph& graph, const Polyline& line)
{
  const auto count = static_cast<std::int64_t>(line.size());
  std::int64_t first = count;
#pragma omp parallel for schedule(static) reduction(min : first)
  for (std::int64_t i = 0; i < count; ++i)
    if (!line[i].allFinite() || isAway(graph, line[i]))
      first = std::min(first, i);
  return static_cast<std::size_t>(first);
}

/** The cloud on both sides of a loop. */
struct Sides {
  double left_length = 0.0, right_length = 0.0;     ///< of segments that have more of the cloud on that side, mm
  double left_distance = 0.0, right_distance = 0.0; ///< to the cloud, mean, in spacings
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< mean
};

Sides
sidesOf(const SurfaceGraph& graph, const Polyline& curve)
{
  constexpr std::size_t votes = 256; // places of a curve: enough to decide
  const std::size_t stride = std::max<std::size_t>(1, curve.size() / votes);
  Sides sides;
  double whole = 0.0;
  for (std::size_t k = 0; k < curve.size(); k += stride) {
    const Eigen::Vector3d along = curve[(k + 1) % curve.size()] - curve[k];
    const Eigen::Vector3d middle = curve[k] + 0.5 * along;
    const std::uint32_t near = graph.blocks().nearest(middle);
    const Eigen::Vector3d left = graph.normal(near).cross(along);
    if (left.norm() <= 0.0)
      continue;
    const Eigen::Vector3d step = aside * graph.spacing(near) * left.normalized();
    const double to_left = distanceToCloud(graph, middle + step), to_right = distanceToCloud(graph, middle - step);
    const double length = along.norm();
    (to_left < to_right ? sides.left_length : sides.right_length) += length;
    sides.left_distance += length * to_left / graph.spacing(near);
    sides.right_distance += length * to_right / graph.spacing(near);
    sides.normal += length * graph.normal(near);
    whole += length;
  }
  sides.left_distance /= whole;
  sides.right_distance /= whole;
  sides.normal /= whole;
  return sides;
}

/** Twice the vector area of a closed curve. */
Eigen::Vector3d
areaOf(const Polyline& curve)
{
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (std::size_t k = 1; k + 1 < curve.size(); ++k)
    area += (curve[k] - curve[0]).cross(curve[k + 1] - curve[0]);
  return area;
}

/** Whether most of the loop's segments have more of the cloud on their left than on their right. If both sides have points
 *  everywhere, the direction of the loop decides, if the loop has a plane. */
bool
surfaceOnLeft(const SurfaceGraph& graph, const BoundaryLoop& loop)
{
  const Sides sides = sidesOf(graph, loop.curve);
  const bool across = std::max(sides.left_distance, sides.right_distance) < covered;
  if (across && sides.normal.norm() > flattest)
    return (areaOf(loop.curve).dot(sides.normal) > 0.0) == (loop.type == LoopType::Outer);
  return sides.left_length > sides.right_length;
}

} // namespace

Status
checkLoopShape(const BoundaryLoop& loop, std::size_t index)
{
  if (loop.curve.size() < 3 || loop.points.empty())
    return refused(index, " has ", loop.curve.size(), " curve points and ", loop.points.size(),
                   " cloud points: it needs both, as {BoundaryLoops} gives them");
  for (const std::size_t corner : loop.corners)
    if (corner >= loop.curve.size())
      return refused(index, " names corner ", corner, ", but its curve has ", loop.curve.size(), " points");
  return Status::success();
}

Status
checkLoop(const SurfaceGraph& graph, const BoundaryLoop& loop, std::size_t index)
{
  if (const Status status = checkLoopShape(loop, index); !status.ok())
    return status;
  for (const Polyline* line : {&loop.curve, &loop.points})
    if (const std::size_t at = firstAway(graph, *line); at < line->size()) {
      const Eigen::Vector3d& p = (*line)[at];
      const double distance = p.allFinite() ? distanceToCloud(graph, p) : 0.0;
      return refused(index, " has a point ", Place(p), " that is not finite or ", distance,
                     " {mm} from the {cloud}. If it is your own loop: give one of the same {cloud}, or none to have it found. If "
                     "{BoundaryLoops} found it, it leads over a void of the {scan}: {scan more densely} there");
    }
  if (!surfaceOnLeft(graph, loop))
    return refused(index, " at ", Place(loop.curve.front()),
                   " has the surface on its right. If it is your own loop: reverse it, or find it with the same normals. If "
                   "{BoundaryLoops} found it, the {scan} is no single sheet there: crop it ({setCrop})");
  return Status::success();
}

Status
checkFoundLoops(const SurfaceGraph& graph, const std::vector<BoundaryLoop>& loops)
{
  for (const BoundaryLoop& loop : loops)
    if (!surfaceOnLeft(graph, loop))
      return {StatusCode::Failed,
              Diagnostic("the {scan} is no single sheet: an edge of the surface ends in the middle of it at ", Place(loop.curve.front()),
                         ", ", loop.length,
                         " {mm} round, so that something hangs over the surface there, such as a branch or an overhang, or the {scan} "
                         "is noisy in depth: cut a part without it ({setCrop}), or keep the cutter out of there ({addKeepOut})")};
  return Status::success();
}

Status
checkLoops(const SurfaceGraph& graph, const std::vector<BoundaryLoop>& loops)
{
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (const Status status = checkLoop(graph, loops[i], i); !status.ok())
      return status;
  return Status::success();
}

} // namespace pcl_spiral
