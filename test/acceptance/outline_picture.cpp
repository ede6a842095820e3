// SPDX-License-Identifier: BSD-3-Clause
#include "outline_picture.h"

#include <pcl/io/png_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>

namespace pcl_spiral::acceptance {

namespace {

using Colour = std::array<unsigned char, 3>;

constexpr Colour grey{150, 150, 150}, red{255, 0, 0}, dark_red{120, 0, 0}, magenta{255, 0, 255}, blue{60, 90, 220}, green{0, 170, 0},
    black{0, 0, 0};

/** A white sheet over a box of the plane, y upwards. */
class Sheet {
public:
  Sheet(const Eigen::Vector2d& lower, const Eigen::Vector2d& upper, int longest)
  : lower_(lower), scale_(longest / (upper - lower).maxCoeff())
  {
    const Eigen::Vector2d size = scale_ * (upper - lower);
    width_ = std::max(1, static_cast<int>(size.x()));
    height_ = std::max(1, static_cast<int>(size.y()));
    pixels_.assign(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 255);
  }

  /** A round dot, or a ring where \p hole is above 0; radii in pixels. */
  void dot(const Eigen::Vector3d& x, const Colour& colour, double radius, double hole = 0.0)
  {
    const Eigen::Vector2d at = scale_ * (x.head<2>() - lower_);
    const int reach = static_cast<int>(std::ceil(radius));
    for (int i = -reach; i <= reach; ++i)
      for (int j = -reach; j <= reach; ++j)
        if (std::hypot(i, j) <= radius && std::hypot(i, j) >= hole)
          set(static_cast<int>(at.x()) + i, static_cast<int>(at.y()) + j, colour);
  }
  void line(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Colour& colour)
  {
    const int steps = 1 + static_cast<int>(2.0 * scale_ * (b - a).norm());
    for (int k = 0; k <= steps; ++k)
      dot(a + (b - a) * (static_cast<double>(k) / steps), colour, 0.0);
  }
  void write(const std::string& file) const { pcl::io::saveRgbPNGFile(file, pixels_.data(), width_, height_); }

private:
  void set(int i, int j, const Colour& colour)
  {
    if (i < 0 || j < 0 || i >= width_ || j >= height_)
      return;
    const auto row = static_cast<std::size_t>(height_ - 1 - j), column = static_cast<std::size_t>(i);
    std::copy(colour.begin(), colour.end(),
              pixels_.begin() + static_cast<std::ptrdiff_t>(3 * (row * static_cast<std::size_t>(width_) + column)));
  }

  Eigen::Vector2d lower_;
  double scale_;
  int width_ = 0, height_ = 0;
  std::vector<unsigned char> pixels_;
};

} // namespace

bool
writePath(const std::string& file, const test::CheckedPath& path)
{
  std::ofstream out(file);
  out << "x,y,z,nx,ny,nz\n";
  char line[160];
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Vector3d &x = path.contacts[i], &n = path.normals[i];
    std::snprintf(line, sizeof line, "%.6f,%.6f,%.6f,%.7f,%.7f,%.7f\n", x.x(), x.y(), x.z(), n.x(), n.y(), n.z());
    out << line;
  }
  return static_cast<bool>(out.flush());
}

bool
writePicture(const std::string& file, const test::AnalyticSurface& part, const test::CheckedPath& path, const test::JudgedReport& figures,
             double h, int longest)
{
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(figures.pitch);
  Sheet sheet(part.region().lower() - margin, part.region().upper() + margin, longest);
  for (const Polyline& rim : part.outlines())
    for (std::size_t i = 0; i < rim.size(); ++i)
      sheet.line(rim[i], rim[(i + 1) % rim.size()], blue);
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    sheet.line(path.contacts[i], path.contacts[i + 1], grey);
  for (const test::StockSample& s : figures.samples)
    if (s.stock > 1.05 * h)
      sheet.dot(s.x, s.met ? red : dark_red, 1.5);
  for (const std::vector<test::Place>* places : {&figures.crossings, &figures.jumps})
    for (const test::Place& place : *places)
      sheet.dot(place.at, magenta, 9.0, 7.0);
  sheet.dot(path.contacts.front(), green, 5.0);
  sheet.dot(path.contacts.back(), black, 5.0);
  sheet.write(file);
  return std::ifstream(file).good();
}

} // namespace pcl_spiral::acceptance
