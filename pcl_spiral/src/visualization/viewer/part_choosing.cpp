// SPDX-License-Identifier: BSD-3-Clause
#include "part_choosing.h"

#include "common/formatted_text.h"
#include <pcl_spiral/io/file_error.h>

#include <pcl/common/point_tests.h>

#include <fstream>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double at_pixel = 4.0, reach = 12.0; ///< pixels

} // namespace

std::string
partInWords(const PartSelection& part)
{
  if (!part.place.empty())
    return "place in the file: " + part.place;
  return "wrote " + part.file + ", with " + std::to_string(part.points) + " points inside";
}

std::optional<Eigen::Vector3d>
pickScanPoint(const PartView& view, const pcl::PointCloud<pcl::PointXYZ>& cloud, const Eigen::Vector2d& pixel)
{
  const Eigen::Vector3d towards = view.projection().towards();
  std::optional<Eigen::Vector3d> front, beside;
  double highest = std::numeric_limits<double>::lowest(), least = reach;
  for (const pcl::PointXYZ& point : cloud) {
    if (!pcl::isFinite(point))
      continue;
    const Eigen::Vector3d place = point.getVector3fMap().cast<double>();
    const double off = (view.onScreen(place) - pixel).norm();
    if (off <= at_pixel && place.dot(towards) > highest) {
      highest = place.dot(towards);
      front = place;
    }
    if (off <= least) {
      least = off;
      beside = place;
    }
  }
  return front ? front : beside;
}

std::string
placeInFile(const Eigen::Vector3d& place, const FileCoordinates& in_file)
{
  const Eigen::Vector3d p = in_file(place);
  return formatted("%.10g,%.10g,%.10g", p.x(), p.y(), p.z());
}

void
writePolygon(const std::string& file, const std::vector<Eigen::Vector3d>& corners, const FileCoordinates& in_file)
{
  std::string text = "# a lasso: extended along the direction in which it was seen\n";
  for (const Eigen::Vector3d& corner : corners) {
    const Eigen::Vector3d p = in_file(corner);
    text += formatted("%.15g %.15g %.15g\n", p.x(), p.y(), p.z());
  }
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out)
    throw FileError(file, "this polygon cannot be written; start the viewer in a folder that can be written");
}

} // namespace pcl_spiral
