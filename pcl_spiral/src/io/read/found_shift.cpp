// SPDX-License-Identifier: BSD-3-Clause
#include "found_shift.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace pcl_spiral {
namespace {

constexpr double least_step = 1.0; ///< mm

/** One coordinate of the points, mm: its median and the width of its middle 90 %, which a few points elsewhere do not change. */
struct Spread {
  double median = 0.0, width = 0.0;
};

Spread
spreadOf(const NumberColumn& column, double scale, double origin)
{
  std::vector<double> values;
  for (std::size_t i = 0; i < column.size(); ++i)
    if (std::isfinite(column[i]))
      values.push_back(scale * (column[i] - origin));
  if (values.empty())
    return {};
  const auto quantile = [&](double share) {
    const auto at = values.begin() + std::lround(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
  };
  const double low = quantile(0.05), high = quantile(0.95);
  return {quantile(0.5), high - low};
}

} // namespace

double
floatRounding(double value)
{
  const auto rounded = static_cast<float>(std::abs(value));
  return 0.5 * (std::nextafter(rounded, std::numeric_limits<float>::max()) - rounded);
}

Eigen::Vector3d
foundShift(const PointColumns& columns, const ReadOptions& options)
{
  const double scale = millimetres(options.unit);
  const auto matters = [&](std::size_t c) {
    for (std::size_t i = 0; i < columns[c].size(); ++i)
      if (floatRounding(scale * (columns[c][i] - options.origin[static_cast<Eigen::Index>(c)])) > noticed_rounding)
        return true;
    return false;
  };
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(), width = Eigen::Vector3d::Zero();
  if (!matters(0) && !matters(1) && !matters(2))
    return shift;
  for (Eigen::Index c = 0; c < 3; ++c) {
    const Spread spread = spreadOf(columns[static_cast<std::size_t>(c)], scale, options.origin[c]);
    shift[c] = spread.median;
    width[c] = spread.width;
  }
  const double step = std::max(least_step, std::pow(10.0, std::ceil(std::log10(width.norm()))));
  for (double& coordinate : shift)
    coordinate = floatRounding(coordinate) > noticed_rounding && std::abs(coordinate) >= step ? step * std::round(coordinate / step) : 0.0;
  return shift;
}

} // namespace pcl_spiral
