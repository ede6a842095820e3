// SPDX-License-Identifier: BSD-3-Clause
#include "support/checked_path.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral::test {

CheckedPath
fromToolpath(const pcl::PointCloud<ToolpathPoint>& path)
{
  CheckedPath result;
  for (const ToolpathPoint& p : path) {
    result.contacts.push_back(p.getVector3fMap().cast<double>());
    result.normals.push_back(p.getNormalVector3fMap().cast<double>().normalized());
    result.turns.push_back(p.turn);
    const std::size_t i = result.size() - 1;
    if (i > 0 && p.arc_length > 0.0 && p.arc_length - path[i - 1].arc_length < 1e-5 &&
        (result.contacts[i] - result.contacts[i - 1]).norm() > 0.01)
      result.lifted_to.push_back(i);
  }
  return result;
}

double
quantile(std::vector<double>& values, double q)
{
  if (values.empty())
    return 0.0;
  const double rank = std::ceil(q * static_cast<double>(values.size())) - 1.0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::max(0.0, rank));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double
exactStepOver(double r, double h, double kappa)
{
  // sin^2(phi / 2) = (R^2 - (R - h)^2) / (4 (rho + R) (rho + h)), the cosine rule without its cancellation.
  const double chord = std::sqrt((2.0 * r * h - h * h) / ((1.0 + kappa * r) * (1.0 + kappa * h)));
  const double x = 0.5 * std::abs(kappa) * chord;
  return x < 1e-8 ? 2.0 * chord : 4.0 * std::asin(std::min(1.0, x)) / std::abs(kappa);
}

} // namespace pcl_spiral::test
