// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/step_over.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

namespace {

bool
validHeight(double radius, double height)
{
  return std::isfinite(radius) && radius > 0.0 && height > 0.0 && height < radius;
}

/** sin(x) / x. */
double
sinc(double x)
{
  return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : std::sin(x) / x;
}

/** asin(x) / x for x in [0, 1]. */
double
asinc(double x)
{
  return x < 1e-4 ? 1.0 + x * x / 6.0 : std::asin(x) / x;
}

} // namespace

bool
cutterFits(double radius, double curvature)
{
  return std::isfinite(radius) && std::isfinite(curvature) && radius > 0.0 && 1.0 + curvature * radius > 0.0;
}

double
spacingCurvature(double radius, double curvature)
{
  constexpr double least = 0.05; // as in stepOverMetric
  const double share = 1.0 + radius * curvature;
  return share >= least ? curvature : (std::clamp(-share, least, 1.0) - 1.0) / radius;
}

std::optional<double>
stepOver(double radius, double curvature, double scallop_height)
{
  const double h = scallop_height;
  if (!validHeight(radius, h) || !cutterFits(radius, curvature))
    return std::nullopt;
  const double q = std::sqrt(h * (2.0 * radius - h) / ((1.0 + curvature * radius) * (1.0 + curvature * h)));
  const double half_sine = 0.5 * std::abs(curvature) * q; // sin(phi / 2)
  if (half_sine >= 1.0)
    return 2.0 * pi / std::abs(curvature);
  return 2.0 * q * asinc(half_sine);
}

std::optional<double>
stepOverFirstOrder(double radius, double curvature, double scallop_height)
{
  if (!validHeight(radius, scallop_height) || !cutterFits(radius, curvature))
    return std::nullopt;
  return std::sqrt(8.0 * scallop_height * radius / (1.0 + curvature * radius));
}

std::optional<double>
stepOverPublished(double radius, double scallop_height)
{
  if (!validHeight(radius, scallop_height))
    return std::nullopt;
  return 2.0 * std::sqrt(2.0 * scallop_height * radius);
}

std::optional<double>
scallopHeight(double radius, double curvature, double step)
{
  if (!cutterFits(radius, curvature) || !std::isfinite(step) || step < 0.0)
    return std::nullopt;
  const double angle = 0.25 * std::abs(curvature) * step; // phi / 2
  if (angle > 0.5 * pi * (1.0 + 1e-12))
    return std::nullopt;
  const double half_chord = 0.5 * step * sinc(angle); // 2 |rho| sin(phi / 2)
  const double c = half_chord * half_chord * (1.0 + curvature * radius);
  const double b = 2.0 * radius - curvature * c; // h^2 - b h + c = 0
  const double discriminant = b * b - 4.0 * c;
  if (b <= 0.0 || discriminant < 0.0)
    return std::nullopt;
  return 2.0 * c / (b + std::sqrt(discriminant));
}

double
stepFromChordError(double curvature, double chord_error, double max_step)
{
  if (!(chord_error > 0.0) || !(max_step > 0.0) || !std::isfinite(curvature))
    return 0.0;
  const double k = std::abs(curvature);
  if (k * chord_error >= 1.0)
    return std::min(max_step, 2.0 / k);
  // Multiplied out, so that a flat curve causes no division by zero.
  const double error_at_max = 0.25 * k * (max_step * max_step) + k * chord_error * chord_error;
  return error_at_max <= 2.0 * chord_error ? max_step : 2.0 * std::sqrt(chord_error * (2.0 / k - chord_error));
}

double
stepFromChordErrorAtCentre(double radius, double curvature, double chord_error, double max_step)
{
  if (!cutterFits(radius, curvature) || !(max_step > 0.0))
    return 0.0;
  const double scale = 1.0 + curvature * radius; // centre curve over contact curve
  return stepFromChordError(curvature / scale, chord_error, max_step * scale) / scale;
}

} // namespace pcl_spiral
