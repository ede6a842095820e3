// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_part.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral::awkward {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double body_spacing = 0.5;

test::PlaneLoop
drawnOutline(test::Random& random, double size)
{
  switch (random.below(4)) {
  case 0:
    return test::ellipse(0.5 * size, 0.5 * size * random.uniform(0.6, 1.0));
  case 1:
    return test::rectangle(size, size * random.uniform(0.6, 1.0));
  case 2:
    return test::slot(size, size * random.uniform(0.4, 0.7));
  default:
    return test::kidney(0.5 * size, 0.3 * size, 0.6 / size);
  }
}

/** Points of a rectangle on a grid, in order. */
template <typename Place>
void
addGrid(double width, double height, double spacing, const Place& place)
{
  const int columns = std::max(1, static_cast<int>(std::ceil(width / spacing)));
  const int rows = std::max(1, static_cast<int>(std::ceil(height / spacing)));
  for (int i = 0; i <= columns; ++i)
    for (int k = 0; k <= rows; ++k)
      place(width * i / columns - 0.5 * width, height * k / rows - 0.5 * height);
}

} // namespace

test::SurfacePtr
drawnPart(test::Random& random, double size)
{
  return drawnPartOf(size * random.uniform(60.0, 120.0), random);
}

test::SurfacePtr
drawnPartOf(double length, test::Random& random)
{
  test::Ground form;
  form.amplitude = random.uniform(0.0, 3.0);
  form.length_x = random.uniform(20.0, 40.0);
  form.length_y = random.uniform(20.0, 40.0);
  form.bend_x = random.uniform(-0.006, 0.003);
  form.bend_y = random.uniform(-0.006, 0.003);
  return test::ground(form, test::Region({drawnOutline(random, length)}));
}

void
drawScan(Scene& scene, test::SurfacePtr part, test::Random& random)
{
  scene.part = std::move(part);
  scene.radius = random.uniform(3.0, 5.0);
  scene.scallop = random.uniform(0.05, 0.15);
  scene.noise = random.below(2) == 0 ? 0.0 : 0.01;
  scene.spacing = random.uniform(0.6, 1.0);
  const auto count = static_cast<std::size_t>(scene.part->area() / (scene.spacing * scene.spacing));
  const std::uint64_t seed = random.below(1u << 30);
  scene.scan = random.below(2) == 0 ? test::sampleUniform(*scene.part, 2 * count, seed)
                                    : test::sampleScanLines(*scene.part, scene.spacing, scene.spacing, seed);
  test::addNoise(scene.scan, scene.noise, seed + 1);
}

Eigen::Isometry3d
levelMotion(test::Random& random, double reach)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::AngleAxisd(random.uniform(0.0, full_turn), Vector3d::UnitZ()).toRotationMatrix();
  motion.translation() = reach * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  return motion;
}

Vector3d
innerPlace(const test::AnalyticSurface& part, double margin, test::Random& random)
{
  Vector3d best = Vector3d::Zero();
  double farthest = -1.0;
  for (const Vector3d& x : test::sampleUniform(part, 200, random.below(1u << 30)).points) {
    const double d = part.rimDistance(x);
    if (d > margin)
      return x;
    if (d > farthest) {
      farthest = d;
      best = x;
    }
  }
  return best;
}

bool
Box::covers(const Vector2d& p, double margin) const
{
  const Vector2d q = Eigen::Rotation2Dd(-turn) * (p - centre);
  return std::abs(q.x()) <= half_x + margin && std::abs(q.y()) <= half_y + margin;
}

test::PlaneLoop
Box::outline(double margin) const
{
  test::PlaneLoop corners;
  for (const Vector2d& sign : {Vector2d(-1, -1), Vector2d(1, -1), Vector2d(1, 1), Vector2d(-1, 1)})
    corners.push_back(centre + Eigen::Rotation2Dd(turn) * Vector2d(sign.x() * (half_x + margin), sign.y() * (half_y + margin)));
  return corners;
}

bool
isClear(const test::AnalyticSurface& part, const Box& box, double margin)
{
  constexpr double step = 0.5; // mm, along the outline
  const test::PlaneLoop& outline = part.region().loops().front();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d side = outline[(i + 1) % outline.size()] - outline[i];
    const auto steps = static_cast<int>(std::ceil(side.norm() / step));
    for (int k = 0; k < steps; ++k)
      if (box.covers(outline[i] + side * k / steps, margin))
        return false;
  }
  return !part.region().contains(box.centre);
}

bool
overlap(const Box& a, const Box& b)
{
  return (a.centre - b.centre).norm() < std::hypot(a.half_x, a.half_y) + std::hypot(b.half_x, b.half_y);
}

void
addBox(Scene& scene, const Box& box)
{
  test::Sampled kept;
  for (std::size_t i = 0; i < scene.scan.points.size(); ++i)
    if (!box.covers(scene.scan.points[i].head<2>()) || scene.scan.points[i].z() > box.top) {
      kept.points.push_back(scene.scan.points[i]);
      kept.normals.push_back(scene.scan.normals[i]);
    }
  const auto placed = [&](double x, double y, double z) {
    const Vector2d p = box.centre + Eigen::Rotation2Dd(box.turn) * Vector2d(x, y);
    return Vector3d(p.x(), p.y(), z);
  };
  addGrid(2.0 * box.half_x, 2.0 * box.half_y, scene.spacing, [&](double x, double y) {
    kept.points.push_back(placed(x, y, box.top));
    kept.normals.push_back(Vector3d::UnitZ());
  });
  scene.scan = kept;
  addGrid(2.0 * box.half_x, 2.0 * box.half_y, body_spacing, [&](double x, double y) { scene.bodies.push_back(placed(x, y, box.top)); });
  const double middle = 0.5 * (box.bottom + box.top), height = box.top - box.bottom;
  for (const double sign : {-1.0, 1.0}) {
    addGrid(2.0 * box.half_x, height, body_spacing,
            [&](double x, double z) { scene.bodies.push_back(placed(x, sign * box.half_y, middle + z)); });
    addGrid(2.0 * box.half_y, height, body_spacing,
            [&](double y, double z) { scene.bodies.push_back(placed(sign * box.half_x, y, middle + z)); });
  }
}

void
addTable(Scene& scene, double z, double margin)
{
  const Vector2d lower = scene.part->region().lower(), upper = scene.part->region().upper();
  const Vector2d size = upper - lower + Vector2d::Constant(2.0 * margin), centre = 0.5 * (lower + upper);
  addGrid(size.x(), size.y(), scene.spacing, [&](double x, double y) {
    const Vector2d p = centre + Vector2d(x, y);
    if (scene.part->region().contains(p))
      return;
    scene.scan.points.emplace_back(p.x(), p.y(), z);
    scene.scan.normals.push_back(Vector3d::UnitZ());
  });
}

} // namespace pcl_spiral::awkward
