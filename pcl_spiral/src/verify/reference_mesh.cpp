// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/verify/impl/reference_mesh.h>

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/mesh/mesh_sampling.h>
#include <pcl_spiral/search/impl/point_blocks.h>

#include "core/angle_between.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;
using Samples = pcl::PointCloud<pcl::PointNormal>;

constexpr double least_agreement = 0.85; // cosine of the angle between a contact's normal and that of the face below it
constexpr double farthest = 4.0;         // spacings from a contact to the sample it touches
constexpr double away = 0.1;             // cosine

/** Number of the smooth area of each face: an area is faces joined by edges that are not creases. */
std::vector<std::uint32_t>
smoothAreas(const SurfaceMesh& mesh)
{
  constexpr std::uint32_t none = Triangulation::none;
  std::vector<std::uint32_t> area(mesh.faceCount(), none), open;
  std::uint32_t count = 0;
  for (std::uint32_t first = 0; first < mesh.faceCount(); ++first) {
    if (area[first] != none)
      continue;
    area[first] = count;
    for (open.assign(1, first); !open.empty();) {
      const std::uint32_t t = open.back();
      open.pop_back();
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const std::uint32_t other = mesh.triangles().opposite(h);
        if (other == none || mesh.isCrease(h) || area[other / 3] != none)
          continue;
        area[other / 3] = count;
        open.push_back(other / 3);
      }
    }
    ++count;
  }
  return area;
}

/** The faces of the smooth areas on which a contact lies; \p nearest becomes the least distance of a contact from a sample. */
std::vector<std::uint8_t>
touchedFaces(const SurfaceMesh& mesh, const CutterPath& path, const MeshSampling& sampling, const Samples& samples, double& nearest)
{
  std::vector<Eigen::Vector3f> points;
  for (const pcl::PointNormal& sample : samples)
    points.push_back(sample.getVector3fMap());
  const PointBlocks blocks(std::move(points));
  const std::vector<std::uint32_t> areas = smoothAreas(mesh);
  std::vector<std::uint8_t> touched(mesh.faceCount(), 0); // by the number of the area; there are at most as many areas as faces
  nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::uint32_t at = blocks.nearest(path.contacts[i]), sample = blocks.originalIndex(at);
    const double distance = (blocks.position(at) - path.contacts[i]).norm();
    nearest = std::min(nearest, distance);
    if (distance < farthest * sampling.getUsedSpacing() &&
        samples[sample].getNormalVector3fMap().cast<double>().dot(path.normals[i]) > least_agreement)
      touched[areas[sampling.getFaceIndices()[sample]]] = 1;
  }
  std::vector<std::uint8_t> faces(mesh.faceCount());
  for (std::size_t t = 0; t < faces.size(); ++t)
    faces[t] = touched[areas[t]];
  return faces;
}

/** Leave out faces that face away from the cutter, if the cutter comes from one side. */
void
dropAway(const SurfaceMesh& mesh, const CutterPath& path, std::vector<std::uint8_t>& faces)
{
  constexpr double least_common = 0.5; // length of the mean of the axes
  const std::vector<Vector3d>& axes = path.axes.empty() ? path.normals : path.axes;
  const Vector3d axis = std::accumulate(axes.begin(), axes.end(), Vector3d(0, 0, 0)) / static_cast<double>(axes.size());
  if (axis.norm() < least_common)
    return;
  double lowest = 0.0;
  for (const Vector3d& normal : path.normals)
    lowest = std::min(lowest, normal.dot(axis.normalized()));
  for (std::size_t t = 0; t < faces.size(); ++t)
    if (mesh.faceNormal(t).dot(axis.normalized()) < lowest - away)
      faces[t] = 0;
}

/** Of face \p t with the bend over the edge of half-edge \p h; 0 if it does not bend with the faces there. */
double
sagitta(const SurfaceMesh& mesh, std::size_t t, std::uint32_t h)
{
  constexpr double most = 4.0; // times as wide
  const Triangulation& triangles = mesh.triangles();
  const std::uint32_t other = triangles.opposite(h);
  if (other == Triangulation::none || mesh.isCrease(h))
    return 0.0;
  const Vector3d a = mesh.faceNormal(h / 3), b = mesh.faceNormal(other / 3);
  const Vector3d edge = mesh.position(triangles.target(h)) - mesh.position(triangles.origin(h));
  const Vector3d across = mesh.faceNormal(t).cross(edge).normalized();
  const double theta = angleBetween(a, b);
  const double w = 2.0 * std::min(mesh.faceArea(h / 3), mesh.faceArea(other / 3)) / edge.norm();
  const auto& v = triangles.triangle(t);
  const auto [low, high] = std::minmax({across.dot(mesh.position(v[0])), across.dot(mesh.position(v[1])), across.dot(mesh.position(v[2]))});
  const double width = high - low;
  return width <= most * w ? theta / w * width * width / 8.0 : 0.0;
}

} // namespace

std::size_t
ReferenceMesh::faceCount() const
{
  return faces_.empty() ? mesh_->faceCount() : static_cast<std::size_t>(std::count(faces_.begin(), faces_.end(), 1));
}

double
ReferenceMesh::area() const
{
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh_->faceCount(); ++t)
    if (faces_.empty() || faces_[t])
      sum += mesh_->faceArea(t);
  return sum;
}

Vector3d
ReferenceMesh::flatPlace(std::size_t i) const
{
  const std::uint32_t t = sample_faces_[i];
  const Vector3d normal = mesh_->faceNormal(t), place = (*samples_)[i].getVector3fMap().cast<double>();
  return place - (place - mesh_->position(mesh_->triangles().triangle(t)[0])).dot(normal) * normal;
}

double
bendDepth(const SurfaceMesh& mesh, std::size_t t)
{
  if (mesh.isFlat(t))
    return 0.0;
  const Triangulation& triangles = mesh.triangles();
  double depth = 0.0;
  for (auto corner = static_cast<std::uint32_t>(3 * t); corner < 3 * t + 3; ++corner) {
    const std::uint32_t v = triangles.origin(corner);
    for (std::uint32_t i = triangles.outgoingBegin(v); i < triangles.outgoingBegin(v + 1); ++i)
      if (const std::uint32_t h = triangles.outgoing(i); mesh.sector(h) == mesh.sector(corner))
        depth = std::max(depth, 2.0 * sagitta(mesh, t, h));
  }
  return depth;
}

Status
ReferenceMesh::chooseFaces(const CutterPath& path)
{
  MeshSampling sampling;
  sampling.setInputMesh(mesh_);
  Samples samples;
  sampling.compute(samples);
  if (!sampling.getStatus().ok())
    return sampling.getStatus();
  double nearest = 0.0;
  faces_ = touchedFaces(*mesh_, path, sampling, samples, nearest);
  dropAway(*mesh_, path, faces_);
  if (faceCount() == 0)
    return {StatusCode::InvalidInput,
            Diagnostic("no contact of the toolpath lies on the closed mesh on the side of its normal, the nearest is ", nearest,
                       " {mm} away: is it another part, another unit, or the other side of the mesh?")};
  if (faceCount() == mesh_->faceCount())
    faces_.clear();
  else
    warnings_.push_back(Diagnostic("the mesh is closed: ", faceCount(), " of its ", mesh_->faceCount(), " faces are judged, ", area(),
                                   " {mm2}, the smooth areas that the path touches; to judge all faces, keep only the machined part of "
                                   "the mesh"));
  return Status::success();
}

Status
ReferenceMesh::make(const SurfaceMesh::ConstPtr& mesh, const CutterPath& path, double spacing, ConstPtr& result)
{
  result.reset();
  const auto made = std::make_shared<ReferenceMesh>();
  made->mesh_ = mesh;
  if (mesh->report().closed)
    if (const Status status = made->chooseFaces(path); !status.ok())
      return status;
  MeshSampling sampling;
  sampling.setInputMesh(mesh);
  sampling.setFaces(made->faces_);
  sampling.setSpacing(spacing);
  const auto samples = pcl::make_shared<Samples>();
  sampling.compute(*samples);
  if (!sampling.getStatus().ok())
    return sampling.getStatus();
  made->samples_ = samples;
  made->spacing_ = sampling.getUsedSpacing();
  made->sample_faces_ = sampling.getFaceIndices();
  made->rims_ = meshRims(*mesh, made->faces_);
  made->creases_ = std::make_unique<CreaseLines>(*mesh, made->faces_);
  result = made;
  return Status::success();
}

} // namespace pcl_spiral
