// SPDX-License-Identifier: BSD-3-Clause
#include "support/range_view.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace pcl_spiral::test {
namespace {

using Eigen::Vector3d;

/** Numbers in ranges, the same with every compiler. */
class Sizes {
public:
  explicit Sizes(unsigned int seed) : random_(seed) {}
  double operator()(double low, double high) { return low + (high - low) * (random_() / 4294967296.0); }
  double normal() { return std::sqrt(-2.0 * std::log(1.0 - (*this)(0.0, 1.0))) * std::cos(2.0 * M_PI * (*this)(0.0, 1.0)); }

private:
  std::mt19937 random_;
};

// Signed distances, or bounds of them (Quilez, Distance functions).
double
ellipsoid(const Vector3d& p, const Vector3d& centre, const Vector3d& radii)
{
  const double k0 = (p - centre).cwiseQuotient(radii).norm(), k1 = (p - centre).cwiseQuotient(radii.cwiseProduct(radii)).norm();
  return k1 < 1e-12 ? -radii.minCoeff() : k0 * (k0 - 1.0) / k1;
}

double
capsule(const Vector3d& p, const Vector3d& a, const Vector3d& b, double radius)
{
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm() - radius;
}

double
block(const Vector3d& p, const Vector3d& centre, const Vector3d& half, double round)
{
  const Vector3d q = ((p - centre).cwiseAbs() - half).array() + round;
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - round;
}

/** About z. */
double
cylinder(const Vector3d& p, const Vector3d& centre, double radius, double half, double round)
{
  const double out = std::hypot(p.x() - centre.x(), p.y() - centre.y()) - radius + round,
               over = std::abs(p.z() - centre.z()) - half + round;
  return std::min(std::max(out, over), 0.0) + std::hypot(std::max(out, 0.0), std::max(over, 0.0)) - round;
}

/** Both together, with a fillet about as wide as \p width. */
double
joined(double a, double b, double width)
{
  const double h = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - h * h * width / 4.0;
}

SignedDistance
bust(Sizes& size)
{
  const Vector3d head(size(-4, 4), size(20, 30), 0), radii(size(28, 34), size(36, 42), size(30, 36));
  const double nose_y = size(18, 24) - 24.0, nose_z = size(30, 36), nose = size(5, 8), ear_x = size(28, 33), ear = size(7, 10),
               brow = size(33, 37) - 4.0, neck = size(16, 20);
  const Vector3d shoulders(size(60, 75), size(18, 24), size(24, 30));
  return [=](const Vector3d& p) {
    double d = joined(ellipsoid(p, head, radii), ellipsoid(p, head + Vector3d(0, nose_y, nose_z), {nose, 1.6 * nose, 1.5 * nose}), 4);
    for (const double side : {-1.0, 1.0})
      d = joined(d, ellipsoid(p, head + Vector3d(side * ear_x, 0, 0), {4, ear, ear}), 2);
    d = joined(d, capsule(p, {0, -40, -6}, {0, 10, -4}, neck), 8);
    d = joined(d, ellipsoid(p, {0, -45, -8}, shoulders), 8);
    return 0.8 * joined(d, capsule(p, head + Vector3d(-14, 10, brow), head + Vector3d(14, 10, brow), 3.5), 3);
  };
}

SignedDistance
hand(Sizes& size)
{
  struct Finger {
    Vector3d base, middle, tip;
    double radius;
  };
  std::vector<Finger> fingers;
  const double spread = size(0.1, 0.3), curl = size(-0.1, 0.5);
  for (int i = 0; i < 4; ++i) {
    const double angle = spread * (i - 1.5);
    const Vector3d base(-27.0 + 18.0 * i, 15, 0), middle = base + Vector3d(35 * std::sin(angle), 35, size(-6, 10));
    const Vector3d tip = middle + Vector3d(28 * std::sin(angle), 28 * std::cos(curl), 28 * std::sin(curl) - size(0, 10));
    fingers.push_back({base, middle, tip, size(7, 9)});
  }
  const Finger thumb{{-30, -25, 0}, {-50, 0, size(0, 12)}, {-56, 22, size(0, 16)}, size(8, 10)};
  return [=](const Vector3d& p) {
    const auto distance = [&p](const Finger& f) {
      return std::min(capsule(p, f.base, f.middle, f.radius), capsule(p, f.middle, f.tip, 0.92 * f.radius));
    };
    double d = block(p, {0, -15, 0}, {36, 34, 11}, 10);
    for (const Finger& f : fingers)
      d = joined(d, distance(f), 3);
    d = joined(d, distance(thumb), 5);
    return 0.9 * joined(d, capsule(p, {0, -40, -2}, {0, -80, -4}, 20), 8);
  };
}

SignedDistance
bracket(Sizes& size)
{
  const double angle = size(0.2, 0.9), length = size(40, 60), hole = size(6, 12), gusset = size(3, 5);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(-angle, Vector3d::UnitX()).toRotationMatrix();
  return [=](const Vector3d& p) {
    double d = joined(block(p, {0, -40, 0}, {45, 40, 5}, 2), block(turn * p, {0, 0.5 * length, 0}, {45, 0.5 * length, 5}, 2), 5);
    d = joined(d, block(p, {0, -20, 10}, {gusset, 22, 14}, 1), 2);
    d = std::max(d, -cylinder(p, {-22, -45, 0}, hole, 20, 0));
    d = joined(d, cylinder(p, {22, -50, 8}, 9, 8, 1), 1);
    return 0.9 * joined(d, cylinder(p, {22, -50, 14}, 5, 14, 1), 1);
  };
}

SignedDistance
casting(Sizes& size)
{
  struct Boss {
    double x, y, radius, half;
  };
  std::array<Boss, 3> bosses{};
  for (Boss& b : bosses)
    b = {size(-50, 50), size(-40, 40), size(8, 16), size(8, 25)};
  const double rib_y = size(-25, 25), rib_x = size(-35, 35), half = size(8, 20), pocket = size(14, 24);
  const Vector3d middle(size(-30, 30), size(-20, 20), 8);
  return [=](const Vector3d& p) {
    double d = std::max(block(p, Vector3d::Zero(), {75, 60, 8}, 3), -cylinder(p, middle, pocket, 6, 2));
    for (const Boss& b : bosses)
      d = joined(d, cylinder(p, {b.x, b.y, 8}, b.radius, b.half, 1.5), 3);
    d = joined(d, block(p, {0, rib_y, 8}, {70, 3, half}, 1.5), 3);
    return 0.9 * joined(d, block(p, {rib_x, 0, 8}, {3, 55, half}, 1.5), 3);
  };
}

} // namespace

SignedDistance
foldedPart(FoldedPart kind, unsigned int seed)
{
  Sizes size(seed);
  const SignedDistance part = kind == FoldedPart::Bust      ? bust(size)
                              : kind == FoldedPart::Hand    ? hand(size)
                              : kind == FoldedPart::Bracket ? bracket(size)
                                                            : casting(size);
  const double angle = size(0.0, 0.35);
  const Vector3d about = Vector3d(size(-1, 1), size(-1, 1), size(-1, 1)).normalized();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, about).toRotationMatrix();
  return [part, turn](const Vector3d& p) { return part(turn * p); };
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
rangeView(const SignedDistance& part, double noise, unsigned int seed)
{
  constexpr int side = 256;
  constexpr double across = 200.0, away = 500.0, nearest = 350.0, farthest = 650.0, closeness = 1e-3;
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  Sizes random(seed);
  const Vector3d camera(0, 0, away);
  const auto view = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double x = (column + 0.5) / side - 0.5, y = (row + 0.5) / side - 0.5;
      const Vector3d ray = Vector3d(x * across, y * across, -away).normalized();
      double t = nearest, distance = part(camera + t * ray); // sphere tracing (Hart 1996)
      for (int k = 0; k < 200 && distance >= closeness && t < farthest; ++k) {
        t += distance;
        distance = part(camera + t * ray);
      }
      const double drawn = random(0.0, 1.0), off = noise * random.normal() + 0.7 * noise * std::sin(0.35 * column);
      const Eigen::Vector3f p = (camera + (t + off) * ray).cast<float>();
      view->push_back(distance < closeness && drawn > 0.01 ? pcl::PointXYZ(p.x(), p.y(), p.z()) : pcl::PointXYZ(nan, nan, nan));
    }
  view->width = view->height = side;
  view->is_dense = false;
  view->sensor_origin_.head<3>() = camera.cast<float>();
  return view;
}

} // namespace pcl_spiral::test
