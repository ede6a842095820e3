// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>

#include <pcl_spiral/core/impl/tolerances.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

#include "cleaning/standing_clusters.h"
#include "surface/noise_warning.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/frame.h>
#include <pcl_spiral/features/impl/boundary_loops_engine.h>
#include <pcl_spiral/surface/impl/side_text.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

/** Area between the outermost points and the outline, from the distance of the outline outside each point. */
double
stripOutside(const BoundaryLoop& loop, const MoveIndex& outline, const SurfaceGraph& graph)
{
  double area = 0.0;
  const std::size_t n = loop.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d& p = loop.points[i];
    const Eigen::Vector3d chord = loop.points[(i + 1) % n] - loop.points[(i + n - 1) % n];
    const Eigen::Vector3d outward = chord.cross(graph.normal(graph.blocks().nearest(p)));
    Eigen::Vector3d foot = p;
    double distance = 10.0 * graph.spacing();
    if (outline.nearest(p, distance, foot))
      area += 0.5 * chord.norm() * ((foot - p).dot(outward) < 0.0 ? -distance : distance);
  }
  return area;
}

} // namespace

ReferenceSurface::ReferenceSurface(Surface::ConstPtr surface)
: scanned_(std::move(surface)), surface_(scanned_->graph(), 0, ProjectionMethod::RobustQuartic)
{
  if (outlierPoints() > 0)
    warnings_.push_back(Diagnostic(outlierPoints(), " outliers of the reference were left out"));
  if (const std::vector<StandingCluster>& clusters = scanned_->clusters(); !clusters.empty())
    warnings_.push_back(Diagnostic(clustersText(clusters, scanned_->spacing()),
                                   (scanned_->settings().clusters == ClusterHandling::Ride
                                        ? "; the ball must ride over what is there"
                                        : "; what is there is not judged ({setClusterHandling(ClusterHandling::LeaveOut)})")));
  for (const Diagnostic& warning : sideWarnings(scanned_->side()))
    warnings_.push_back(warning);
  findRim();
}

void
ReferenceSurface::findRim()
{
  if (const Status status = findBoundaryLoops(*scanned_, BoundaryOptions(), loops_); !status.ok()) {
    warnings_.push_back(
        Diagnostic("the rim of the reference was not found, so the band along it is not judged separately: ", status.diagnostic()));
    return;
  }
  for (const BoundaryLoop& loop : loops_) {
    if (loop.type == LoopType::ScanGap) {
      addGap(loop);
      continue;
    }
    rims_.push_back(loop.curve);
    rims_.back().push_back(loop.curve.front());
    outermost_.push_back(loop.points);
    outermost_.back().push_back(loop.points.front());
    rim_length_ += loop.length;
  }
  indexRims();
  std::size_t k = 0;
  for (const BoundaryLoop& loop : loops_)
    if (loop.type != LoopType::ScanGap)
      rim_strip_ += stripOutside(loop, *rim_index_[k++], graph());
}

void
ReferenceSurface::indexRims()
{
  for (const Polyline& rim : rims_) // the rims do not move any more
    rim_index_.push_back(std::make_unique<MoveIndex>(rim));
  for (const Polyline& line : outermost_)
    outermost_index_.push_back(std::make_unique<MoveIndex>(line));
}

void
ReferenceSurface::addGap(const BoundaryLoop& loop)
{
  Gap gap;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  gap.centre.setZero();
  for (const Eigen::Vector3d& p : loop.points) {
    gap.centre += p / static_cast<double>(loop.points.size());
    normal += graph().normal(graph().blocks().nearest(p));
  }
  tangentFrame(normal.normalized(), gap.e1, gap.e2);
  for (const Eigen::Vector3d& p : loop.points) {
    gap.outline.emplace_back(gap.e1.dot(p - gap.centre), gap.e2.dot(p - gap.centre));
    gap.radius = std::max(gap.radius, (p - gap.centre).norm());
  }
  gaps_.push_back(std::move(gap));
}

bool
ReferenceSurface::inGap(const Eigen::Vector3d& p) const
{
  for (const Gap& gap : gaps_) {
    if (!((p - gap.centre).norm() < gap.radius))
      continue;
    const double u = gap.e1.dot(p - gap.centre), v = gap.e2.dot(p - gap.centre);
    bool inside = false; // an odd number of sides cross the ray towards +u
    for (std::size_t i = 0, j = gap.outline.size() - 1; i < gap.outline.size(); j = i++) {
      const Eigen::Vector2d &a = gap.outline[j], &b = gap.outline[i];
      if ((a.y() > v) != (b.y() > v) && u < a.x() + (b.x() - a.x()) * (v - a.y()) / (b.y() - a.y()))
        inside = !inside;
    }
    if (inside)
      return true;
  }
  return false;
}

double
ReferenceSurface::fitRadius() const
{
  return graph().spacing() * std::sqrt(surface_.neighbours() / pi);
}

double
ReferenceSurface::rimDistance(const Eigen::Vector3d& p, double limit) const
{
  Eigen::Vector3d point;
  for (const auto& index : rim_index_)
    index->nearest(p, limit, point);
  return limit;
}

double
ReferenceSurface::outermostDistance(const Eigen::Vector3d& p, double limit) const
{
  limit = rimDistance(p, limit);
  Eigen::Vector3d point;
  for (const auto& index : outermost_index_)
    index->nearest(p, limit, point);
  return limit;
}

std::optional<Eigen::Vector3d>
ReferenceSurface::nearestOnRim(const Eigen::Vector3d& p, double limit) const
{
  Eigen::Vector3d point;
  bool found = false;
  for (const auto& index : rim_index_)
    found = index->nearest(p, limit, point) || found;
  return found ? std::optional(point) : std::nullopt;
}

Diagnostics
noiseWarnings(const ReferenceSurface& reference, double scallop_height, double chord_error)
{
  Diagnostics warnings;
  if (const ReferenceMesh* mesh = reference.mesh()) {
    const double least = fit_deviations * reference.fitNoise();
    for (const auto& [what, asked] : {std::pair{"scallop height", scallop_height}, std::pair{"chord error", chord_error}})
      if (asked > 0.0 && asked < least)
        warnings.push_back(Diagnostic("the ", what, " asked for, ", asked, " {mm}, lies below ", least,
                                      " {mm}, three times the distance between the "
                                      "mesh and the surface fitted to its samples every ",
                                      mesh->spacing(), " {mm}: sample more closely ({setSampleSpacing} ", 0.5 * mesh->spacing(), ")"));
    return warnings;
  }
  for (const auto& [what, asked] : {std::pair{"scallop height", scallop_height}, std::pair{"chord error", chord_error}})
    if (const auto warning = noiseWarning(reference.surface(), what, asked))
      warnings.push_back(*warning);
  return warnings;
}

} // namespace pcl_spiral
