#include <pcl_spiral/features/surface_boundary.h>

#include <pcl_spiral/surface/mls_surface.h>

#include "loop_rings.h"
#include "outline.h"

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
checkOptions(const BoundaryOptions& options)
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

} // namespace

Status
findBoundaryLoops(const SurfaceGraph& graph, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops,
                  BoundaryCounts* counts)
{
  loops.clear();
  BoundaryCounts found;
  if (const Status status = checkOptions(options); !status.ok())
    return status;
  std::vector<std::uint32_t> parts;
  if (const Status status = checkParts(graph, options, parts, found); !status.ok())
    return status;

  const MlsSurface surface(graph);
  for (const Ring& ring : boundaryRings(graph.triangulation(), parts, 0)) {
    if (ringLength(graph, ring) < options.shortest_loop * graph.spacing()) {
      ++found.left_out_loops;
      continue;
    }
    BoundaryLoop loop;
    for (const std::uint32_t v : ring) {
      loop.indices.push_back(graph.blocks().originalIndex(v));
      loop.points.push_back(graph.position(v));
    }
    Outline outline = fitOutline(surface, ring);
    loop.curve = std::move(outline.curve);
    loop.corners = std::move(outline.corners);
    loop.length = length(loop.curve, true);
    loops.push_back(std::move(loop));
  }
  if (counts)
    *counts = found;
  if (!loops.empty())
    classify(graph, options, loops);
  if (loops.empty() || isClosed(graph, options, loops.front())) {
    loops.clear();
    return {StatusCode::InvalidInput, "the surface is closed: it has no boundary for a spiral to end at; cut the "
                                      "cloud down to the side to be machined"};
  }
  return Status::success();
}

} // namespace pcl_spiral
