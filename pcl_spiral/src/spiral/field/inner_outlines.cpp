// SPDX-License-Identifier: BSD-3-Clause
#include "inner_outlines.h"

#include "step_over_march.h"

#include "graph/level_lines.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr double corner_turn = 40.0 * pi / 180.0;
constexpr double curve_step = 0.5;   // spacings between points of a curve
constexpr int corner_reach = 3;      // points of a curve on either side, over which its bend is measured
constexpr double piece_share = 0.01; // of the nodes inside: a smaller piece is a splinter of the triangles

/** Points at which a closed curve bends most sharply, measured over a few points. */
std::vector<std::size_t>
sharpTurns(const Polyline& curve)
{
  const std::size_t n = curve.size();
  std::vector<double> turn(n, 0.0);
  for (std::size_t i = 0; i < n && n > 4 * corner_reach; ++i) {
    const Eigen::Vector3d in = curve[i] - curve[(i + n - corner_reach) % n], out = curve[(i + corner_reach) % n] - curve[i];
    turn[i] = std::acos(std::clamp(in.normalized().dot(out.normalized()), -1.0, 1.0));
  }
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < n; ++i) {
    bool sharpest = turn[i] > corner_turn;
    for (int k = 1; k <= corner_reach && sharpest; ++k)
      sharpest = turn[i] > turn[(i + n - k) % n] && turn[i] >= turn[(i + k) % n];
    if (sharpest)
      corners.push_back(i);
  }
  return corners;
}

/** The connected part of each node above 0, by triangles with all corners above 0. The largest part has the number 0. */
std::vector<std::uint32_t>
partsAbove(const StepOverMesh& mesh, const std::vector<double>& height, std::vector<std::size_t>& sizes)
{
  std::vector<std::uint32_t> part(mesh.size(), Triangulation::none);
  std::vector<std::uint32_t> stack;
  sizes.clear();
  for (std::uint32_t first = 0; first < mesh.size(); ++first) {
    if (height[first] <= 0.0 || part[first] != Triangulation::none)
      continue;
    const auto number = static_cast<std::uint32_t>(sizes.size());
    sizes.push_back(0);
    stack.assign(1, first);
    part[first] = number;
    while (!stack.empty()) {
      const std::uint32_t v = stack.back();
      stack.pop_back();
      ++sizes[number];
      for (std::uint32_t o = mesh.triangles.outgoingBegin(v); o < mesh.triangles.outgoingBegin(v + 1); ++o)
        for (const std::uint32_t w : mesh.triangles.triangle(mesh.triangles.outgoing(o) / 3))
          if (height[w] > 0.0 && part[w] == Triangulation::none) {
            part[w] = number;
            stack.push_back(w);
          }
    }
  }
  return part;
}

/** The settings that move \p loops inside by \p margins. */
const char*
settersOf(const std::vector<BoundaryLoop>& loops, const std::vector<double>& margins)
{
  bool rim = false, holes = false;
  for (std::size_t i = 0; i < loops.size(); ++i)
    (loops[i].type == LoopType::Outer ? rim : holes) |= margins[i] > 0.0;
  return !holes ? " ({setRimOverhang})" : !rim ? " ({setHoleMargin})" : " ({setRimOverhang}, {setHoleMargin})";
}

/** Ok, or an error with the place if the rest of the surface falls into pieces. \p setters: what makes the distance. */
Status
checkWhole(const StepOverMesh& mesh, const std::vector<double>& height, const char* setters)
{
  std::vector<std::size_t> sizes;
  const std::vector<std::uint32_t> part = partsAbove(mesh, height, sizes);
  if (sizes.empty())
    return {StatusCode::InvalidInput,
            Diagnostic("at this distance inside its rims nothing is left of the surface: make the distance smaller", setters)};
  const auto largest = static_cast<std::uint32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  const std::size_t all = std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  for (std::uint32_t p = 0; p < sizes.size(); ++p)
    if (p != largest && static_cast<double>(sizes[p]) > piece_share * static_cast<double>(all)) {
      const std::size_t v = static_cast<std::size_t>(std::find(part.begin(), part.end(), p) - part.begin());
      return {StatusCode::InvalidInput,
              Diagnostic("at this distance inside its rims the surface falls into pieces, one of them near ", Place(mesh.positions[v]),
                         ": the surface is narrower than twice the distance; make the distance smaller", setters)};
    }
  return Status::success();
}

/** A level line in space, at even steps. */
Polyline
curveOf(const StepOverMesh& mesh, const LevelLine& line, double step)
{
  Polyline points;
  for (const LevelCrossing& c : line.crossings)
    points.push_back((1.0 - c.share) * mesh.positions[c.below] + c.share * mesh.positions[c.above]);
  const double around = length(points, true);
  return resampled(points, std::max<std::size_t>(8, static_cast<std::size_t>(std::ceil(around / step))), true);
}

double
distanceTo(const Polyline& curve, const Eigen::Vector3d& place)
{
  double least = (curve.front() - place).norm();
  for (const Eigen::Vector3d& p : curve)
    least = std::min(least, (p - place).norm());
  return least;
}

/** Whether a part of \p curve lies \p margin from \p rim. */
bool
cameFrom(const Polyline& curve, const Polyline& rim, double margin, double spacing)
{
  constexpr std::size_t samples = 48;
  for (std::size_t k = 0; k < samples; ++k)
    if (distanceTo(rim, curve[k * curve.size() / samples]) < margin + spacing)
      return true;
  return false;
}

} // namespace

BoundaryLoop
loopAlong(const Surface& surface, Polyline curve, LoopType type)
{
  BoundaryLoop loop;
  loop.type = type;
  loop.length = length(curve, true);
  loop.corners = sharpTurns(curve);
  std::uint32_t last = Triangulation::none;
  for (const Eigen::Vector3d& p : curve)
    if (const std::uint32_t nearest = surface.graph().blocks().nearest(p); nearest != last) {
      loop.points.push_back(surface.position(nearest));
      loop.indices.push_back(static_cast<pcl::index_t>(surface.sourceIndex(nearest)));
      last = nearest;
    }
  loop.curve = std::move(curve);
  return loop;
}

Status
moveInside(const Surface& surface, const std::vector<double>& margins, std::vector<BoundaryLoop>& loops)
{
  std::vector<BoundaryLoop> outlines, result;
  std::vector<double> starts;
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (loops[i].type != LoopType::ScanGap) {
      outlines.push_back(loops[i]);
      starts.push_back(margins[i] > 0.0 ? -margins[i] : std::numeric_limits<double>::infinity());
    }
  StepOverOptions options; // lengths are in mm here, so the cutter does not matter
  options.tool_radius = surface.spacing();
  options.scallop_height = 0.1 * surface.spacing();
  StepOverMesh mesh;
  if (const Status status = makeStepOverMesh(surface, outlines, options, mesh); !status.ok())
    return status;
  std::fill(mesh.metric.begin(), mesh.metric.end(), StepOverMetric(Eigen::Matrix3d::Identity()));
  const std::vector<double> height = distancesFromRims(mesh, starts);
  const char* const setters = settersOf(loops, margins);
  if (const Status status = checkWhole(mesh, height, setters); !status.ok())
    return status;
  const double spacing = surface.spacing();
  std::size_t outer = 0;
  const std::vector<std::vector<LevelLine>> lines = levelLines(mesh.triangles, height, {0.0});
  for (const LevelLine& line : lines.front()) {
    if (!line.closed)
      return {StatusCode::InvalidInput,
              Diagnostic("the outline moved inside meets another outline at ", Place(mesh.positions[line.crossings.front().below]),
                         ": make the distance smaller ({setRimOverhang}), or keep away from holes too ({setHoleMargin})")};
    Polyline curve = curveOf(mesh, line, curve_step * spacing);
    if (length(curve, true) < 8.0 * spacing)
      continue;
    bool is_outer = false;
    for (std::size_t o = 0; o < outlines.size(); ++o)
      if (outlines[o].type == LoopType::Outer && std::isfinite(starts[o]))
        is_outer = is_outer || cameFrom(curve, outlines[o].curve, -starts[o], spacing);
    outer += is_outer;
    result.push_back(loopAlong(surface, std::move(curve), is_outer ? LoopType::Outer : LoopType::Inner));
  }
  for (std::size_t i = 0; i < loops.size(); ++i)
    if (loops[i].type == LoopType::ScanGap || margins[i] <= 0.0) {
      outer += loops[i].type == LoopType::Outer;
      result.push_back(loops[i]);
    }
  if (outer != 1)
    return {StatusCode::InvalidInput,
            Diagnostic("at this distance inside its rims the surface has ", outer, " outer outlines: make the distance smaller", setters)};
  std::stable_partition(result.begin(), result.end(), [](const BoundaryLoop& loop) { return loop.type == LoopType::Outer; });
  loops = std::move(result);
  return Status::success();
}

} // namespace pcl_spiral
