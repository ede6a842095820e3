// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/mesh/surface_mesh.h>

#include "bent_edges.h"
#include "straight_rulings.h"
#include "vertex_normals.h"
#include "welded_faces.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/parabola_edge.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** Sixfold volume of the tetrahedron from \p origin to a face. */
double
volumeTo(const Vector3d& origin, const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
  return (a - origin).dot((b - origin).cross(c - origin));
}

/** The openings of a mesh, each closed by triangles to the middle of its corners. */
struct Lids {
  double volume = 0.0;       ///< sixfold, from the first vertex
  double area = 0.0;         ///< mm^2
  bool are_triangles = true; ///< each opening has three edges: a face is missing, or had no area
};

Lids
lidsOf(const WeldedFaces& welded, const Triangulation& triangles)
{
  Lids lids;
  for (const std::vector<std::uint32_t>& loop : triangles.boundaryLoops()) {
    Vector3d middle = Vector3d::Zero();
    for (const std::uint32_t h : loop)
      middle += welded.positions[triangles.origin(h)] / static_cast<double>(loop.size());
    for (const std::uint32_t h : loop) {
      const Vector3d &a = welded.positions[triangles.target(h)], &b = welded.positions[triangles.origin(h)];
      lids.area += 0.5 * (b - a).cross(middle - a).norm();
      lids.volume += volumeTo(welded.positions[0], a, b, middle);
    }
    lids.are_triangles = lids.are_triangles && loop.size() == 3;
  }
  return lids;
}

/** Whether the faces of a closed mesh all face inwards. So may those of one with small openings, but an open sheet, a bore or a pocket has
 *  the side that its faces have: the openings may be a hundredth of the area (the mouth of a slot 2 mm wide and 20 mm deep is 0.046 of
 *  it), or, of three edges each, a tenth (a cube of twelve faces without one has 1/11). */
bool
isInsideOut(const WeldedFaces& welded, const Triangulation& triangles)
{
  constexpr double small = 0.01, of_triangles = 0.1;
  const Vector3d& origin = welded.positions[0];
  double volume = 0.0, area = 0.0;
  for (const auto& f : welded.faces) {
    const Vector3d &a = welded.positions[f[0]], &b = welded.positions[f[1]], &c = welded.positions[f[2]];
    volume += volumeTo(origin, a, b, c);
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  const Lids lids = lidsOf(welded, triangles);
  return lids.area <= (lids.are_triangles ? of_triangles : small) * area && volume + lids.volume < 0.0;
}

void
turnAll(WeldedFaces& welded)
{
  for (auto& f : welded.faces)
    std::swap(f[1], f[2]);
}

bool
isClosed(const Triangulation& mesh)
{
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    if (mesh.opposite(h) == Triangulation::none)
      return false;
  return true;
}

} // namespace

std::vector<Setting>
settingTable(MeshSettings& s)
{
  return {
      Setting("crease_angle", "setCreaseAngle", "crease angle", "mesh edges bent by more than this stay sharp", "20", s.crease_angle)
          .in("degrees", NumberRange::above(0.0).upTo(180.0)),
      Setting("flip_normals", "MeshSettings::flip", "turned normals", "the cutter is on the other side of the scan or mesh", "", s.flip),
  };
}

Vector3d
SurfaceMesh::faceNormal(std::size_t t) const
{
  const auto& f = triangles_.triangle(t);
  return (positions_[f[1]] - positions_[f[0]]).cross(positions_[f[2]] - positions_[f[0]]).normalized();
}

double
SurfaceMesh::faceArea(std::size_t t) const
{
  const auto& f = triangles_.triangle(t);
  return 0.5 * (positions_[f[1]] - positions_[f[0]]).cross(positions_[f[2]] - positions_[f[0]]).norm();
}

MeshPatch
SurfaceMesh::patch(std::size_t t) const
{
  MeshPatch patch;
  const auto h = static_cast<std::uint32_t>(3 * t);
  for (int k = 0; k < 3; ++k) {
    patch.corners.col(k) = positions_[triangles_.origin(h + k)];
    patch.bows.col(k) = bows_[h + k];
    patch.normals.col(k) = normal(h + k);
  }
  return patch;
}

double
SurfaceMesh::sag(std::size_t t) const
{
  // sum |bow_ij| b_i b_j is largest, for equal bows, in the middle, where b_i b_j = 1/9.
  const double most = std::max({bows_[3 * t].squaredNorm(), bows_[3 * t + 1].squaredNorm(), bows_[3 * t + 2].squaredNorm()});
  return std::sqrt(most) / 3.0;
}

Status
SurfaceMesh::make(const pcl::PolygonMesh& mesh, const MeshSettings& settings, ConstPtr& result)
{
  result.reset();
  if (const Diagnostic fault = rangeFault(settings); !fault.empty())
    return {StatusCode::InvalidArgument, fault};
  const auto made = std::make_shared<SurfaceMesh>();
  made->settings_ = settings;
  WeldedFaces welded;
  if (const Status status = weldFaces(mesh, welded, made->counts_); !status.ok())
    return status;
  turnFaces(welded, made->counts_);
  Triangulation triangles(welded.positions.size(), welded.faces);
  made->counts_.closed = isClosed(triangles);
  made->counts_.inside_out = isInsideOut(welded, triangles);
  if (made->counts_.inside_out != settings.flip) {
    turnAll(welded);
    triangles = Triangulation(welded.positions.size(), welded.faces);
  }
  made->positions_ = std::move(welded.positions);
  made->triangles_ = std::move(triangles);
  made->shape();
  result = made;
  return Status::success();
}

void
SurfaceMesh::shape()
{
  findCreases();
  const FlatRegions regions = flatRegions(triangles_, positions_, creases_);
  addFlatCreases(triangles_, regions, creases_);
  countEdges();
  const CornerSectors sectors = cornerSectors(triangles_, creases_);
  const CornerSectors sides = cornerSectors(triangles_, fitLimits(triangles_, regions, creases_));
  std::vector<std::uint8_t> fallback;
  const std::vector<Vector3d> one_sided = sectorNormals(triangles_, positions_, sides, settings_.normals, fallback);
  for (std::size_t s = 0; s < sides.count(); ++s)
    if (fallback[s])
      counts_.other_normals.add(positions_[triangles_.origin(sides.corners[sides.begin[s]])]);
  normals_.resize(sectors.count());
  for (std::uint32_t h = 0; h < triangles_.halfEdgeCount(); ++h)
    normals_[sectors.of_corner[h]] = one_sided[sides.of_corner[h]];
  takeFlatNormals(triangles_, positions_, sectors, regions, normals_);
  straightenRulings(triangles_, positions_, creases_, sectors, regions, normals_);
  sector_of_ = sectors.of_corner;
  bows_.assign(triangles_.halfEdgeCount(), Vector3d::Zero());
  for (std::uint32_t h = 0; h < triangles_.halfEdgeCount(); ++h)
    if (const std::uint32_t other = triangles_.opposite(h); other == Triangulation::none || h < other)
      setBow(h);
  flat_.resize(faceCount());
  for (std::uint32_t t = 0; t < faceCount(); ++t)
    flat_[t] = regions.flatAt(t) != Triangulation::none;
  for (std::uint32_t h = 0; h < triangles_.halfEdgeCount(); ++h)
    if (flat_[h / 3] && !creases_[h]) { // two flat regions may meet at a point
      bows_[h].setZero();
      if (const std::uint32_t other = triangles_.opposite(h); other != Triangulation::none)
        bows_[other].setZero();
    }
  for (std::size_t t = 0; t < faceCount(); ++t) {
    area_ += faceArea(t);
    mean_normal_ += faceArea(t) * faceNormal(t);
  }
  mean_normal_ /= area_;
  counts_.vertices = positions_.size();
  counts_.faces = faceCount();
  counts_.loops = triangles_.boundaryLoops().size();
  std::vector<std::size_t> sizes;
  triangles_.parts(sizes);
  counts_.parts = sizes.size();
}

void
SurfaceMesh::findCreases()
{
  const std::vector<std::uint8_t> bent = bentEdges(*this);
  creases_ = bent;
  counts_.noise = vertexNoise(triangles_, positions_, cornerSectors(triangles_, creases_));
#pragma omp parallel for schedule(static)
  for (std::int64_t h = 0; h < static_cast<std::int64_t>(creases_.size()); ++h)
    if (const std::uint32_t other = triangles_.opposite(static_cast<std::uint32_t>(h)); bent[h] && h < other)
      creases_[h] = creases_[other] = standsOut(*this, bent, counts_.noise, static_cast<std::uint32_t>(h));
}

void
SurfaceMesh::countEdges()
{
  for (std::uint32_t h = 0; h < triangles_.halfEdgeCount(); ++h) {
    const std::uint32_t other = triangles_.opposite(h);
    const Vector3d &a = positions_[triangles_.origin(h)], &b = positions_[triangles_.target(h)];
    if (other == Triangulation::none)
      counts_.open_edges.add(0.5 * (a + b));
    else if (creases_[h] && h < other) {
      counts_.creases.add(0.5 * (a + b));
      counts_.crease_length += (b - a).norm();
    }
  }
}

void
SurfaceMesh::setBow(std::uint32_t h)
{
  const Vector3d start = positions_[triangles_.origin(h)], d = positions_[triangles_.target(h)] - start;
  const Vector3d &n0 = normal(h), &n1 = normal(Triangulation::next(h));
  const std::uint32_t other = triangles_.opposite(h);
  Vector3d bow = Vector3d::Zero();
  if (settings_.edges == MeshEdges::Robust)
    bow = creases_[h] ? creaseBow(d, n0, n1, normal(Triangulation::next(other)), normal(other)) : robustBow(d, n0, n1);
  else if (settings_.edges == MeshEdges::Published && !creases_[h])
    bow = publishedBow(d, n0, n1);
  if (bow.squaredNorm() > d.squaredNorm()) { // a quarter of the bow is the correction in the middle
    counts_.limited.add(start + 0.5 * d);
    bow.setZero();
  }
  bows_[h] = bow;
  if (other != Triangulation::none)
    bows_[other] = bow;
}

} // namespace pcl_spiral
