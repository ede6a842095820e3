// SPDX-License-Identifier: BSD-3-Clause
#include "post_text.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/machine/impl/kinematics.h>

#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int pose_decimals = 6; // of mm and degrees

void
requireRows(const std::string& file, const std::vector<ToolPoses>& passes)
{
  if (passes.empty())
    throw FileError(file, "not written: there are no poses; give at least one row");
  for (std::size_t row = 0; row < passes.size(); ++row) {
    const auto require = [&](bool holds, const Diagnostic& fault) {
      if (!holds)
        throw FileError(file, Diagnostic("not written: row ", row + 1, fault));
    };
    require(passes[row].size() >= 2, Diagnostic(" has ", passes[row].size(), " poses; give it two or more, or leave it out"));
    for (const ToolPose& pose : passes[row])
      require(pose.tip.allFinite() && pose.contact.allFinite() && std::abs(pose.axis.norm() - 1.0) < 1e-6,
              Diagnostic(" has a pose at ", Place(pose.tip), " that is not finite, or its axis ", Direction(pose.axis),
                         " is not a unit vector; leave it out"));
  }
}

/** The same angles, the first changed by whole turns to be nearest to \p before. */
RotaryAngles
turnedTo(const RotaryAngles& before, RotaryAngles angles)
{
  const double turn = 2.0 * pi;
  angles.first = std::isnan(angles.first) ? before.first // along the first axis every angle is right
                                          : angles.first + turn * std::round((before.first - angles.first) / turn);
  return angles;
}

double
wayBetween(const RotaryAngles& a, const RotaryAngles& b)
{
  return std::abs(a.first - b.first) + std::abs(a.second - b.second);
}

/** Angles of all poses. Two pairs reach an axis, (A, C) and (-A, C + 180); the pair nearer to the pose before is used. So
 *  C makes no half turn where the axis passes the upright direction. */
std::vector<std::vector<RotaryAngles>>
anglesOf(const std::string& file, const std::vector<ToolPoses>& passes)
{
  const Kinematics kinematics(xyzacTrunnion());
  std::vector<std::vector<RotaryAngles>> rows;
  RotaryAngles before;
  bool begun = false;
  for (const ToolPoses& poses : passes) {
    rows.emplace_back();
    for (const ToolPose& pose : poses) {
      const auto larger = kinematics.anglesOf(pose.axis.normalized(), Branch::Larger),
                 smaller = kinematics.anglesOf(pose.axis.normalized(), Branch::Smaller);
      if (!larger || !smaller)
        throw FileError(file, Diagnostic("not written: row ", rows.size(), ": no rotary angles reach the tool axis at ", Place(pose.tip)));
      const RotaryAngles a = turnedTo(before, *larger), b = turnedTo(before, *smaller);
      before = !begun || wayBetween(a, before) <= wayBetween(b, before) ? a : b;
      begun = true;
      rows.back().push_back(before);
    }
  }
  return rows;
}

void
writeTip(PostText& out, const ToolPose& pose)
{
  for (const double coordinate : pose.tip)
    out.word("", coordinate);
}

} // namespace

void
writePoseVectors(const std::string& file, const std::vector<ToolPoses>& passes)
{
  requireRows(file, passes);
  PostText out(file, pose_decimals);
  for (const ToolPoses& row : passes) {
    if (&row != &passes.front())
      out.endLine();
    for (const ToolPose& pose : row) {
      writeTip(out, pose);
      writeVector(out, {"", "", ""}, pose.axis);
      out.endLine();
    }
  }
  out.close();
}

void
writePoseAngles(const std::string& file, const std::vector<ToolPoses>& passes)
{
  requireRows(file, passes);
  const std::vector<std::vector<RotaryAngles>> angles = anglesOf(file, passes);
  PostText out(file, pose_decimals);
  for (std::size_t row = 0; row < passes.size(); ++row) {
    if (row > 0)
      out.endLine();
    for (std::size_t i = 0; i < passes[row].size(); ++i) {
      writeTip(out, passes[row][i]);
      out.word("", angles[row][i].second * in_degrees);
      out.word("", angles[row][i].first * in_degrees);
      out.endLine();
    }
  }
  out.close();
}

} // namespace pcl_spiral
