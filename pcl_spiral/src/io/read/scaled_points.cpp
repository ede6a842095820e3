// SPDX-License-Identifier: BSD-3-Clause
#include "scaled_points.h"

#include "common/formatted_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double noticed_rounding = 0.001;   ///< mm; a fifth of the usual chord error
constexpr double smallest_likely_size = 5.0; ///< mm; smaller parts are probably read in the wrong unit

std::string
inMillimetres(double value)
{
  return formatted("%.3g mm", value);
}

} // namespace

pcl::PointCloud<pcl::PointXYZ>::Ptr
scaledPoints(const PointTable& table, const ReadOptions& options)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->resize(table[0].size());
  const double scale = millimetres(options.unit);
  bool dense = true;
  for (std::size_t i = 0; i < table[0].size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double value = scale * (table[static_cast<std::size_t>(c)][i] - options.origin[c]);
      (*cloud)[i].data[c] = static_cast<float>(value);
      dense = dense && std::isfinite((*cloud)[i].data[c]);
    }
  cloud->is_dense = dense;
  return cloud;
}

std::vector<std::string>
scaleWarnings(const std::string& file, const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  double largest = 0.0;
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
  Eigen::Vector3d high = -low;
  for (const pcl::PointXYZ& point : cloud) {
    const Eigen::Vector3d p = point.getVector3fMap().cast<double>();
    if (!p.allFinite())
      continue;
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  std::vector<std::string> warnings;
  const auto rounded = static_cast<float>(largest);
  const double rounding = 0.5 * (std::nextafter(rounded, std::numeric_limits<float>::max()) - rounded);
  if (rounding > noticed_rounding)
    warnings.push_back(file + ": coordinates reach " + inMillimetres(largest) + ", where single precision rounds them by up to " +
                       inMillimetres(rounding) + "; subtract a point near the part (ReadOptions::origin)");
  const double size = (high - low).norm();
  if (largest > 0.0 && size < smallest_likely_size)
    warnings.push_back(file + ": the part is " + inMillimetres(size) +
                       " across; if the scan is in metres or inches, give its unit (ReadOptions::unit)");
  return warnings;
}

} // namespace pcl_spiral
