// SPDX-License-Identifier: BSD-3-Clause
#include "sampling_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {

double
samplingGap(const CutterProfile& profile, const SampledContact& contact)
{
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  const double d = contact.covering_radius, R = profile.radius(), r = profile.cornerRadius();
  const double cosine = std::cos(contact.lean), tangent = std::tan(contact.lean);
  if (!(d < R) || !(cosine > 1e-3))
    return unbounded;
  const double D = contact.distance + d <= R ? d : 2.0 * d;
  const double convex = std::max(0.0, contact.curvature);
  // At the distance x across the axis, the surface falls from the contact by at most this.
  const auto fall = [&](double x) { return x * tangent + 0.5 * convex * x * x * (1.0 + tangent * tangent) / cosine; };
  double bound = unbounded;
  if (r > 0.0) {
    const double b = cosine / (1.0 / r + convex) - D * std::sin(contact.lean);
    if (b >= D)
      bound = D * D / (b + std::sqrt(b * b - D * D));
  }
  if (profile.flatRadius() >= d) {
    const double x = std::max(0.0, contact.distance - profile.flatRadius()) + 2.0 * d;
    bound = std::min(bound, std::max(0.0, fall(x) - profile.height(std::min(contact.distance, R))));
  }
  if (profile.flankAngle() > 0.0)
    bound = std::min(bound, D / std::tan(profile.flankAngle()) + fall(D));
  return bound;
}

} // namespace pcl_spiral
