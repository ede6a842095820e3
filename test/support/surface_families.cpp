// SPDX-License-Identifier: BSD-3-Clause
#include "support/height_field.h"

#include <pcl_spiral/core/impl/angles.h>

#include <cmath>

namespace pcl_spiral::test {

namespace {

class SineSum : public HeightField {
public:
  SineSum(std::vector<Wave> waves, Region region) : HeightField(std::move(region)), waves_(std::move(waves)) {}
  Jet jet(double x, double y) const override
  {
    Jet j{0, 0, 0, 0, 0, 0};
    for (const auto& [amplitude, kx, ky, phase] : waves_) {
      const double s = amplitude * std::sin(kx * x + ky * y + phase);
      const double c = amplitude * std::cos(kx * x + ky * y + phase);
      j.f += s;
      j.fx += kx * c;
      j.fy += ky * c;
      j.fxx -= kx * kx * s;
      j.fxy -= kx * ky * s;
      j.fyy -= ky * ky * s;
    }
    return j;
  }

private:
  std::vector<Wave> waves_;
};

class Quadric : public HeightField {
public:
  Quadric(double cx, double cy, Region region) : HeightField(std::move(region)), cx_(cx), cy_(cy) {}
  Jet jet(double x, double y) const override { return {0.5 * (cx_ * x * x + cy_ * y * y), cx_ * x, cy_ * y, cx_, 0.0, cy_}; }

private:
  double cx_, cy_;
};

class WavyGround : public HeightField {
public:
  WavyGround(const Ground& form, Region region) : HeightField(std::move(region)), g_(form) {}
  Jet jet(double x, double y) const override
  {
    const double kx = 1.0 / g_.length_x, ky = 1.0 / g_.length_y, a = g_.amplitude;
    const double sx = std::sin(kx * x), cx = std::cos(kx * x), sy = std::sin(ky * y), cy = std::cos(ky * y);
    return {a * sx * cy + 0.5 * (g_.bend_x * x * x + g_.bend_y * y * y),
            a * kx * cx * cy + g_.bend_x * x,
            -a * ky * sx * sy + g_.bend_y * y,
            -a * kx * kx * sx * cy + g_.bend_x,
            -a * kx * ky * cx * sy,
            -a * ky * ky * sx * cy + g_.bend_y};
  }

private:
  Ground g_;
};

/** The ellipsoid x^2/a^2 + y^2/c^2 + z^2/b^2 = 1, c infinite for a cylinder; with sign -1 the normals point
 * inwards. */
class RoundSurface : public AnalyticSurface {
public:
  RoundSurface(const Eigen::Vector3d& inverse_squares, double scale, Region region)
  : AnalyticSurface(std::move(region)), q_(inverse_squares), scale_(scale)
  {}
  double value(const Eigen::Vector3d& x) const override { return 0.5 * scale_ * (x.dot(q_.cwiseProduct(x)) - 1.0); }
  Eigen::Vector3d gradient(const Eigen::Vector3d& x) const override { return scale_ * q_.cwiseProduct(x); }
  Eigen::Matrix3d hessian(const Eigen::Vector3d&) const override { return (scale_ * q_).asDiagonal().toDenseMatrix(); }
  /** The upper half over the plane, or the lower half for inward normals. */
  Eigen::Vector3d lift(const Eigen::Vector2d& u) const override
  {
    const double z = std::sqrt((1.0 - q_[0] * u.x() * u.x() - q_[1] * u.y() * u.y()) / q_[2]);
    return {u.x(), u.y(), scale_ > 0.0 ? z : -z};
  }
  Eigen::Vector2d chart(const Eigen::Vector3d& x) const override { return x.head<2>(); }
  double areaElement(const Eigen::Vector2d& u) const override
  {
    const Eigen::Vector3d g = gradient(lift(u));
    return g.norm() / std::abs(g.z());
  }

private:
  Eigen::Vector3d q_;
  double scale_;
};

/** Spheroid about z with the chart a beta (cos theta, sin theta), beta the parametric latitude from the pole.
 */
class Spheroid : public RoundSurface {
public:
  Spheroid(double a, double b, Region region) : RoundSurface({1 / (a * a), 1 / (a * a), 1 / (b * b)}, b, std::move(region)), a_(a), b_(b) {}
  Eigen::Vector3d lift(const Eigen::Vector2d& u) const override
  {
    const double rho = u.norm(), beta = rho / a_;
    const Eigen::Vector2d plan = rho > 0.0 ? Eigen::Vector2d(a_ * std::sin(beta) / rho * u) : u;
    return {plan.x(), plan.y(), b_ * std::cos(beta)};
  }
  Eigen::Vector2d chart(const Eigen::Vector3d& x) const override
  {
    const double r = x.head<2>().norm();
    const double beta = std::atan2(r / a_, x.z() / b_);
    return r > 0.0 ? Eigen::Vector2d(a_ * beta / r * x.head<2>()) : Eigen::Vector2d(x.head<2>());
  }
  double areaElement(const Eigen::Vector2d& u) const override
  {
    const double beta = u.norm() / a_;
    const double ratio = beta > 1e-9 ? std::sin(beta) / beta : 1.0;
    return ratio * std::hypot(a_ * std::cos(beta), b_ * std::sin(beta)) / a_;
  }

private:
  double a_, b_;
};

} // namespace

SurfacePtr
flat(Region region)
{
  return std::make_shared<Quadric>(0.0, 0.0, std::move(region));
}

SurfacePtr
freeform()
{
  return waves({{105.9, 0.004286, 0.00132, 1.687}, {129.2, -0.001399, 0.004411, 2.88}, {7.714, 0.004276, -0.008126, 2.695}},
               Region({rectangle(1000.0, 1000.0)}));
}

SurfacePtr
waves(std::vector<Wave> sum, Region region)
{
  return std::make_shared<SineSum>(std::move(sum), std::move(region));
}

SurfacePtr
landform(double size)
{
  constexpr double k60 = 2.0 * pi / 60.0, k38 = 2.0 * pi / 38.0, k25 = 2.0 * pi / 25.0;
  return waves({{1.6, k60, 0.3 * k60, 0.3}, {0.9, 0.5 * k38, k38, 1.1}, {0.35, -k25, 0.6 * k25, 2.0}},
               Region({rectangle(size, size, {0.5 * size, 0.5 * size})}));
}

SurfacePtr
spheroidCap(double a, double b, double hole_radius)
{
  std::vector<PlaneLoop> loops{circle({0.0, 0.0}, 0.5 * pi * a)};
  if (hole_radius > 0.0)
    loops.push_back(circle({0.0, 0.0}, a * std::asin(hole_radius / a)));
  return std::make_shared<Spheroid>(a, b, Region(std::move(loops)));
}

SurfacePtr
bowl(double radius, double opening)
{
  const Eigen::Vector3d q = Eigen::Vector3d::Constant(1.0 / (radius * radius));
  return std::make_shared<RoundSurface>(q, -radius, Region({circle({0.0, 0.0}, opening)}));
}

SurfacePtr
ball(double radius, Region region)
{
  const Eigen::Vector3d q = Eigen::Vector3d::Constant(1.0 / (radius * radius));
  return std::make_shared<RoundSurface>(q, radius, std::move(region));
}

SurfacePtr
cylinder(double radius, Region region)
{
  const double q = 1.0 / (radius * radius);
  return std::make_shared<RoundSurface>(Eigen::Vector3d(q, 0.0, q), radius, std::move(region));
}

SurfacePtr
quadric(double rx, double ry, Region region)
{
  return std::make_shared<Quadric>(1.0 / rx, 1.0 / ry, std::move(region));
}

SurfacePtr
ground(const Ground& form, Region region)
{
  return std::make_shared<WavyGround>(form, std::move(region));
}

SurfacePtr
ovalSaddle()
{
  return quadric(250.0, -200.0, Region({ellipse(150.0, 100.0)}));
}

SurfacePtr
offCentreAnnulus()
{
  return quadric(-600.0, -600.0, Region({circle({0.0, 0.0}, 150.0), circle({40.0, 25.0}, 45.0)}));
}

SurfacePtr
kidneyPatch()
{
  return quadric(800.0, -500.0, Region({kidney(120.0, 60.0, 0.006)}));
}

SurfacePtr
boomerangPatch()
{
  return quadric(800.0, -500.0, Region({kidney(120.0, 45.0, 0.012)}));
}

SurfacePtr
ellPatch()
{
  return quadric(-600.0, -900.0, Region({ell(200.0, 90.0)}));
}

} // namespace pcl_spiral::test
