// SPDX-License-Identifier: BSD-3-Clause
#include "tool_body.h"

#include <pcl_spiral/core/impl/angles.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int arcs = 32;              // of a corner
constexpr double pointed = 1e-6;      // mm: radius of the point of a ball
constexpr double least_length = 1e-9; // mm

} // namespace

std::vector<ToolSegment>
cutterCones(const CutterProfile& cutter)
{
  std::vector<ToolSegment> cones;
  double radius = std::max(cutter.flatRadius(), pointed), height = 0.0;
  const auto add = [&](double upper_radius, double upper_height) {
    const double upper = std::max(upper_radius, pointed);
    if (upper_height - height > least_length) {
      cones.push_back({radius, upper, upper_height - height, "cutter"});
      height = upper_height;
    }
    radius = upper;
  };
  const double r = cutter.cornerRadius(), end = 0.5 * pi - cutter.flankAngle();
  for (int k = 1; k <= arcs; ++k)
    add(cutter.flatRadius() + r * std::sin(end * k / arcs), r - r * std::cos(end * k / arcs));
  add(cutter.radius(), cutter.topHeight());
  return cones;
}

double
toolLength(const CutterProfile& cutter, const std::vector<ToolSegment>& holder)
{
  double length = cutter.topHeight();
  for (const ToolSegment& segment : holder)
    length += segment.length;
  return holder.empty() ? std::max(length, cutter.cornerRadius() + shank_radii * cutter.radius()) : length;
}

HolderProfile
cutterAndShank(const CutterProfile& cutter, const std::vector<ToolSegment>& holder, double length)
{
  std::vector<ToolSegment> segments = cutterCones(cutter);
  if (holder.empty() && length > cutter.topHeight() + least_length)
    segments.push_back(ToolSegment::cylinder(cutter.radius(), length - cutter.topHeight(), "shank"));
  return HolderProfile(segments, 0.0, 0.0, 0.0);
}

} // namespace pcl_spiral
