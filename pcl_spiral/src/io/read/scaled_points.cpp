// SPDX-License-Identifier: BSD-3-Clause
#include "scaled_points.h"

#include "found_shift.h"
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/search/impl/usable_points.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double smallest_likely_size = 5.0; ///< mm; smaller parts are probably read in the wrong unit

Diagnostic
inMillimetres(double value)
{
  return Diagnostic(value, " {mm}");
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
movedPoints(const PointColumns& columns, const ReadOptions& options, const Eigen::Vector3d& shift)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  cloud->resize(columns[0].size());
  const double scale = millimetres(options.unit);
  bool dense = true;
  for (std::size_t i = 0; i < columns[0].size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double value = scale * (columns[static_cast<std::size_t>(c)][i] - options.origin[c]) - shift[c];
      (*cloud)[i].data[c] = static_cast<float>(value);
      dense = dense && std::isfinite((*cloud)[i].data[c]);
    }
  cloud->is_dense = dense;
  return cloud;
}

/** \throw FileError if numbers are too large for any point to be used */
void
requireUsable(const std::string& file, const PointColumns& columns, const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  const auto isUsable = [](const pcl::PointXYZ& p) { return (p.getVector3fMap().array().abs() <= farthest_coordinate).all(); };
  if (std::any_of(cloud.begin(), cloud.end(), isUsable))
    return;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (const Eigen::Vector3d p(columns[0][i], columns[1][i], columns[2][i]); p.allFinite())
      throw FileError(file, Diagnostic("all coordinates are too large, such as ", SixDigits(p.cwiseAbs().maxCoeff()), " of point ", i,
                                       ": beyond ", farthest_coordinate,
                                       " {mm} they mark missing points; look at the columns, or give the "
                                       "unit ({ReadOptions::unit})"));
}

/** \p far: the coordinates are those of a map, which a shift takes away. */
Diagnostics
scaleWarnings(const std::string& file, const pcl::PointCloud<pcl::PointXYZ>& cloud, bool far, bool shifted)
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
  Diagnostics warnings;
  if (const double rounding = floatRounding(largest); rounding > noticed_rounding)
    warnings.push_back(
        Diagnostic(file, ": coordinates ", (shifted ? "still " : ""), "reach ", inMillimetres(largest),
                   ", where single precision rounds them by up to ", inMillimetres(rounding),
                   (far && !shifted
                        ? "; subtract a point near the part ({ReadOptions::origin}), or have one found ({ReadOptions::find_origin})"
                        : "; the points are spread that far, and no origin avoids it; remove points far from the part, if there are any")));
  const double size = (high - low).norm();
  if (largest > 0.0 && size < smallest_likely_size)
    warnings.push_back(
        Diagnostic(file, ": the part is ", inMillimetres(size),
                   (far ? " across, at map coordinates, which are usually in metres or feet; give their unit ({ReadOptions::unit})"
                        : " across; if the scan is in metres or inches, give its unit ({ReadOptions::unit})")));
  return warnings;
}

} // namespace

ScaledPoints
scaledPoints(const std::string& file, const PointColumns& columns, const ReadOptions& options)
{
  const Eigen::Vector3d found = foundShift(columns, options);
  ScaledPoints points;
  points.shift = options.find_origin ? found : Eigen::Vector3d::Zero();
  points.cloud = movedPoints(columns, options, points.shift);
  requireUsable(file, columns, *points.cloud);
  points.warnings = scaleWarnings(file, *points.cloud, !found.isZero(), !points.shift.isZero());
  return points;
}

ScaledPoints
scaledPoints(const std::string& file, const PointTable& table, const ReadOptions& options)
{
  return scaledPoints(file, PointColumns{table[0], table[1], table[2]}, options);
}

pcl::PointCloud<pcl::Normal>::Ptr
unitNormals(const PointColumns& columns)
{
  auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  bool any = false;
  for (std::size_t i = 0; i < columns[0].size(); ++i) {
    const Eigen::Vector3d normal(columns[0][i], columns[1][i], columns[2][i]);
    const bool known = normal.allFinite() && normal.norm() > 0.0;
    const Eigen::Vector3f n = known ? normal.normalized().cast<float>().eval() : Eigen::Vector3f(Eigen::Vector3f::Zero());
    normals->emplace_back(n.x(), n.y(), n.z());
    any = any || known;
  }
  return any ? normals : nullptr;
}

} // namespace pcl_spiral
