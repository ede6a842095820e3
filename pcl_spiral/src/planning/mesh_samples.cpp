// SPDX-License-Identifier: BSD-3-Clause
#include "planning/mesh_samples.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/mesh/mesh_sampling.h>

#include <pcl/conversions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double spacings_a_hole = 6.0;   // triangles over samples close circles of up to three spacings
constexpr double spacings_a_radius = 6.0; // near a bent edge the fits are hollow: radius 15 spacings at a bend of 62 degrees
constexpr double most_samples = 5e5, samples_a_square = 1.6; // the latter: of one spacing

Status
requireOpen(const SurfaceMesh& mesh)
{
  if (!mesh.report().closed)
    return Status::success();
  Eigen::AlignedBox3d box;
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v)
    box.extend(mesh.position(v));
  return {StatusCode::InvalidInput, Diagnostic("the mesh from ", Place(box.min()), " to ", Place(box.max()),
                                               " is closed: it has no boundary where a path can begin or end; keep only the side to be "
                                               "machined, or machine it in rows ({MeshSections})")};
}

double
stepOnPlane(const SpiralSettings& settings)
{
  return stepOver(settings.tool_radius, 0.0, settings.scallop_height).value_or(2.0 * settings.tool_radius);
}

/** From the curvature of the mesh, at most the distance of turns. With creases: wide enough that the ball fits into the local fits
 *  beside them. Close enough to show the holes asked for. */
double
spacingFor(const SpiralSettings& settings, const SurfaceMesh& mesh)
{
  const double closest = std::sqrt(mesh.area() * samples_a_square / most_samples);
  double spacing = std::min(defaultSampleSpacing(mesh), std::max(stepOnPlane(settings), closest));
  if (mesh.report().creases.count > 0)
    spacing = std::max(spacing, settings.tool_radius / spacings_a_radius);
  if (settings.hole_size > 0.0)
    spacing = std::min(spacing, std::max(settings.hole_size / spacings_a_hole, closest));
  return spacing;
}

/** Parts of the mesh connected by edges: one number per face. */
std::vector<std::uint32_t>
partsOf(const SurfaceMesh& mesh, std::size_t& count)
{
  std::vector<std::size_t> sizes;
  std::vector<std::uint32_t> parts = mesh.triangles().parts(sizes);
  count = sizes.size();
  return parts;
}

SurfaceMesh::ConstPtr
meshOf(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& is_kept)
{
  pcl::PointCloud<pcl::PointXYZ> points;
  for (std::size_t v = 0; v < mesh.vertexCount(); ++v) {
    points.emplace_back();
    points.back().getVector3fMap() = mesh.position(v).cast<float>();
  }
  pcl::PolygonMesh kept;
  pcl::toPCLPointCloud2(points, kept.cloud);
  for (std::size_t t = 0; t < mesh.faceCount(); ++t)
    if (is_kept[t]) {
      const auto& corners = mesh.triangles().triangle(t);
      kept.polygons.emplace_back();
      kept.polygons.back().vertices.assign(corners.begin(), corners.end());
    }
  MeshSettings settings = mesh.settings();
  settings.flip = false; // the faces are turned already
  SurfaceMesh::ConstPtr made;
  SurfaceMesh::make(kept, settings, made);
  return made;
}

/** Warns if the faces look down: the mesh defines the side, and most cutters come from above. */
void
warnOfSide(bool flipped, const pcl::PointCloud<pcl::Normal>& normals, Diagnostics& warnings)
{
  constexpr double down = -0.25; // of the mean normal
  double sum = 0.0;
  for (const pcl::Normal& n : normals)
    sum += n.normal_z;
  if (sum < down * static_cast<double>(normals.size()))
    warnings.push_back(Diagnostic("the faces of the mesh point down, along -z, so the cutter comes from below: ",
                                  flipped ? "leave {setFlipNormals} out" : "give {setFlipNormals}", " if it must come from above"));
}

} // namespace

Status
sampleMesh(const SurfaceMesh::ConstPtr& mesh, double spacing, const SpiralSettings& settings, const ProgressCallback& progress,
           SpiralPlan& plan)
{
  if (const Status status = requireOpen(*mesh); !status.ok())
    return status;
  if (progress && !progress(0.1, "samples"))
    return {StatusCode::Cancelled, "cancelled"};
  SampledMesh sampled;
  sampled.mesh = mesh;
  MeshSampling sampling;
  sampling.setInputMesh(mesh);
  sampling.setSpacing(spacing > 0.0 ? spacing : spacingFor(settings, *mesh));
  sampling.setNumberOfThreads(settings.threads);
  pcl::PointCloud<pcl::PointNormal> samples;
  sampling.compute(samples);
  if (!sampling.getStatus().ok())
    return sampling.getStatus();
  sampled.spacing = sampling.getUsedSpacing();
  sampled.faces = sampling.getFaceIndices();
  sampled.counts = mesh->report();
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (const pcl::PointNormal& sample : samples) {
    cloud->emplace_back(sample.x, sample.y, sample.z);
    normals->emplace_back(sample.normal_x, sample.normal_y, sample.normal_z);
  }
  sampled.normals = normals;
  plan.whole = plan.cloud = cloud;
  warnOfSide(mesh->settings().flip, *normals, plan.part.warnings);
  plan.whole_mesh = mesh;
  plan.mesh = std::move(sampled);
  return Status::success();
}

void
keepUsedParts(const Surface& surface, SampledMesh& input)
{
  std::size_t count = 0;
  const std::vector<std::uint32_t> parts = partsOf(*input.mesh, count);
  std::vector<std::uint8_t> is_used(count, 0), is_kept(parts.size());
  for (std::size_t i = 0; i < surface.size(); ++i)
    is_used[parts[input.faces[surface.sourceIndex(i)]]] = 1;
  if (std::count(is_used.begin(), is_used.end(), 0) == 0)
    return;
  for (std::size_t t = 0; t < parts.size(); ++t)
    is_kept[t] = is_used[parts[t]];
  input.mesh = meshOf(*input.mesh, is_kept);
}

double
meshHoleSize(const SpiralSettings& settings, const SampledMesh& mesh)
{
  return settings.hole_size > 0.0 ? settings.hole_size : std::max(stepOnPlane(settings), spacings_a_hole * mesh.spacing);
}

Diagnostics
creaseWarnings(const SampledMesh& input, const Surface& surface)
{
  const MeshReport& counts = input.mesh->report();
  if (counts.creases.count == 0)
    return {};
  const double band = surface.spacing() * std::sqrt(surface.fit().neighbours() / pi);
  return {Diagnostic("the mesh has ", counts.crease_length, " {mm} of creases (", counts.creases.count, " edges), the first at ",
                     Place(counts.creases.place), ": the spiral runs over them as if they were rounded, within about ", band,
                     " {mm}; outer edges are cut off, in inner edges material is left. If creases must stay sharp, cut the mesh "
                     "along them and machine each side separately")};
}

Status
withSpacings(const Status& status, const SampledMesh& input)
{
  if (status.code() != StatusCode::InvalidInput && status.code() != StatusCode::Failed)
    return status;
  const double vertices = std::sqrt(input.mesh->area() / static_cast<double>(input.mesh->vertexCount()));
  return {status.code(),
          Diagnostic(status.diagnostic(), "; samples are ", input.spacing, " {mm} apart, vertices of the mesh ", vertices, " {mm}")};
}

} // namespace pcl_spiral
