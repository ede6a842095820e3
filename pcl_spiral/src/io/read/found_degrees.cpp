// SPDX-License-Identifier: BSD-3-Clause
#include "found_degrees.h"

#include "io/byte_file.h"

#include "common/formatted_text.h"
#include "common/shell_word.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double most_longitude = 180.0, most_latitude = 90.0;
constexpr double widest_scan = 5.0; ///< degrees, 550 km

/** Corners of the box of the finite points; low is above high if there is none, or if one is outside of the degrees. */
struct Box {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::max()), high = -low;

  explicit Box(const PointTable& table)
  {
    for (std::size_t i = 0; i < table[0].size(); ++i) {
      const Eigen::Vector3d p(table[0][i], table[1][i], table[2][i]);
      if (!p.allFinite())
        continue;
      if (std::abs(p.x()) > most_longitude || std::abs(p.y()) > most_latitude) {
        low.setConstant(std::numeric_limits<double>::max());
        high = -low;
        return;
      }
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  double width() const { return (high - low).head<2>().maxCoeff(); }
};

} // namespace

bool
canBeDegrees(const PointTable& table)
{
  const Box box(table);
  return box.width() >= 0.0 && box.width() <= widest_scan;
}

bool
looksLikeDegrees(const PointTable& table)
{
  constexpr double least_height = 1000.0, least_distance = 100.0; // of the width
  const Box box(table);
  const double width = box.width(), distance = box.low.head<2>().cwiseAbs().maxCoeff();
  return width > 0.0 && width < 1.0 && distance >= 1.0 && distance >= least_distance * width &&
         box.high.z() - box.low.z() >= least_height * width;
}

std::string
degreesRemedy(const std::string& file, const PointTable& table, bool named)
{
  const std::string remedy = "are degrees, longitude and latitude, but a tool needs lengths: reproject them to metres";
  if (lowerExtension(file) != ".las")
    return remedy;
  const Box box(table);
  const Eigen::Vector3d centre = 0.5 * (box.low + box.high);
  const std::filesystem::path path(file);
  const std::string converted = (path.parent_path() / (path.stem().string() + "_metres.las")).string();
  const std::string option(2, '-'), filter = option + "filters.reprojection."; // options of PDAL
  // A transverse Mercator of scale 1 at the scan keeps lengths: UTM shortens them by up to 0.4 mm per metre. The writer of PDAL rounds
  // to 0.01 m without a scale.
  std::string command = "pdal translate " + shellFile(file) + " " + shellFile(converted) + " reprojection " + filter +
                        formatted("out_srs='+proj=tmerc +lat_0=%.6f +lon_0=%.6f +k=1 +datum=WGS84 +units=m'", centre.y(), centre.x());
  if (!named)
    command += " " + filter + "in_srs=EPSG:4326";
  for (const char* const axis : {"x", "y", "z"})
    command += " " + option + "writers.las.scale_" + axis + "=0.00001";
  return remedy + ", with PDAL (pdal.io): " + command;
}

} // namespace pcl_spiral
