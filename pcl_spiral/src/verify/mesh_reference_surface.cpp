// SPDX-License-Identifier: BSD-3-Clause
// The ReferenceSurface of a mesh.
#include <pcl_spiral/verify/impl/reference_surface.h>

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/surface/impl/scanned_surface.hpp>
#include <pcl_spiral/surface/scanned_surface.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double band_width = 1.25; // radii of a fit: distance of the farthest of the nearest points

} // namespace

Status
ReferenceSurface::make(const ReferenceMesh::ConstPtr& mesh, const ProgressCallback& progress,
                       std::shared_ptr<const ReferenceSurface>& result)
{
  result.reset();
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (const pcl::PointNormal& sample : *mesh->samples())
    normals->emplace_back(sample.normal_x, sample.normal_y, sample.normal_z);
  ScannedSurface<pcl::PointNormal> scanned;
  scanned.setInputCloud(mesh->samples());
  scanned.setInputNormals(normals);
  scanned.setStrict(false);
  scanned.setQuiet(true);
  scanned.setProgressCallback(progress);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  if (!scanned.getStatus().ok())
    return scanned.getStatus();
  result = std::shared_ptr<const ReferenceSurface>(new ReferenceSurface(std::move(surface), mesh));
  return Status::success();
}

ReferenceSurface::ReferenceSurface(Surface::ConstPtr surface, ReferenceMesh::ConstPtr mesh)
: scanned_(std::move(surface)), mesh_(std::move(mesh)), surface_(scanned_->graph(), 0, ProjectionMethod::RobustQuartic),
  warnings_(mesh_->warnings())
{
  const SurfaceReport& counts = scanned_->report();
  if (const std::size_t out = mesh_->samples()->size() - counts.used - counts.duplicate; out > 0)
    warnings_.push_back(
        Diagnostic(out, " of ", mesh_->samples()->size(), " samples of the mesh, ", mesh_->spacing(),
                   " {mm} apart, were left out: they are in parts too small for this sample spacing, or where faces overlap; sample "
                   "more closely ({setSampleSpacing})"));
  if (!mesh_->creases().empty())
    crease_band_ = band_width * fitRadius();
  takeRims();
  measureMisfit();
}

void
ReferenceSurface::takeRims()
{
  for (const MeshRim& rim : mesh_->rims()) {
    BoundaryLoop loop;
    loop.curve = loop.points = rimCurve(mesh_->mesh(), rim, mesh_->spacing());
    loop.indices.assign(loop.points.size(), pcl::UNAVAILABLE);
    loop.type = loops_.empty() ? LoopType::Outer : LoopType::Inner;
    loop.length = rim.length;
    rims_.push_back(loop.curve);
    rims_.back().push_back(loop.curve.front());
    rim_length_ += rim.length;
    loops_.push_back(std::move(loop));
  }
  indexRims();
}

SurfaceFoot
ReferenceSurface::meshPlace(std::size_t i) const
{
  const pcl::PointNormal& sample = (*mesh_->samples())[scanned_->sourceIndex(i)];
  SurfaceFoot foot;
  foot.position = sample.getVector3fMap().cast<double>();
  foot.normal = sample.getNormalVector3fMap().cast<double>();
  foot.direction1 = foot.normal.unitOrthogonal();
  foot.nearest = static_cast<std::uint32_t>(i);
  foot.valid = true;
  return foot;
}

void
ReferenceSurface::measureMisfit()
{
  constexpr std::size_t most = 20000; // samples used
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < graph().size(); i += std::max<std::size_t>(1, graph().size() / most))
    if (!inCreaseBand(graph().position(i)))
      places.push_back(graph().position(i));
  std::vector<SurfaceFoot> feet;
  surface_.project(places, feet);
  double squares = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (feet[i].valid) {
      squares += (feet[i].position - places[i]).squaredNorm();
      ++count;
    }
  if (count > 0)
    mesh_misfit_ = std::sqrt(squares / static_cast<double>(count));
}

} // namespace pcl_spiral
