// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/features/impl/boundary_loops_engine.h>

#include <pcl_spiral/core/diagnostic.h>

#include "boundary_walk.h"
#include "loop_rings.h"
#include "outline.h"
#include "part_check.h"
#include "void_rings.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace pcl_spiral {
namespace {

Status
checkOptions(const SurfaceGraph& graph, const BoundaryOptions& options)
{
  if (!(options.min_hole_length >= 0.0) || !std::isfinite(options.min_hole_length))
    return {StatusCode::InvalidArgument, Diagnostic("the shortest length of a hole is ", options.min_hole_length,
                                                    "; set it above 0, or to 0 for an eighth of the outer boundary")};
  if (!(options.min_hole_width >= 0.0) || !std::isfinite(options.min_hole_width))
    return {StatusCode::InvalidArgument,
            Diagnostic("the least width of a hole is ", options.min_hole_width, "; set it above 0, or to 0 to have it found")};
  if (!(options.largest_gap >= 0.0) || !(options.shortest_loop >= 0.0))
    return {StatusCode::InvalidArgument, Diagnostic("the largest gap is ", options.largest_gap, " spacings, the shortest loop ",
                                                    options.shortest_loop, "; set both to 0 or more")};
  if (!(options.largest_left_out >= 0.0 && options.largest_left_out <= 1.0))
    return {StatusCode::InvalidArgument,
            Diagnostic("the share of a part that may be left out is ", options.largest_left_out, "; set it between 0 and 1")};
  if (!(options.max_turn > 0.0 && options.max_turn <= 180.0))
    return {StatusCode::InvalidArgument,
            Diagnostic("the largest turn of the walk is ", options.max_turn, " {degrees}; set it above 0, at most to 180")};
  if (options.marked.empty())
    return Status::success();
  if (options.marked.size() != graph.size())
    return {StatusCode::InvalidInput, Diagnostic("there are ", options.marked.size(), " boundary flags for ", graph.size(),
                                                 " points; give one flag per point, or none to have the boundary found")};
  if (std::count(options.marked.begin(), options.marked.end(), 0) == static_cast<std::ptrdiff_t>(graph.size()))
    return {StatusCode::InvalidInput, "no point is marked as boundary; lower the threshold that marks points, or give no "
                                      "flags to have the boundary found"};
  return Status::success();
}

/** Largest distance between two points of a curve, within a factor of two: twice the distance from its mean. */
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
  std::stable_sort(loops.begin(), loops.end(), [](const BoundaryLoop& a, const BoundaryLoop& b) { return a.length > b.length; });
  for (BoundaryLoop& loop : loops) {
    const bool hole = options.min_hole_width > 0.0 ? width(loop.curve) >= options.min_hole_width
                      : options.min_hole_length > 0.0
                          ? loop.length >= options.min_hole_length
                          : loop.length >= loops.front().length / 8.0 && width(loop.curve) > options.largest_gap * graph.spacing();
    loop.type = hole ? LoopType::Inner : LoopType::ScanGap;
  }
  if (!loops.empty())
    loops.front().type = LoopType::Outer;
}

/** Refuse a surface that is only boundary: a ring encloses too little to be a loop, but is as long as the cloud. */
Status
checkWidth(const SurfaceGraph& graph, const std::vector<Ring>& rings)
{
  for (const Ring& ring : rings)
    if (const double length = ringLength(graph, ring); length > graph.blocks().box().diagonal())
      return {StatusCode::InvalidInput,
              Diagnostic("the surface is too narrow for the spacing of its points: its boundary at ", Place(graph.position(ring.front())),
                         ", ", length, " {mm} long, encloses only ", ringArea(graph, ring), " {mm2}, and points lie ", graph.spacing(),
                         " {mm} apart: {scan more densely}, with at least seven points across it")};
  return Status::success();
}

/** Refuse a surface whose longest loop, if it has one, is only a gap in the data. */
Status
checkOpen(const SurfaceGraph& graph, const BoundaryOptions& options, const std::vector<BoundaryLoop>& loops)
{
  Diagnostic only_gap;
  if (!loops.empty()) {
    const BoundaryLoop& longest = loops.front();
    const double area = static_cast<double>(graph.size()) * graph.spacing() * graph.spacing();
    const double across = width(longest.curve);
    if (across > options.largest_gap * graph.spacing() || longest.length * longest.length >= 0.1 * 4.0 * pi * area)
      return Status::success();
    only_gap =
        Diagnostic(" (its longest loop, ", across, " {mm} across at ", Place(longest.curve.front()), ", is only {a gap in the scan})");
  }
  const Box box = graph.blocks().box();
  const Eigen::Vector3d low = Eigen::Map<const Eigen::Vector3f>(box.low.data()).cast<double>();
  const Eigen::Vector3d high = Eigen::Map<const Eigen::Vector3f>(box.high.data()).cast<double>();
  return {StatusCode::InvalidInput,
          Diagnostic("the surface from ", Place(low), " to ", Place(high), " is closed: it has no boundary where a path can begin or end",
                     only_gap, "; keep only the side to be machined")};
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
loopOf(const SurfaceGraph& graph, const MlsSurface& surface, const Ring& ring, const std::function<bool()>& goOn)
{
  BoundaryLoop loop;
  for (const std::uint32_t v : ring) {
    loop.indices.push_back(static_cast<pcl::index_t>(graph.blocks().originalIndex(v)));
    loop.points.push_back(graph.position(v));
  }
  Outline outline = fitOutline(surface, ring, goOn);
  loop.curve = std::move(outline.curve);
  loop.corners = std::move(outline.corners);
  loop.length = length(loop.curve, true);
  return loop;
}

/** Fit a loop to every ring that is no flaw. Curves have two nodes per spacing. A ring with points far sparser than the rest of the
 *  cloud is refused: its curve would need far too many nodes. */
Status
fitLoops(const MlsSurface& surface, const BoundaryOptions& options, const std::vector<Ring>& rings, std::vector<BoundaryLoop>& loops,
         BoundaryReport& found)
{
  constexpr double sparsest = 32.0; // spacings between the points of a ring
  constexpr double fits = 8.0;      // of one ring
  const SurfaceGraph& graph = surface.graph();
  double all = 0.0, done = 0.0;
  for (const Ring& ring : rings)
    all += static_cast<double>(ring.size());
  for (const Ring& ring : rings) {
    const auto size = static_cast<double>(ring.size()), apart = ringLength(graph, ring) / size;
    double fit = 0.0;
    bool going = true;
    const auto goOn = [&] {
      fit = std::min(fit + 1.0, fits);
      going = going && (!options.progress || options.progress((done + size * fit / (fits + 1.0)) / all));
      return going;
    };
    if (isFlaw(graph, ring, options.shortest_loop * graph.spacing()))
      ++found.left_out_loops;
    else if (apart > sparsest * graph.spacing())
      return {StatusCode::InvalidInput,
              Diagnostic("the points of the boundary at ", Place(graph.position(ring.front())), " are ", apart, " {mm} apart, ",
                         apart / graph.spacing(), " times as far as usual in the {scan} (", graph.spacing(),
                         " {mm}): the {scan} is much denser elsewhere; thin it to an even spacing ({setThinning} ",
                         Proposed("setThinning", apart), "), or leave the dense part out")};
    else
      loops.push_back(loopOf(graph, surface, ring, goOn));
    done += size;
    if (!going || (options.progress && !options.progress(done / all)))
      return {StatusCode::Cancelled, "cancelled"};
  }
  return Status::success();
}

/** Drop the loops of which less than half the points are marked; the outer one must not be among them. */
Status
keepMarked(const BoundaryOptions& options, std::vector<BoundaryLoop>& loops, std::size_t& dropped)
{
  if (options.marked.empty())
    return Status::success();
  const auto share = [&](const BoundaryLoop& loop) {
    const auto count = std::count_if(loop.indices.begin(), loop.indices.end(),
                                     [&](pcl::index_t i) { return options.marked[static_cast<std::size_t>(i)] != 0; });
    return static_cast<double>(count) / static_cast<double>(loop.indices.size());
  };
  constexpr double least = 0.5;
  if (share(loops.front()) < least)
    return {StatusCode::InvalidInput,
            Diagnostic("of the ", loops.front().indices.size(), " points of the outer boundary only ",
                       std::round(100.0 * share(loops.front())),
                       " % are marked as boundary; mark all of them, or give no flags to have the boundaries found")};
  const auto kept = std::remove_if(loops.begin() + 1, loops.end(), [&](const BoundaryLoop& loop) { return share(loop) < least; });
  dropped = static_cast<std::size_t>(loops.end() - kept);
  loops.erase(kept, loops.end());
  return Status::success();
}

} // namespace

Status
findBoundaryLoops(const MlsSurface& surface, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops, BoundaryReport* counts)
{
  const SurfaceGraph& graph = surface.graph();
  loops.clear();
  BoundaryReport found;
  if (const Status status = checkOptions(graph, options); !status.ok())
    return status;
  std::vector<std::uint32_t> parts;
  if (const Status status = checkParts(graph, options, parts, found); !status.ok())
    return status;
  std::vector<Ring> rings =
      options.min_hole_width > 0.0 ? ringsWithVoids(graph, parts, options.min_hole_width) : boundaryRings(graph.triangulation(), parts, 0);
  if (options.method == LoopMethod::Walk) {
    const std::vector<std::uint32_t> points = pointsToWalk(graph, options, parts, rings);
    WalkOptions walk;
    walk.max_turn = options.max_turn * pi / 180.0;
    walk.shortest = options.shortest_loop;
    if (const Status status = walkRings(graph, points, walk, rings, found.left_out_loops); !status.ok())
      return status;
  }
  Status status = fitLoops(surface, options, rings, loops, found);
  if (status.ok() && loops.empty())
    status = checkWidth(graph, rings);
  if (status.ok()) {
    classify(graph, options, loops);
    status = checkOpen(graph, options, loops);
  }
  if (status.ok())
    status = keepMarked(options, loops, found.unmarked_loops);
  if (!status.ok())
    loops.clear();
  if (counts)
    *counts = found;
  return status;
}

Status
findBoundaryLoops(const Surface& surface, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops, BoundaryReport* counts)
{
  const Status status = findBoundaryLoops(surface.fit(), options, loops, counts);
  for (BoundaryLoop& loop : loops)
    for (pcl::index_t& index : loop.indices)
      index = static_cast<pcl::index_t>(surface.sourceOfOriginal(static_cast<std::size_t>(index)));
  return status;
}

Status
findBoundaryLoops(const SurfaceGraph& graph, const BoundaryOptions& options, std::vector<BoundaryLoop>& loops, BoundaryReport* counts)
{
  return findBoundaryLoops(MlsSurface(graph), options, loops, counts);
}

} // namespace pcl_spiral
