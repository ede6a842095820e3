// SPDX-License-Identifier: BSD-3-Clause
// Simulates a line-laser scan of a tank dome: scan lines, noise, a few outliers, a shadow; of a column on a
// turntable; or of the ridge of a press die with its two measured lines. The same seed gives the same file.
#include "simulate_scan/ridge_scan.h"
#include "terminal/file_names.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/output_files.h>

#include <pcl/io/pcd_io.h>
#include <pcl/io/ply_io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>
#include <boost/program_options.hpp>

#include <cmath>
#include <filesystem>
#include <iostream>
#include <optional>
#include <random>
#include <vector>

namespace po = boost::program_options;

using pcl_spiral::pi;

namespace {

/** The part and the scanner; lengths in mm. */
struct Scan {
  std::string part = "dome";
  double radius = 300;      ///< of the tank: horizontal semi-axis of the dome, a spheroid
  double height = 156;      ///< of the dome: its vertical semi-axis
  double rim = 270;         ///< radius at which the part ends
  double line_spacing = 2;  ///< of the scan lines, along x
  double point_spacing = 1; ///< of the points on a line, near the top
  double noise = 0.02;      ///< standard deviation along the beam
  double outliers = 0.0005; ///< share of outliers
  double shadow = 12;       ///< diameter of an object between scanner and dome; 0: none
  double standoff = 1500;   ///< of the scanner above the top of the dome
  double baseline = 600;    ///< between laser and camera, along x
  unsigned seed = 1;
};

/** Distance along the beam to the dome, if the beam meets the dome inside the rim. */
std::optional<double>
range(const Scan& scan, const Eigen::Vector3d& laser, const Eigen::Vector3d& beam)
{
  const Eigen::Array3d axes(scan.radius, scan.radius, scan.height);
  const Eigen::Vector3d o = laser.array() / axes, d = beam.array() / axes;
  const double b = o.dot(d), root = b * b - d.squaredNorm() * (o.squaredNorm() - 1);
  if (root < 0)
    return std::nullopt;
  const double t = (-b - std::sqrt(root)) / d.squaredNorm();
  const Eigen::Vector3d p = laser + t * beam;
  if (p.z() < 0 || p.head<2>().norm() > scan.rim)
    return std::nullopt;
  return t;
}

/** True if the object is between the point and the eye (the laser, or the camera). */
bool
hidden(const Eigen::Vector3d& point, const Eigen::Vector3d& eye, const Eigen::Vector3d& object, double radius)
{
  return Eigen::ParametrizedLine<double, 3>::Through(point, eye).distance(object) < radius;
}

/** The points in the order in which the scanner sees them, a line at a time. */
pcl::PointCloud<pcl::PointXYZ>
simulate(const Scan& scan)
{
  std::mt19937_64 random(scan.seed);
  std::normal_distribution<double> noise(0, 1);
  std::uniform_real_distribution<double> uniform(0, 1);
  const double top = scan.height + scan.standoff;
  const double x = 0.4 * scan.rim, y = 0.3 * scan.rim;
  const double z = scan.height * std::sqrt(1 - (x * x + y * y) / (scan.radius * scan.radius));
  const Eigen::Vector3d object(x, y, z + 2 * scan.shadow);

  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.sensor_origin_ = Eigen::Vector4f(0, 0, static_cast<float>(top), 1);
  const double angle_step = scan.point_spacing / scan.standoff, widest = std::atan(scan.rim / scan.standoff);
  const int lines = static_cast<int>(scan.rim / scan.line_spacing), beams = static_cast<int>(widest / angle_step);
  for (int line = -lines; line <= lines; ++line) {
    const double phase = uniform(random); // sensor and gantry have separate clocks
    const Eigen::Vector3d laser(line * scan.line_spacing, 0, top), camera = laser - scan.baseline * Eigen::Vector3d::UnitX();
    for (int i = -beams - 1; i <= beams; ++i) {
      const double angle = (i + phase) * angle_step;
      const Eigen::Vector3d beam(0, std::sin(angle), -std::cos(angle));
      const auto t = range(scan, laser, beam);
      const double error = uniform(random) < scan.outliers ? outlierDistance(uniform(random)) : scan.noise * noise(random);
      if (!t)
        continue;
      const Eigen::Vector3d p = laser + *t * beam;
      if (hidden(p, laser, object, scan.shadow / 2) || hidden(p, camera, object, scan.shadow / 2))
        continue;
      const Eigen::Vector3f seen = (p + error * beam).cast<float>();
      cloud.emplace_back(seen.x(), seen.y(), seen.z());
    }
  }
  return cloud;
}

/** Radius of a column with five twisted lobes and a waist: from every side, one part of it hides another. */
double
columnRadius(const Scan& scan, double angle, double z)
{
  return scan.radius * (1 + 0.05 * std::sin(5 * angle + 2 * pi * z / (2.5 * scan.radius)) + 0.1 * std::sin(2 * pi * z / (2 * scan.radius)));
}

/** The column turns in front of an upright line of light; one line at a time. */
pcl::PointCloud<pcl::PointXYZ>
simulateColumn(const Scan& scan)
{
  std::mt19937_64 random(scan.seed);
  std::normal_distribution<double> noise(0, 1);
  std::uniform_real_distribution<double> uniform(0, 1);
  pcl::PointCloud<pcl::PointXYZ> cloud;
  const int lines = static_cast<int>(std::ceil(2 * pi * scan.radius / scan.line_spacing));
  const int points = static_cast<int>(scan.height / scan.point_spacing);
  for (int line = 0; line < lines; ++line) {
    const double angle = 2 * pi * line / lines, phase = uniform(random);
    for (int i = 0; i < points; ++i) {
      const double z = (i + phase) * scan.point_spacing;
      const double error = uniform(random) < scan.outliers ? outlierDistance(uniform(random)) : scan.noise * noise(random);
      const double r = columnRadius(scan, angle, z) + error;
      cloud.emplace_back(static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)), static_cast<float>(z));
    }
  }
  return cloud;
}

/** The fault of the options; empty if there is none. */
std::string
complaint(const Scan& s)
{
  if (s.part != "dome" && s.part != "column" && s.part != "ridge")
    return "--part " + s.part + " is not known; use dome, column or ridge";
  if (!(s.radius > 0 && s.height > 0 && s.line_spacing > 0 && s.point_spacing > 0 && s.standoff > 0))
    return "radius, height, spacings and standoff must be above 0 mm";
  if (s.part == "dome" && !(s.rim > 0 && s.rim <= s.radius))
    return "--rim must be above 0 and no larger than --radius";
  if (!(s.noise >= 0 && s.shadow >= 0 && s.outliers >= 0 && s.outliers < 1))
    return "--noise and --shadow must not be negative, --outliers must be a share from 0 to 1";
  constexpr double ridge_length = 640, ridge_width = 28;
  const bool dome = s.part == "dome", ridge = s.part == "ridge";
  const double across = dome ? s.rim : ridge ? 0.5 * ridge_length : 2 * s.radius;
  const double along = dome ? s.rim : ridge ? 0.5 * ridge_width : s.height;
  if (across / s.line_spacing * along / s.point_spacing > 1e8)
    return "that is more than 400 million points: increase --line-spacing or --point-spacing";
  return "";
}

/** The fault of the options for a ridge; empty if there is none. */
std::string
foreignToRidge(const po::variables_map& given)
{
  for (const char* option : {"radius", "height", "rim", "shadow", "standoff"})
    if (!given[option].defaulted())
      return std::string("--") + option + " does not apply to --part ridge, its shape is fixed: leave it out";
  return "";
}

void
write(const std::string& file, const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  int failed = 0;
  try {
    failed = extensionOf(file) == ".ply" ? pcl::PLYWriter().write(file, cloud, true, false) : pcl::io::savePCDFileBinary(file, cloud);
  }
  catch (const pcl::PCLException&) {
    failed = 1;
  }
  if (failed != 0)
    throw pcl_spiral::FileError(file, "cannot be written; is the disk full?");
}

/** Writes all files or none. */
void
writeAll(const std::vector<std::string>& files, const std::vector<pcl::PointCloud<pcl::PointXYZ>>& clouds)
{
  pcl_spiral::OutputFiles output(files);
  for (std::size_t i = 0; i < files.size(); ++i)
    try {
      write(output.temporary(i), clouds[i]);
    }
    catch (const pcl_spiral::FileError& error) {
      throw pcl_spiral::FileError(output.asGiven(error.diagnostic()));
    }
  output.commit();
  for (std::size_t i = 0; i < files.size(); ++i)
    std::cout << files[i] << ": " << clouds[i].size() << " points\n";
}

po::options_description
optionsOf(Scan& s, std::string& file)
{
  po::options_description options(
      "Simulates a line-laser scan of a tank dome, of a column, or of the ridge of a press die.\n\n"
      "  pcl_spiral_simulate_scan -o OUT [options]\n\n"
      "  pcl_spiral_simulate_scan -o dome.pcd --noise 0.05\n"
      "  pcl_spiral_simulate_scan --part ridge -o ridge.pcd\n\n"
      "The ridge is 600 long and 24 wide. With ridge.pcd it also writes ridge_rail.pcd and ridge_generator.pcd, the\n"
      "300 and 60 measured points of its two lines. Lengths are in millimetres. Exit code: 0 on success, 1 if the scan\n"
      "has no points or a file fails, 2 if the command line is wrong.\n\nOptions");
  auto add = options.add_options();
  add("help,h", "print this text");
  add("output,o", po::value(&file)->required(), "file to write, .pcd or .ply");
  add("part", po::value(&s.part)->default_value(s.part), "dome; column: about z, with lobes, a waist and undercuts; or ridge");
  add("radius", po::value(&s.radius)->default_value(s.radius), "radius of the tank; mean radius of the column");
  add("height", po::value(&s.height)->default_value(s.height), "height of the whole dome; of the column");
  add("rim", po::value(&s.rim)->default_value(s.rim), "radius at which the part ends");
  add("line-spacing", po::value(&s.line_spacing)->default_value(s.line_spacing),
      "distance between scan lines; for the ridge, which they cross, default 0.5");
  add("point-spacing", po::value(&s.point_spacing)->default_value(s.point_spacing),
      "distance between points of a line; for the ridge default 0.5");
  add("noise", po::value(&s.noise)->default_value(s.noise, "0.02"), "standard deviation along the beam; for the ridge, of each coordinate");
  add("outliers", po::value(&s.outliers)->default_value(s.outliers, "0.0005"), "share of outliers, 5 to 20 mm off the surface");
  add("shadow", po::value(&s.shadow)->default_value(s.shadow), "diameter of an object between scanner and dome; 0: none");
  add("standoff", po::value(&s.standoff)->default_value(s.standoff), "height of the scanner above the dome");
  add("seed", po::value(&s.seed)->default_value(s.seed), "seed of the random numbers");
  return options;
}

/** Reads the options; the ridge has its own default spacings. */
std::string
readOptions(const po::variables_map& given, const std::string& file, Scan& s)
{
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension != ".pcd" && extension != ".ply")
    return "'" + file + "': give a .pcd or .ply file";
  if (s.part == "ridge") {
    if (given["line-spacing"].defaulted())
      s.line_spacing = RidgeScanSettings().line_spacing;
    if (given["point-spacing"].defaulted())
      s.point_spacing = RidgeScanSettings().point_spacing;
    if (const std::string foreign = foreignToRidge(given); !foreign.empty())
      return foreign;
  }
  return complaint(s);
}

} // namespace

int
main(int argc, char** argv)
try {
  Scan s;
  std::string file;
  const po::options_description options = optionsOf(s, file);
  po::variables_map given;
  po::store(po::parse_command_line(argc, argv, options), given);
  if (given.count("help")) {
    std::cout << options;
    return 0;
  }
  po::notify(given);
  if (const std::string wrong = readOptions(given, file, s); !wrong.empty())
    throw po::error(wrong);
  if (s.part == "ridge") {
    const RidgeScan ridge = simulateRidge({s.line_spacing, s.point_spacing, s.noise, s.outliers, s.seed});
    writeAll({file, besideName(file, "_rail"), besideName(file, "_generator")}, {ridge.scan, ridge.rail, ridge.generator});
    return 0;
  }
  const auto cloud = s.part == "dome" ? simulate(s) : simulateColumn(s);
  if (cloud.empty()) {
    std::cerr << "the scan has no points: use smaller spacings\n";
    return 1;
  }
  writeAll({file}, {cloud});
  return 0;
}
catch (const po::error& error) {
  std::cerr << "pcl_spiral_simulate_scan: " << error.what() << "; --help lists the options\n";
  return 2;
}
catch (const std::exception& error) {
  std::cerr << "pcl_spiral_simulate_scan: " << error.what() << '\n';
  return 1;
}
