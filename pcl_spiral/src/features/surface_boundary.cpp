#include <pcl_spiral/features/surface_boundary.h>

#include "boundary_walk.h"
#include "loop_rings.h"
#include "outline.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <string>

namespace pcl_spiral {
namespace {

std::string
formatted(const char* format, double a, double b = 0.0, double c = 0.0)
{
  char text[160];
  std::snprintf(text, sizeof text, format, a, b, c);
  return text;
}

std::string
place(const Eigen::Vector3d& p)
{
  return formatted("(%.1f, %.1f, %.1f)", p.x(), p.y(), p.z());
}

Status
checkOptions(const SurfaceGraph& graph, const BoundaryOptions& options)
{
  if (!(options.min_hole_length >= 0.0) || !std::isfinite(options.min_hole_length))
    return {StatusCode::InvalidArgument, formatted("the shortest length of a hole is %g; set it above 0, or 0 for "
                                                   "an eighth of the outer boundary",
                                                   options.min_hole_length)};
  if (!(options.largest_gap >= 0.0) || !(options.shortest_loop >= 0.0))
    return {StatusCode::InvalidArgument, formatted("the largest gap is %g spacings, the shortest loop %g; neither "
                                                   "may be negative",
                                                   options.largest_gap, options.shortest_loop)};
  if (!(options.largest_left_out >= 0.0 && options.largest_left_out <= 1.0))
    return {StatusCode::InvalidArgument,
            formatted("the share of a part that may be left out is %g; set it between 0 and 1",
                      options.largest_left_out)};
  if (!(options.max_turn > 0.0 && options.max_turn <= 180.0))
    return {StatusCode::InvalidArgument,
            formatted("the largest turn of the walk is %g degrees; set it above 0 and not above 180", options.max_turn)};
  if (options.marked.empty())
    return Status::success();
  if (options.marked.size() != graph.size())
    return {StatusCode::InvalidInput,
            formatted("there are %.0f boundary flags for %.0f points; give one a point, or none to have them found",
                      static_cast<double>(options.marked.size()), static_cast<double>(graph.size()))};
  if (std::count(options.marked.begin(), options.marked.end(), 0) == static_cast<std::ptrdiff_t>(graph.size()))
    return {StatusCode::InvalidInput, "no point is marked as boundary; lower the threshold that marked them, or give no "
                                      "flags to have them found"};
  return Status::success();
}

/** The part of each triangle, after a check that only one of the parts is more than a speck. */
Status
checkParts(const SurfaceGraph& graph, const BoundaryOptions& options, std::vector<std::uint32_t>& parts,
           BoundaryCounts& counts)
{
  constexpr std::size_t most_named = 4;
  const Triangulation& mesh = graph.triangulation();
  std::vector<std::size_t> sizes;
  parts = mesh.parts(sizes);
  if (sizes.empty())
    return {StatusCode::InvalidInput, "the points make no surface: no three of them are neighbours of each other; "
                                      "check that the cloud is a surface and not a line or scattered points"};
  std::size_t large = 1;
  while (large < sizes.size() &&
         static_cast<double>(sizes[large]) > options.largest_left_out * static_cast<double>(mesh.triangleCount()))
    ++large;
  counts.left_out_parts = sizes.size() - 1;
  counts.left_out_triangles = mesh.triangleCount() - sizes[0];
  if (large == 1)
    return Status::success();
  std::string message = "the cloud has " + std::to_string(large) + " separate parts:";
  for (std::size_t part = 0; part < std::min(large, most_named); ++part) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t t = 0; t < mesh.triangleCount(); ++t)
      if (parts[t] == part)
        for (const std::uint32_t v : mesh.triangle(t))
          sum += graph.position(v);
    message += (part ? ", " : " ") + std::to_string(sizes[part]) + " triangles about " +
               place(sum / (3.0 * static_cast<double>(sizes[part])));
  }
  if (large > most_named)
    message += " and others";
  return {StatusCode::InvalidInput, message + "; keep the one to be machined and remove the others from the cloud"};
}

double
ringLength(const SurfaceGraph& graph, const Ring& ring)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += (graph.position(ring[i]) - graph.position(ring[(i + 1) % ring.size()])).norm();
  return sum;
}

double
ringArea(const SurfaceGraph& graph, const Ring& ring)
{
  const Eigen::Vector3d origin = graph.position(ring[0]);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    sum += (graph.position(ring[i]) - origin).cross(graph.position(ring[i + 1]) - origin);
  return 0.5 * sum.norm();
}

/** Whether a ring is shorter than a loop must be, or so thin that it encloses less than such a loop does. */
bool
isFlaw(const SurfaceGraph& graph, const Ring& ring, double shortest)
{
  return ringLength(graph, ring) < shortest || ringArea(graph, ring) < shortest * shortest / (4.0 * M_PI);
}

/** Largest distance between two points of a curve, to a factor of two: twice the distance from its mean. */
double
width(const Polyline& curve)
{
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : curve)
    mean += p / static_cast<double>(curve.size());
  double largest = 0.0;
  for (const Eigen::Vector3d& p : curve)
    largest = std::max(largest, (p - mean).norm());
  return 2.0 * largest;
}

void
classify(const SurfaceGraph& graph, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops)
{
  std::stable_sort(loops.begin(), loops.end(),
                   [](const BoundaryLoop& a, const BoundaryLoop& b) { return a.length > b.length; });
  for (BoundaryLoop& loop : loops) {
    const bool hole = options.min_hole_length > 0.0
                          ? loop.length >= options.min_hole_length
                          : loop.length >= loops.front().length / 8.0 &&
                                width(loop.curve) > options.largest_gap * graph.spacing();
    loop.type = hole ? LoopType::Inner : LoopType::ScanGap;
  }
  loops.front().type = LoopType::Outer;
}

/** Whether the longest loop is but a gap in the data of a surface closed otherwise. */
bool
isClosed(const SurfaceGraph& graph, const BoundaryOptions& options, const BoundaryLoop& longest)
{
  const double area = static_cast<double>(graph.size()) * graph.spacing() * graph.spacing();
  return width(longest.curve) <= options.largest_gap * graph.spacing() &&
         longest.length * longest.length < 0.1 * 4.0 * M_PI * area;
}

bool
isMarked(const SurfaceGraph& graph, const BoundaryOptions& options, std::uint32_t v)
{
  return options.marked[graph.blocks().originalIndex(v)] != 0;
}

/** Points of the surface to walk on, ascending: the marked ones, or those of the rings. */
std::vector<std::uint32_t>
pointsToWalk(const SurfaceGraph& graph, const BoundaryOptions& options, const std::vector<std::uint32_t>& parts,
             const std::vector<Ring>& rings)
{
  std::vector<std::uint8_t> wanted(graph.size(), 0);
  if (options.marked.empty()) {
    for (const Ring& ring : rings)
      for (const std::uint32_t v : ring)
        wanted[v] = 1;
  }
  else
    for (std::size_t t = 0; t < parts.size(); ++t)
      if (parts[t] == 0)
        for (const std::uint32_t v : graph.triangulation().triangle(t))
          wanted[v] = isMarked(graph, options, v);
  std::vector<std::uint32_t> points;
  for (std::uint32_t v = 0; v < wanted.size(); ++v)
    if (wanted[v])
      points.push_back(v);
  return points;
}

BoundaryLoop
loopOf(const SurfaceGraph& graph, const MlsSurface& surface, const Ring& ring)
{
  BoundaryLoop loop;
  for (const std::uint32_t v : ring) {
    loop.indices.push_back(graph.blocks().originalIndex(v));
    loop.points.push_back(graph.position(v));
  }
  Outline outline = fitOutline(surface, ring);
  loop.curve = std::move(outline.curve);
  loop.corners = std::move(outline.corners);
  loop.length = length(loop.curve, true);
  return loop;
}

/** Drop the loops of which less than half the points are marked; the outer one must not be among them. */
Status
keepMarked(const BoundaryOptions& options, std::vector<BoundaryLoop>& loops, std::size_t& dropped)
{
  if (options.marked.empty())
    return Status::success();
  const auto share = [&](const BoundaryLoop& loop) {
    const auto count = std::count_if(loop.indices.begin(), loop.indices.end(),
                                     [&](std::uint32_t i) { return options.marked[i] != 0; });
    return static_cast<double>(count) / static_cast<double>(loop.indices.size());
  };
  constexpr double least = 0.5;
  if (share(loops.front()) < least)
    return {StatusCode::InvalidInput,
            formatted("of the %.0f points of the outer boundary only %.0f %% are marked as boundary; mark them, or give "
                      "no flags to have the boundaries found",
                      static_cast<double>(loops.front().indices.size()), 100.0 * share(loops.front()))};
  const auto kept = std::remove_if(loops.begin() + 1, loops.end(),
                                   [&](const BoundaryLoop& loop) { return share(loop) < least; });
  dropped = static_cast<std::size_t>(loops.end() - kept);
  loops.erase(kept, loops.end());
  return Status::success();
}

} // namespace

Status
findBoundaryLoops(const MlsSurface& surface, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops,
                  BoundaryCounts* counts)
{
  const SurfaceGraph& graph = surface.graph();
  loops.clear();
  BoundaryCounts found;
  if (const Status status = checkOptions(graph, options); !status.ok())
    return status;
  std::vector<std::uint32_t> parts;
  if (const Status status = checkParts(graph, options, parts, found); !status.ok())
    return status;
  std::vector<Ring> rings = boundaryRings(graph.triangulation(), parts, 0);
  if (options.method == LoopMethod::Walk) {
    const std::vector<std::uint32_t> points = pointsToWalk(graph, options, parts, rings);
    WalkOptions walk;
    walk.max_turn = options.max_turn * M_PI / 180.0;
    walk.shortest = options.shortest_loop;
    if (const Status status = walkRings(graph, points, walk, rings, found.left_out_loops); !status.ok())
      return status;
  }
  for (const Ring& ring : rings)
    if (isFlaw(graph, ring, options.shortest_loop * graph.spacing()))
      ++found.left_out_loops;
    else
      loops.push_back(loopOf(graph, surface, ring));
  Status status = {StatusCode::InvalidInput, "the surface is closed: it has no boundary for a spiral to end at; cut the "
                                             "cloud down to the side to be machined"};
  if (!loops.empty()) {
    classify(graph, options, loops);
    if (!isClosed(graph, options, loops.front()))
      status = keepMarked(options, loops, found.unmarked_loops);
  }
  if (!status.ok())
    loops.clear();
  if (counts)
    *counts = found;
  return status;
}

Status
findBoundaryLoops(const SurfaceGraph& graph, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops,
                  BoundaryCounts* counts)
{
  return findBoundaryLoops(MlsSurface(graph), options, loops, counts);
}

} // namespace pcl_spiral
