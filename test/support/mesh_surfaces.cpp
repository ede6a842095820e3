// SPDX-License-Identifier: BSD-3-Clause
#include "support/mesh_surfaces.h"

#include <pcl_spiral/core/impl/angles.h>

#include "support/height_field.h"

#include <cmath>

namespace pcl_spiral::test {
namespace {

/** A function of one variable with its first and second derivative. */
struct Curve {
  double f, d, dd;
};

Curve
cosine(double k, double x)
{
  return {std::cos(k * x), -k * std::sin(k * x), -k * k * std::cos(k * x)};
}

/** exp(-(x / w)^n), n even. */
Curve
hump(double x, double w, int n)
{
  const double u = x / w, p = std::pow(u, n), f = std::exp(-p);
  const double dp = n * std::pow(u, n - 1) / w, ddp = n * (n - 1) * std::pow(u, n - 2) / (w * w);
  return {f, -dp * f, (dp * dp - ddp) * f};
}

class Bonnet : public HeightField {
public:
  using HeightField::HeightField;
  Jet jet(double x, double y) const override
  {
    Jet j{0, 0, 0, 0, 0, 0};
    add(90.0, cosine(pi / 2400.0, x - 700.0), cosine(pi / 1900.0, y - 500.0), j);
    add(4.0, hump(x - 400.0, 60.0, 2), hump(y - 500.0, 300.0, 4), j);
    const double side = y < 500.0 ? -1.0 : 1.0, slant = 1.0 / 20.0;
    const Curve ridge = hump(std::abs(y - 500.0) - 260.0 - (x - 700.0) * slant, 45.0, 2);
    j.f += 7.0 * ridge.f;
    j.fx += 7.0 * ridge.d * -slant;
    j.fy += 7.0 * ridge.d * side;
    j.fxx += 7.0 * ridge.dd * slant * slant;
    j.fxy += 7.0 * ridge.dd * -slant * side;
    j.fyy += 7.0 * ridge.dd;
    return j;
  }

private:
  static void add(double amplitude, const Curve& a, const Curve& b, Jet& j)
  {
    j.f += amplitude * a.f * b.f;
    j.fx += amplitude * a.d * b.f;
    j.fy += amplitude * a.f * b.d;
    j.fxx += amplitude * a.dd * b.f;
    j.fxy += amplitude * a.d * b.d;
    j.fyy += amplitude * a.f * b.dd;
  }
};

} // namespace

SurfacePtr
bonnet()
{
  return std::make_shared<Bonnet>(Region({rectangle(1400.0, 1000.0, {700.0, 500.0})}));
}

} // namespace pcl_spiral::test
