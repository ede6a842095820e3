// SPDX-License-Identifier: BSD-3-Clause
#include "drawn_part.h"

#include "support/height_field.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace pcl_spiral::awkward {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

using Arguments = std::vector<std::string>;

/** The part stands on a table between clamps, which do not touch it. */
void
tableAndClamps(Scene& s, test::Random& random)
{
  drawScan(s, drawnPart(random, s.size), random);
  s.motion = levelMotion(random, 200.0);
  const double down = random.uniform(20.0, 40.0);
  addTable(s, -down, random.uniform(20.0, 80.0));
  std::vector<Box> clamps;
  for (std::size_t i = 2 + random.below(3); i > 0; --i) {
    Box clamp;
    clamp.half_x = random.uniform(5.0, 10.0);
    clamp.half_y = random.uniform(5.0, 10.0);
    clamp.bottom = -down;
    clamp.top = random.uniform(5.0, 15.0);
    const double angle = random.uniform(0.0, full_turn);
    const Vector2d way(std::cos(angle), std::sin(angle));
    // outward until the clamp is clear of the part by more than the ball, and of the other clamps
    for (double out = 0.0;; out += 2.0) {
      clamp.centre = out * way;
      if (isClear(*s.part, clamp, 2.0 * s.radius + 2.0) &&
          std::none_of(clamps.begin(), clamps.end(), [&](const Box& other) { return overlap(clamp, other); }))
        break;
    }
    clamps.push_back(clamp);
    addBox(s, clamp);
  }
  s.exempt_kept_out = [clamps, radius = s.radius](const Vector3d& x) {
    return std::any_of(clamps.begin(), clamps.end(), [&](const Box& clamp) {
      return clamp.covers(x.head<2>(), 2.0 * radius + 3.0 + 0.5 * std::max(0.0, clamp.top - x.z())); // the shank leans
    });
  };
  const Vector3d on = innerPlace(*s.part, 10.0, random);
  s.steps = {{{}, Outcome::PathOrRefusal, {"part-at"}},
             {{"--part-at", s.place(on)}, Outcome::PathOrRefusal, {"shank"}},
             {{"--part-at", s.place(on), "--tilt", "0"}, Outcome::PathOrRefusal, {"shank"}}};
}

/** The part lies on a table only a few points below its rim, and no side is seen. */
void
lowOnTable(Scene& s, test::Random& random)
{
  drawScan(s, drawnPart(random, s.size), random);
  s.motion = levelMotion(random, 200.0);
  Polyline rim;
  const test::PlaneLoop& outline = s.part->region().loops().front();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d side = outline[(i + 1) % outline.size()] - outline[i];
    const int steps = 1 + static_cast<int>(2.0 * side.norm());
    for (int k = 0; k < steps; ++k)
      rim.push_back(s.part->lift(outline[i] + side * k / steps));
  }
  const auto lower = [](const Vector3d& a, const Vector3d& b) { return a.z() < b.z(); };
  const double table = std::min_element(rim.begin(), rim.end(), lower)->z() - s.spacing * random.uniform(3.0, 12.0);
  addTable(s, table, random.uniform(10.0, 60.0));
  for (const Vector3d& top : rim)
    for (double z = table; z < top.z(); z += 0.5)
      s.bodies.emplace_back(top.x(), top.y(), z);
  s.steps = {{{}, Outcome::Refusal, {"part-at"}}, {{"--part-at", s.place(innerPlace(*s.part, 10.0, random))}, Outcome::Path, {}}};
}

/** A clamp stands on the part. */
void
clampOnPart(Scene& s, test::Random& random)
{
  drawScan(s, drawnPartOf(std::max(80.0, 110.0 * s.size), random), random);
  s.motion = levelMotion(random, 200.0);
  const Vector3d under = innerPlace(*s.part, 8.0, random);
  Box clamp;
  clamp.centre = under.head<2>();
  clamp.half_x = random.uniform(4.0, 8.0);
  clamp.half_y = random.uniform(4.0, 8.0);
  clamp.turn = random.uniform(0.0, 1.5);
  clamp.bottom = under.z() - 3.0;
  clamp.top = under.z() + random.uniform(8.0, 20.0);
  addBox(s, clamp);
  s.keep_out = clamp.outline(0.5);
  const double around = 2.0 * s.radius + 3.0 + 0.5 * (clamp.top - under.z()); // the shank leans by 17 degrees and the slope
  s.exempt = [clamp, around](const Vector3d& x) { return clamp.covers(x.head<2>(), around); };
  s.exempt_kept_out = [clamp, around](const Vector3d& x) { return clamp.covers(x.head<2>(), around + 4.0); }; // a polygon by the message
  Vector3d on = innerPlace(*s.part, 3.0, random);
  for (int i = 0; i < 100 && clamp.covers(on.head<2>(), 3.0); ++i)
    on = innerPlace(*s.part, 3.0, random);
  s.steps = {{{}, Outcome::PathOrRefusal, {"at (|over (|through ("}},
             {{"--part-at", s.place(on)}, Outcome::PathOrRefusal, {"at (|over (|through ("}},
             {{"--part-at", s.place(on), "--keep-out", "keep.txt"}, Outcome::Path, {}}};
}

/** The frame of a camera: z grows away from it, so the outer side faces -z. */
void
cameraFrame(Scene& s, test::Random& random)
{
  drawScan(s, drawnPart(random, s.size), random);
  const double lean = random.uniform(0.0, 0.5), far = random.uniform(300.0, 800.0);
  s.motion.linear() =
      (Eigen::AngleAxisd(full_turn / 2.0 + lean, Vector3d::UnitX()) * Eigen::AngleAxisd(random.uniform(0.0, full_turn), Vector3d::UnitZ()))
          .toRotationMatrix();
  s.motion.translation() = Vector3d(0.0, 0.0, far);
  if (random.below(2) == 0) {
    s.file = "scan.pcd";
    s.view_point = Vector3d(0.0, 0.0, 1.0);
    s.steps = {{{}, Outcome::Path, {"view point"}}};
  }
  else
    s.steps = {{{"--view-point", "0,0,0"}, Outcome::Path, {"view point"}}, {{"--flip-normals"}, Outcome::Path, {"other side"}}};
}

/** Metres of a map. */
void
mapCoordinates(Scene& s, test::Random& random)
{
  drawScan(s, drawnPart(random, s.size), random);
  s.motion = levelMotion(random, 1.0);
  s.unit = 1000.0;
  s.motion.translation() = 1000.0 * Vector3d(random.uniform(2e5, 8e5), random.uniform(1e6, 9e6), random.uniform(0.0, 900.0));
  s.steps = {{{"--units", "m"}, Outcome::Path, {"shift|origin"}},
             {{"--units", "m", "--start", s.place(innerPlace(*s.part, 0.0, random))}, Outcome::Path, {"shift|origin"}}};
}

/** The wall of a cone about z, widening upwards; chart: angle times the radius at z = 0, and z. */
class Wall : public test::AnalyticSurface {
public:
  Wall(test::Region region, double radius, double slope, bool inside)
  : AnalyticSurface(std::move(region)), radius_(radius), slope_(slope), sign_(inside ? -1.0 : 1.0)
  {}
  double value(const Vector3d& x) const override { return sign_ * (x.head<2>().norm() - radius_ - slope_ * x.z()); }
  Vector3d gradient(const Vector3d& x) const override
  {
    const Vector2d out = x.head<2>().normalized();
    return sign_ * Vector3d(out.x(), out.y(), -slope_);
  }
  Eigen::Matrix3d hessian(const Vector3d& x) const override
  {
    const Vector2d out = x.head<2>().normalized();
    Eigen::Matrix3d h = Eigen::Matrix3d::Zero();
    h.topLeftCorner<2, 2>() = sign_ * (Eigen::Matrix2d::Identity() - out * out.transpose()) / x.head<2>().norm();
    return h;
  }
  Vector3d lift(const Vector2d& u) const override
  {
    const double r = radius_ + slope_ * u.y(), angle = u.x() / radius_;
    return {r * std::cos(angle), r * std::sin(angle), u.y()};
  }
  Vector2d chart(const Vector3d& x) const override { return {radius_ * std::atan2(x.y(), x.x()), x.z()}; }
  double areaElement(const Vector2d& u) const override { return (radius_ + slope_ * u.y()) / radius_ * std::sqrt(1.0 + slope_ * slope_); }

private:
  double radius_, slope_, sign_;
};

/** Part of the belly of a jug, from outside or inside: +z hardly tells the side. */
void
jug(Scene& s, test::Random& random)
{
  const double radius = s.size * random.uniform(30.0, 50.0), height = s.size * random.uniform(40.0, 70.0), turn = random.uniform(0.25, 0.7);
  const bool inside = random.below(2) == 0;
  const test::Region region({test::rectangle(full_turn * radius * turn, height, {0.0, 0.5 * height})});
  drawScan(s, std::make_shared<Wall>(region, radius, random.uniform(0.05, 0.4), inside), random);
  s.motion = levelMotion(random, 100.0);
  const double pole = inside ? 0.0 : 10.0 * radius;
  switch (random.below(3)) {
  case 0:
    s.file = "scan.ply";
    s.steps = {{{}, Outcome::Path, {"normals"}}};
    return;
  case 1:
    s.file = "scan.pcd";
    s.view_point = s.motion * Vector3d(pole, 0.0, 0.5 * height);
    s.steps = {{{}, Outcome::Path, {"view point"}}};
    return;
  default:
    s.steps = {{{"--view-point", s.place(Vector3d(pole, 0.0, 0.5 * height))}, Outcome::Path, {"view point"}}};
  }
}

/** A valley of two slopes that meet in a fillet tighter than the ball. */
class Valley : public test::HeightField {
public:
  Valley(test::Region region, double slope, double fillet) : HeightField(std::move(region)), slope_(slope), width_(fillet * slope) {}
  Jet jet(double x, double) const override
  {
    const double root = std::sqrt(x * x + width_ * width_);
    return {slope_ * root, slope_ * x / root, 0.0, slope_ * width_ * width_ / (root * root * root), 0.0, 0.0};
  }

private:
  double slope_, width_; // curvature at x = 0: slope / width
};

void
tightFillet(Scene& s, test::Random& random)
{
  const double slope = random.uniform(0.4, 0.9), fillet = random.uniform(1.5, 2.5);
  const test::PlaneLoop outline =
      test::rectangle(s.size * random.uniform(50.0, 90.0), s.size * random.uniform(40.0, 70.0), {random.uniform(-8.0, 8.0), 0.0});
  drawScan(s, std::make_shared<Valley>(test::Region({outline}), slope, fillet), random);
  s.noise = 0.0;
  s.spacing = 0.4;
  s.scan = test::sampleUniform(*s.part, static_cast<std::size_t>(2.0 * s.part->area() / 0.16), random.below(1u << 30));
  s.radius = fillet + random.uniform(1.0, 2.0);
  s.motion = levelMotion(random, 100.0);
  const double around = 2.0 * s.radius;
  s.exempt = [around](const Vector3d& x) { return std::abs(x.x()) < around; };
  s.steps = {{{}, Outcome::Path, {"reach|lifted"}}, {{"--tight", "refuse"}, Outcome::Refusal, {"tight", "at ("}}};
}

/** Twenty times as long as wide. */
void
strip(Scene& s, test::Random& random)
{
  const double width = random.uniform(8.0, 14.0);
  test::Ground form;
  form.bend_x = random.uniform(-0.002, 0.002);
  form.bend_y = random.uniform(-0.01, 0.003);
  drawScan(s, test::ground(form, test::Region({test::rectangle(20.0 * width, width)})), random);
  s.motion = test::randomMotion(random.below(1u << 30), 100.0);
  s.motion.linear() = levelMotion(random, 0.0).linear();
  s.steps = {{{}, Outcome::Path, {}}};
}

/** A few points stand off the surface, close together. */
void
cluster(Scene& s, test::Random& random)
{
  drawScan(s, drawnPart(random, s.size), random);
  s.motion = levelMotion(random, 100.0);
  const Vector3d below = innerPlace(*s.part, 12.0, random), up = s.part->normal(below);
  const double height = random.uniform(1.0, 8.0);
  for (std::size_t i = 4 + random.below(20); i > 0; --i) {
    const Vector3d p = below + height * up + 1.5 * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), 0.2 * random.uniform(-1, 1));
    s.scan.points.push_back(p);
    s.scan.normals.push_back(up);
    s.bodies.push_back(p);
  }
  const double around = 2.0 * s.radius + 4.0;
  s.exempt = [below, around](const Vector3d& x) { return (x - below).norm() < around; };
  s.exempt_kept_out = [below, around, height](const Vector3d& x) { return (x - below).norm() < around + 4.0 + 0.5 * height; };
  s.steps = {{{}, Outcome::PathOrRefusal, {"at (|over (|through ("}}};
}

/** Single echoes far from each other, which the program removes. */
void
echoes(Scene& s, test::Random& random)
{
  drawScan(s, drawnPart(random, s.size), random);
  s.motion = levelMotion(random, 100.0);
  std::vector<Vector3d> feet;
  for (int i = 0; i < 12; ++i) {
    const Vector3d foot = innerPlace(*s.part, 2.0, random);
    if (std::any_of(feet.begin(), feet.end(), [&](const Vector3d& other) { return (other - foot).norm() < 12.0; }))
      continue;
    feet.push_back(foot);
    s.scan.points.push_back(foot + random.uniform(2.0, 10.0) * s.part->normal(foot));
    s.scan.normals.push_back(s.part->normal(foot));
  }
  s.steps = {{{}, Outcome::Path, {}}};
}

/** Trees on the ground: loose points over it, and no ground below them. */
void
trees(Scene& s, test::Random& random)
{
  drawScan(s, drawnPartOf(std::max(90.0, 120.0 * s.size), random), random); // there is part left between them
  s.motion = levelMotion(random, 100.0);
  std::vector<std::pair<Vector3d, double>> feet; // and the room that a tree takes
  for (std::size_t i = 2 + random.below(s.size < 1.0 ? 2 : 8); i > 0; --i) {
    const Vector3d foot = innerPlace(*s.part, 4.0, random);
    const double crown = random.uniform(2.0, 6.0), height = random.uniform(4.0, 12.0);
    feet.push_back({foot, 2.0 * crown + 2.0 * s.radius + 0.5 * height});
    for (int k = 0; k < 60; ++k) {
      const Vector3d p = foot + Vector3d(0.0, 0.0, height) + crown * Vector3d(random.normal(), random.normal(), random.normal()) / 2.0;
      s.scan.points.push_back(p);
      s.scan.normals.push_back(Vector3d::UnitZ());
    }
  }
  s.exempt = [feet](const Vector3d& x) {
    return std::any_of(feet.begin(), feet.end(), [&](const auto& foot) { return (x - foot.first).norm() < foot.second; });
  };
  s.steps = {{{}, Outcome::PathOrRefusal, {"at (|over (|through ("}}};
}

const std::map<std::string, std::function<void(Scene&, test::Random&)>>&
makers()
{
  static const std::map<std::string, std::function<void(Scene&, test::Random&)>> all{
      {"table", tableAndClamps}, {"low", lowOnTable}, {"clamp", clampOnPart},  {"camera", cameraFrame},
      {"map", mapCoordinates},   {"jug", jug},        {"fillet", tightFillet}, {"strip", strip},
      {"cluster", cluster},      {"echoes", echoes},  {"trees", trees}};
  return all;
}

} // namespace

std::string
Scene::place(const Vector3d& x) const
{
  const Vector3d p = motion * x / unit;
  std::ostringstream text;
  text << std::fixed << std::setprecision(6) << p.x() << ',' << p.y() << ',' << p.z();
  return text.str();
}

std::vector<std::string>
kinds()
{
  std::vector<std::string> names;
  for (const auto& [name, make] : makers())
    names.push_back(name);
  return names;
}

Scene
makeScene(const std::string& kind, std::uint64_t seed, std::uint64_t index, double size)
{
  test::Random random(seed * 1000003 + index);
  Scene scene;
  scene.size = size;
  makers().at(kind)(scene, random);
  scene.name = kind + " " + std::to_string(seed) + "/" + std::to_string(index);
  return scene;
}

} // namespace pcl_spiral::awkward
