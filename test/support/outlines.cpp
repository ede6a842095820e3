// SPDX-License-Identifier: BSD-3-Clause
#include "support/outlines.h"

#include <pcl_spiral/core/impl/angles.h>

#include "support/outline_loops.h"
#include "support/sampling.h"

#include <Eigen/Geometry>

#include <stdexcept>

namespace pcl_spiral::test {

namespace {

/** An outline and the surface under it, before variation. */
struct Drawing {
  std::string name;
  std::vector<PlaneLoop> loops;
  Ground ground;
  bool proportions_stay = false;
};

const Ground level{};
const Ground waves{6.0, 45.0, 50.0, 0.0, 0.0};

std::vector<PlaneLoop>
sixHoles()
{
  std::vector<PlaneLoop> loops{circle({0.0, 0.0}, 135.0)};
  for (int i = 0; i < 6; ++i) {
    const double t = pi * i / 3.0, out = i % 2 == 0 ? 82.0 : 68.0;
    loops.push_back(circle({out * std::cos(t), out * std::sin(t)}, 10.0 + 2.0 * i));
  }
  return loops;
}

PlaneLoop
moved(PlaneLoop loop, const Eigen::Vector2d& by)
{
  for (Eigen::Vector2d& u : loop)
    u += by;
  return loop;
}

std::vector<Drawing>
simpleDrawings()
{
  const Ground saddle{0.0, 45.0, 50.0, 1.0 / 250.0, -1.0 / 200.0};
  const Ground hill{0.0, 45.0, 50.0, -1.0 / 600.0, -1.0 / 600.0};
  const Ground gentle{0.0, 45.0, 50.0, 1.0 / 800.0, -1.0 / 500.0};
  const Eigen::Vector2d origin(0.0, 0.0);
  return {{"disc", {circle(origin, 100.0)}, level, true},
          {"square", {rectangle(200.0, 200.0)}, level, true},
          {"ellipse_2", {ellipse(110.0, 55.0)}, level, true},
          {"ellipse_3", {ellipse(135.0, 45.0)}, level, true},
          {"strip_8", {rectangle(640.0, 80.0)}, level, true},
          {"kidney", {kidney(120.0, 60.0, 0.006)}, gentle},
          {"blade", {kidney(170.0, 48.0, 0.004)}, gentle},
          {"oval_saddle", {ellipse(150.0, 100.0)}, saddle},
          {"ring_off_centre", {circle(origin, 150.0), circle({40.0, 25.0}, 45.0)}, hill},
          {"ring", {circle(origin, 110.0), circle(origin, 28.0)}, waves},
          {"dumbbell", {dumbbell(45.0, 65.0, 14.0)}, waves}};
}

std::vector<Drawing>
branchedDrawings()
{
  return {{"L", {ell(190.0, 70.0)}, waves},
          {"cross", {cross(220.0, 66.0)}, waves},
          {"star_smooth", {smoothStar(5, 75.0, 25.0)}, waves},
          {"star_pointed", {star(5, 100.0, 45.0)}, level},
          {"holes_2", {superellipse(120.0, 80.0, 3.0), circle({-45.0, 10.0}, 22.0), circle({50.0, -15.0}, 16.0)}, waves},
          {"holes_3",
           {circle({0.0, 0.0}, 110.0), circle({-45.0, 10.0}, 18.0), circle({50.0, -15.0}, 14.0), moved(ellipse(25.0, 10.0), {5.0, 60.0})},
           waves},
          {"holes_6", sixHoles(), waves},
          {"U", {uShape(210.0, 200.0, 70.0)}, waves},
          {"boomerang", {band(115.0, 82.0, 150.0)}, waves},
          {"slit_disc", {slitDisc(105.0, 8.0)}, waves}};
}

std::vector<Drawing>
drawings()
{
  std::vector<Drawing> all = simpleDrawings();
  for (Drawing& d : branchedDrawings())
    all.push_back(std::move(d));
  return all;
}

/** Changes size, proportions, direction, slightly bends the sides, changes the surface. */
void
vary(Drawing& drawing, std::uint64_t seed)
{
  Random random(seed * 7919 + drawing.name.size());
  const double scale = random.uniform(0.8, 1.15), aspect = random.uniform(0.93, 1.07);
  const Eigen::Vector2d stretch = drawing.proportions_stay ? Eigen::Vector2d(1.0, 1.0) : Eigen::Vector2d(aspect, 1.0 / aspect);
  const Eigen::Matrix2d map = scale * Eigen::Rotation2Dd(random.uniform(0.0, 2.0 * pi)).toRotationMatrix() * stretch.asDiagonal();
  const double bend = random.uniform(0.0, 2.0), length = random.uniform(35.0, 60.0);
  const double a = random.uniform(0.0, 2.0 * pi), b = random.uniform(0.0, 2.0 * pi);
  for (PlaneLoop& loop : drawing.loops)
    loop = bent(loop, 0.5, [&](const Eigen::Vector2d& u) {
      const Eigen::Vector2d v = map * u;
      return Eigen::Vector2d(v + bend * Eigen::Vector2d(std::sin(v.y() / length + a), std::sin(v.x() / length + b)));
    });
  drawing.ground.amplitude = random.uniform(0.0, 7.0);
  drawing.ground.length_x = random.uniform(40.0, 70.0);
  drawing.ground.length_y = random.uniform(40.0, 70.0);
  drawing.ground.bend_x += random.uniform(-1.0, 1.0) / 600.0;
  drawing.ground.bend_y += random.uniform(-1.0, 1.0) / 600.0;
}

} // namespace

std::vector<std::string>
outlineNames()
{
  std::vector<std::string> names;
  for (const Drawing& d : drawings())
    names.push_back(d.name);
  return names;
}

SurfacePtr
outlinedPart(const std::string& name, std::uint64_t variation, double size)
{
  for (Drawing& d : drawings()) {
    if (d.name != name)
      continue;
    if (variation != 0)
      vary(d, variation);
    for (PlaneLoop& loop : d.loops)
      for (Eigen::Vector2d& u : loop)
        u *= size;
    Ground form = d.ground;
    for (double* l : {&form.amplitude, &form.length_x, &form.length_y})
      *l *= size;
    form.bend_x /= size;
    form.bend_y /= size;
    return ground(form, Region(d.loops));
  }
  throw std::out_of_range("no outline named " + name);
}

} // namespace pcl_spiral::test
