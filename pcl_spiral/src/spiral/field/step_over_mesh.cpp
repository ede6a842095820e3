// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/spiral/impl/step_over_mesh.h>

#include "common/stoppable_loop.h"
#include "core/median.h"
#include "rim_zipper.h"
#include "spiral/outlines/handle_loop.h"
#include "spiral/outlines/narrow_strip.h"
#include "spiral/outlines/outline_cut.h"
#include "spiral/outlines/outline_side.h"

#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

using Triangle = Triangulation::Triangle;

constexpr double outline_step = 0.8;   // spacings between nodes on an outline
constexpr double matched_reach = 12.0; // spacings within which points of an edge are searched
constexpr double matched_edge = 2.5;   // spacings: median distance of an edge from its outline
constexpr double least_zipped = 0.7;   // share of an outline that its edge must follow

/** Makes the mesh. */
class MeshMaker {
public:
  MeshMaker(const Surface& surface, const std::vector<BoundaryLoop>& outlines, const StepOverOptions& options, StepOverMesh& mesh)
  : surface_(surface), outlines_(outlines), options_(options), mesh_(mesh), side_(outlines), spacing_(surface.spacing())
  {}

  Status run()
  {
    placeNodes();
    if (const Status status = keepWithin(); !status.ok())
      return status;
    for (std::size_t o = 0; o < outlines_.size(); ++o)
      if (const Status status = zip(o); !status.ok())
        return status;
    closeRest();
    dropUnused();
    return checkGenus();
  }

private:
  /** Feet and metric of the surface's points. The metric is the mean over the points about each, because curvatures are noisy. */
  void placeNodes();
  Status keepWithin();
  ZipperSide sideOf(std::size_t free_edge, std::size_t outline, double& distance) const;
  std::size_t edgeAlong(std::size_t outline, ZipperSide& side) const;
  Status zip(std::size_t outline);
  void addOutline(std::size_t outline, ZipperSide& side);
  void closeRest();
  void dropUnused();
  Status checkGenus() const;

  const Surface& surface_;
  const std::vector<BoundaryLoop>& outlines_;
  StepOverOptions options_;
  StepOverMesh& mesh_;
  OutlineSide side_;
  double spacing_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<std::uint32_t>> edges_; ///< nodes of the free edges, the surface on their left
  std::vector<std::uint8_t> edge_used_;
};

std::vector<StepOverMetric>
averaged(const std::vector<StepOverMetric>& metric, const Triangulation& triangles)
{
  std::vector<StepOverMetric> mean(metric.size());
  const auto count = static_cast<std::int64_t>(metric.size());
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t v = 0; v < count; ++v) {
    StepOverMetric sum = metric[v];
    int terms = 1;
    for (std::size_t i = triangles.outgoingBegin(v); i < triangles.outgoingBegin(v + 1); ++i, ++terms)
      sum += metric[triangles.target(triangles.outgoing(i))];
    mean[v] = sum.times(1.0 / terms);
  }
  return mean;
}

void
MeshMaker::placeNodes()
{
  const std::size_t n = surface_.size();
  mesh_.positions.resize(n);
  mesh_.normals.resize(n);
  mesh_.metric.resize(n);
  const double kept = (1.0 - options_.reserve) * (1.0 - options_.reserve);
  std::vector<Eigen::Vector3d> points;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < n; begin += report_chunk) {
    const auto count = static_cast<std::int64_t>(std::min(report_chunk, n - begin));
    points.resize(static_cast<std::size_t>(count));
    for (std::int64_t k = 0; k < count; ++k)
      points[k] = surface_.position(begin + k);
    surface_.fit().project(points, feet);
#pragma omp parallel for schedule(static, 4096)
    for (std::int64_t k = 0; k < count; ++k) {
      const SurfaceFoot& foot = feet[k];
      const Eigen::Vector3d normal = foot.valid ? foot.normal : surface_.normal(begin + k);
      mesh_.positions[begin + k] = foot.valid ? foot.position : points[k];
      mesh_.normals[begin + k] = normal.cast<float>();
      const Eigen::Vector3d direction = foot.valid ? foot.direction1 : normal.unitOrthogonal();
      mesh_.metric[begin + k] = stepOverMetric(normal, direction, foot.valid ? foot.curvature1 : 0.0, foot.valid ? foot.curvature2 : 0.0,
                                               options_.tool_radius, options_.scallop_height)
                                    .times(1.0 / kept);
    }
  }
  const int rings = 1 + static_cast<int>(std::min(3.0, std::round(10.0 * surface_.noise() / options_.scallop_height)));
  for (int r = 0; r < rings; ++r)
    mesh_.metric = averaged(mesh_.metric, surface_.graph().triangulation());
}

Status
MeshMaker::keepWithin()
{
  Triangulation rest;
  if (const Status status = trianglesWithin(mesh_, surface_.graph().triangulation(), side_, spacing_, rest); !status.ok())
    return status;
  edges_ = rest.boundaryLoops();
  for (std::vector<std::uint32_t>& edge : edges_)
    for (std::uint32_t& h : edge)
      h = rest.origin(h);
  edge_used_.assign(edges_.size(), 0);
  triangles_ = std::move(rest).release();
  return Status::success();
}

void
MeshMaker::addOutline(std::size_t outline, ZipperSide& side)
{
  const BoundaryLoop& loop = outlines_[outline];
  const std::vector<double> arcs = arcLengths(loop.curve, true);
  std::vector<double> stops;
  for (const std::size_t c : loop.corners)
    stops.push_back(arcs[c % loop.curve.size()]);
  std::sort(stops.begin(), stops.end());
  stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
  if (stops.empty())
    stops.push_back(0.0);
  const std::size_t first = mesh_.size();
  mesh_.rims.emplace_back();
  for (std::size_t s = 0; s < stops.size(); ++s) {
    const double end = s + 1 < stops.size() ? stops[s + 1] : stops[0] + arcs.back();
    const auto steps = std::max<std::size_t>(2, static_cast<std::size_t>(std::lround((end - stops[s]) / (outline_step * spacing_))));
    for (std::size_t i = 0; i < steps; ++i)
      side.arcs.push_back(std::fmod(stops[s] + (end - stops[s]) * static_cast<double>(i) / static_cast<double>(steps), arcs.back()));
  }
  std::sort(side.arcs.begin(), side.arcs.end());
  for (const double arc : side.arcs) {
    const auto at = std::min<std::size_t>(loop.curve.size() - 1,
                                          static_cast<std::size_t>(std::upper_bound(arcs.begin(), arcs.end(), arc) - arcs.begin()) - 1);
    const double share = (arc - arcs[at]) / std::max(arcs[at + 1] - arcs[at], 1e-300);
    const Eigen::Vector3d p = loop.curve[at] + share * (loop.curve[(at + 1) % loop.curve.size()] - loop.curve[at]);
    const std::uint32_t nearest = surface_.graph().blocks().nearest(p);
    mesh_.rims.back().push_back(static_cast<std::uint32_t>(mesh_.size()));
    mesh_.positions.push_back(p);
    mesh_.normals.push_back(mesh_.normals[nearest]);
    mesh_.metric.push_back(mesh_.metric[nearest]);
  }
  side.ids = mesh_.rims.back();
  side.points.assign(mesh_.positions.begin() + static_cast<std::ptrdiff_t>(first), mesh_.positions.end());
}

/** Nodes of the free edge with their arc lengths along \p outline. \p distance: their median distance from it, mm. */
ZipperSide
MeshMaker::sideOf(std::size_t free_edge, std::size_t outline, double& distance) const
{
  ZipperSide side;
  std::vector<double> distances;
  for (const std::uint32_t v : edges_[free_edge]) {
    OutlinePlace place;
    if (!side_.find(mesh_.positions[v], mesh_.normals[v].cast<double>(), matched_reach * spacing_, place) || place.outline != outline)
      place.distance = 1e30;
    distances.push_back(place.distance);
    side.ids.push_back(v);
    side.points.push_back(mesh_.positions[v]);
    side.normals.push_back(mesh_.normals[v].cast<double>());
    side.arcs.push_back(place.arc);
  }
  distance = medianOf(std::move(distances));
  return side;
}

/** The longest free edge that runs along \p outline; the number of free edges if none does. */
std::size_t
MeshMaker::edgeAlong(std::size_t outline, ZipperSide& side) const
{
  std::size_t best = edges_.size();
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (edge_used_[e] || edges_[e].size() < 6 || (best < edges_.size() && edges_[e].size() <= edges_[best].size()))
      continue;
    double distance = 0.0;
    ZipperSide candidate = sideOf(e, outline, distance);
    if (distance < matched_edge * spacing_) {
      best = e;
      side = std::move(candidate);
    }
  }
  return best;
}

Status
MeshMaker::zip(std::size_t outline)
{
  ZipperSide edge;
  const std::size_t best = edgeAlong(outline, edge);
  const Diagnostic remedy = "; the {scan} is too sparse or ragged there for a path at constant scallop: {scan it again, more densely}, ";
  const Diagnostic radial = "choose the radial method ({setMethod})";
  if (best == edges_.size())
    if (const Status status = refuseNarrowStrip(outlines_, outline, spacing_); !status.ok())
      return status;
  if (best == edges_.size())
    return {StatusCode::Failed,
            Diagnostic("no edge of the mesh runs along the outline through ", Place(outlines_[outline].curve.front()), remedy,
                       keepOutText(outlines_[outline].type == LoopType::Outer ? Polyline() : outlines_[outline].curve, spacing_), radial)};
  edge_used_[best] = 1;
  ZipperSide rim;
  addOutline(outline, rim);
  const double whole = length(outlines_[outline].curve, true);
  const std::vector<Triangle> strip = zipped(edge, rim, whole, spacing_);
  if (strip.empty())
    return {StatusCode::Failed,
            Diagnostic("the edge of the mesh follows the outline through ", Place(outlines_[outline].curve.front()), " over less than ",
                       100.0 * least_zipped, " % of its length", remedy, keepOutText(pointsApart(edge, rim, spacing_), spacing_), radial)};
  triangles_.insert(triangles_.end(), strip.begin(), strip.end());
  return Status::success();
}

void
MeshMaker::closeRest()
{
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (edge_used_[e])
      continue;
    const std::vector<std::uint32_t>& edge = edges_[e];
    Eigen::Vector3d centre = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
    StepOverMetric metric;
    for (const std::uint32_t v : edge) {
      centre += mesh_.positions[v] / static_cast<double>(edge.size());
      normal += mesh_.normals[v].cast<double>();
      metric += mesh_.metric[v].times(1.0 / static_cast<double>(edge.size()));
    }
    const auto middle = static_cast<std::uint32_t>(mesh_.size());
    mesh_.positions.push_back(centre);
    mesh_.normals.push_back(normal.normalized().cast<float>());
    mesh_.metric.push_back(metric);
    for (std::size_t i = 0; i < edge.size(); ++i)
      triangles_.push_back({edge[(i + 1) % edge.size()], edge[i], middle});
  }
}

void
MeshMaker::dropUnused()
{
  std::vector<std::uint32_t> index(mesh_.size(), Triangulation::none);
  for (const Triangle& t : triangles_)
    for (const std::uint32_t v : t)
      index[v] = 0;
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < index.size(); ++v) {
    if (index[v] == Triangulation::none)
      continue;
    mesh_.positions[count] = mesh_.positions[v];
    mesh_.normals[count] = mesh_.normals[v];
    mesh_.metric[count] = mesh_.metric[v];
    index[v] = count++;
  }
  mesh_.positions.resize(count);
  mesh_.normals.resize(count);
  mesh_.metric.resize(count);
  const auto triangle_count = static_cast<std::int64_t>(triangles_.size());
#pragma omp parallel for schedule(static, 4096)
  for (std::int64_t t = 0; t < triangle_count; ++t)
    for (std::uint32_t& v : triangles_[t])
      v = index[v];
  for (std::vector<std::uint32_t>& rim : mesh_.rims)
    for (std::uint32_t& v : rim)
      v = index[v];
  mesh_.triangles = Triangulation(count, std::move(triangles_));
}

Status
MeshMaker::checkGenus() const
{
  if (missingEuler(mesh_.positions, mesh_.triangles) != 0)
    return {StatusCode::Failed, Diagnostic("the surface about ", Place(mesh_.positions.front()),
                                           " has a handle or touches itself: a path at constant scallop needs a sheet with only a rim "
                                           "and holes; cut the part into pieces")};
  return Status::success();
}

} // namespace

Status
makeStepOverMesh(const Surface& surface, const std::vector<BoundaryLoop>& outlines, const StepOverOptions& options, StepOverMesh& mesh)
{
  mesh = StepOverMesh();
  return MeshMaker(surface, outlines, options, mesh).run();
}

} // namespace pcl_spiral
