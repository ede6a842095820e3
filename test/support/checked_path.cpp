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
  if (std::abs(kappa) * r < 1e-9)
    return 2.0 * std::sqrt(2.0 * r * h - h * h);
  const double rho = 1.0 / kappa;
  const double centre = rho + r, ridge = rho + h;
  const double c = (centre * centre + ridge * ridge - r * r) / (2.0 * centre * ridge);
  return 2.0 * std::abs(rho) * std::acos(std::clamp(c, -1.0, 1.0));
}

} // namespace pcl_spiral::test
