// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/mesh/impl/patch_tree.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/** Box of the corners and the control points of the parabolas: the patch lies within their hull. Rounded outwards. */
Box
boxOf(const PatchCell& cell)
{
  Vector3d low = cell.corners.rowwise().minCoeff(), high = cell.corners.rowwise().maxCoeff();
  for (int k = 0; k < 3; ++k) {
    const Vector3d control = 0.5 * (cell.corners.col(k) + cell.corners.col((k + 1) % 3) - cell.bows.col(k));
    low = low.cwiseMin(control);
    high = high.cwiseMax(control);
  }
  constexpr float infinity = std::numeric_limits<float>::infinity();
  Box box;
  for (int d = 0; d < 3; ++d) {
    box.low[d] = std::nextafter(static_cast<float>(low[d]), -infinity);
    box.high[d] = std::nextafter(static_cast<float>(high[d]), infinity);
  }
  return box;
}

double
distanceTo(const Box& box, const Vector3d& p)
{
  double sum = 0.0;
  for (int d = 0; d < 3; ++d) {
    const double gap = std::max({box.low[d] - p[d], p[d] - box.high[d], 0.0});
    sum += gap * gap;
  }
  return std::sqrt(sum);
}

/** Share of the way from \p a to \p b that is nearest to \p p. */
double
alongSegment(const Vector3d& a, const Vector3d& b, const Vector3d& p)
{
  const double length = (b - a).squaredNorm();
  return length > 0.0 ? std::clamp((p - a).dot(b - a) / length, 0.0, 1.0) : 0.0;
}

/** Take those places of \p cell that are nearer than \p best. */
void
takeNearest(const PatchCell& cell, const Vector3d& p, double sag, std::uint32_t index, bool& found, PatchPlace& best)
{
  const Vector3d b = nearestOnTriangle(cell.corners, p);
  const double distance = (cell.corners * b - p).norm(), off = cell.sag();
  if (off > sag) {
    if (distance - off <= best.distance)
      for (int k = 0; k < 4; ++k)
        takeNearest(cell.quarter(k), p, sag, index, found, best);
    return;
  }
  if (distance < best.distance || (distance == best.distance && (!found || index < best.patch))) {
    found = true;
    best = {index, cell.weights * b, cell.position(b), distance};
  }
}

} // namespace

PatchCell
PatchCell::quarter(int k) const
{
  const auto middle = [&](int i) -> Vector3d { return 0.5 * (corners.col(i) + corners.col((i + 1) % 3)) - 0.25 * bows.col(i); };
  const auto halfway = [&](int i) -> Vector3d { return 0.5 * (weights.col(i) + weights.col((i + 1) % 3)); };
  PatchCell part;
  part.bows = 0.25 * bows;
  if (k == 3) {
    part.corners << middle(1), middle(2), middle(0);
    part.weights << halfway(1), halfway(2), halfway(0);
    return part;
  }
  part.corners.col(k) = corners.col(k);
  part.weights.col(k) = weights.col(k);
  part.corners.col((k + 1) % 3) = middle(k);
  part.weights.col((k + 1) % 3) = halfway(k);
  part.corners.col((k + 2) % 3) = middle((k + 2) % 3);
  part.weights.col((k + 2) % 3) = halfway((k + 2) % 3);
  return part;
}

Vector3d
nearestOnTriangle(const Matrix3d& corners, const Vector3d& p)
{
  const Vector3d a = corners.col(1) - corners.col(0), b = corners.col(2) - corners.col(0), d = p - corners.col(0);
  const Vector3d n = a.cross(b);
  const double area = n.squaredNorm();
  if (area > 0.0) {
    const double w1 = n.dot(d.cross(b)) / area, w2 = n.dot(a.cross(d)) / area;
    if (w1 >= 0.0 && w2 >= 0.0 && w1 + w2 <= 1.0)
      return {1.0 - w1 - w2, w1, w2};
  }
  Vector3d best = Vector3d::UnitX();
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const int to = (k + 1) % 3;
    const double t = alongSegment(corners.col(k), corners.col(to), p);
    Vector3d weights = Vector3d::Zero();
    weights[k] = 1.0 - t;
    weights[to] = t;
    if (const double distance = (corners * weights - p).squaredNorm(); distance < least) {
      least = distance;
      best = weights;
    }
  }
  return best;
}

PatchTree::PatchTree(const std::vector<PatchCell>& cells)
{
  std::vector<Box> boxes;
  boxes.reserve(cells.size());
  for (const PatchCell& cell : cells)
    boxes.push_back(boxOf(cell));
  tree_ = BoxTree(boxes);
  shapes_.reserve(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
    shapes_.push_back({cells[tree_.item(i)].corners, cells[tree_.item(i)].bows});
}

bool
PatchTree::nearest(const Vector3d& p, double distance, double sag, PatchPlace& place) const
{
  bool found = false;
  place.distance = distance;
  tree_.forItems([&](const Box& box) { return distanceTo(box, p) <= place.distance; },
                 [&](std::uint32_t i) { takeNearest(cell(i), p, sag, index(i), found, place); });
  return found;
}

PatchTree
facesOf(const SurfaceMesh& mesh)
{
  std::vector<PatchCell> cells;
  cells.reserve(mesh.faceCount());
  for (std::size_t t = 0; t < mesh.faceCount(); ++t) {
    const MeshPatch patch = mesh.patch(t);
    cells.push_back({patch.corners, patch.bows});
  }
  return PatchTree(cells);
}

PatchTree
rimOf(const SurfaceMesh& mesh)
{
  const Triangulation& triangles = mesh.triangles();
  std::vector<PatchCell> cells;
  for (std::uint32_t h = 0; h < triangles.halfEdgeCount(); ++h)
    if (triangles.opposite(h) == Triangulation::none) {
      const Vector3d &a = mesh.position(triangles.origin(h)), &b = mesh.position(triangles.target(h));
      PatchCell cell;
      cell.corners << a, b, b;
      cell.bows << mesh.bow(h), Vector3d::Zero(), mesh.bow(h);
      cells.push_back(cell);
    }
  return PatchTree(cells);
}

} // namespace pcl_spiral
