// SPDX-License-Identifier: BSD-3-Clause
#include "section_rows.h"

#include <algorithm>
#include <limits>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

/** Where the tool leaves a pass. */
const Vector3d&
endOf(const DrivePass& pass)
{
  return (pass.closed ? pass.points.front() : pass.points.back()).position;
}

std::size_t
nearestOf(const DrivePass& pass, const Vector3d& place)
{
  const auto nearest = std::min_element(pass.points.begin(), pass.points.end(), [&](const DrivePoint& a, const DrivePoint& b) {
    return (a.position - place).squaredNorm() < (b.position - place).squaredNorm();
  });
  return static_cast<std::size_t>(nearest - pass.points.begin());
}

/** The line whose start is nearest to \p place; for a closed line, the nearest point. */
std::size_t
nextLine(const DrivePasses& lines, const Vector3d& place)
{
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t begin = lines[i].closed ? nearestOf(lines[i], place) : 0;
    const double distance = (lines[i].points[begin].position - place).squaredNorm();
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return best;
}

} // namespace

void
addRow(DrivePasses lines, const Vector3d& along, bool back, DrivePasses& passes)
{
  const Vector3d forward = back ? Vector3d(-along) : along;
  for (DrivePass& line : lines)
    if (line.closed ? back : forward.dot(line.points.back().position - line.points.front().position) < 0.0)
      std::reverse(line.points.begin(), line.points.end());
  // The first row has no end before it: it begins where it is farthest back.
  const auto farthestBack = [&]() {
    Vector3d place = lines.front().points.front().position;
    for (const DrivePass& line : lines)
      for (const DrivePoint& p : line.points)
        if (forward.dot(p.position - place) < 0.0)
          place = p.position;
    return place;
  };
  while (!lines.empty()) {
    const Vector3d place = passes.empty() ? farthestBack() : endOf(passes.back());
    const std::size_t next = nextLine(lines, place);
    DrivePass& line = lines[next];
    if (line.closed)
      std::rotate(line.points.begin(), line.points.begin() + static_cast<std::ptrdiff_t>(nearestOf(line, place)), line.points.end());
    passes.push_back(std::move(line));
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(next));
  }
}

DrivePasses
facingParts(const DrivePasses& lines, const Vector3d& axis, std::size_t& left_out)
{
  constexpr double away = -1e-6; // cosine: upright walls still face the axis
  const auto faces = [&](const DrivePoint& p) { return p.normal.dot(axis) >= away; };
  DrivePasses parts;
  for (const DrivePass& line : lines) {
    const auto turned =
        static_cast<std::size_t>(std::count_if(line.points.begin(), line.points.end(), [&](const DrivePoint& p) { return !faces(p); }));
    left_out += turned;
    if (turned == 0) {
      parts.push_back(line);
      continue;
    }
    DrivePoints points = line.points;
    if (line.closed) // from the first that faces away
      std::rotate(points.begin(), std::find_if_not(points.begin(), points.end(), faces), points.end());
    DrivePass part;
    for (std::size_t i = 0; i <= points.size(); ++i) {
      if (i < points.size() && faces(points[i])) {
        part.points.push_back(points[i]);
        continue;
      }
      if (part.points.size() > 1)
        parts.push_back(std::move(part));
      part = DrivePass();
    }
  }
  return parts;
}

} // namespace pcl_spiral
