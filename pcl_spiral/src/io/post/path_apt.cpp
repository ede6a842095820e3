// SPDX-License-Identifier: BSD-3-Clause
#include "post_text.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int millimetres = 6; ///< decimals

void
writeWord(PostText& out, std::string_view word, const std::vector<double>& values, int decimals)
{
  out.text(word);
  for (std::size_t i = 0; i < values.size(); ++i) {
    out.text(i == 0 ? "/" : ",");
    out.number(values[i], decimals);
  }
}

void
writeGoto(PostText& out, const Eigen::Vector3d& tip, const Eigen::Vector3d& axis)
{
  writeWord(out, "GOTO", {tip.x(), tip.y(), tip.z()}, millimetres);
  for (int i = 0; i < 3; ++i) {
    out.text(",");
    out.number(axis[i], 9);
  }
  out.endLine();
}

/** Speed of the tip from \p a to \p b for which the contact moves at \p feed. */
double
tipFeed(const ToolPose& a, const ToolPose& b, double feed)
{
  const double contact = (b.contact - a.contact).norm(), tip = (b.tip - a.tip).norm();
  return contact > 0.0 && tip > 0.0 ? feed * tip / contact : feed;
}

} // namespace

AptCutter
ballCutter(double radius)
{
  return {2.0 * radius, radius, 0.0, radius, 0.0, 0.0, 4.0 * radius};
}

AptCutter
aptCutter(const CutterProfile& cutter)
{
  const double widening = std::tan(cutter.flankAngle());
  return {2.0 * (cutter.flankRadius() - cutter.cornerHeight() * widening),
          cutter.cornerRadius(),
          cutter.flatRadius(),
          cutter.cornerRadius(),
          0.0,
          cutter.shape().flank_angle,
          std::max(cutter.topHeight(), 2.0 * cutter.radius())};
}

void
writeAPT(const std::string& file, const ToolPoses& poses, const AptHeader& header)
{
  if (poses.empty())
    throw FileError(file, "not written: the path has no points");
  PostText out(file, millimetres);
  out.text("PARTNO " + commentText(header.title) + "\nUNITS/MM\nMULTAX/ON\n");
  const AptCutter& c = header.cutter;
  writeWord(out, "CUTTER", {c.diameter, c.corner_radius, c.corner_distance, c.corner_height, c.tip_angle, c.flank_angle, c.height},
            millimetres);
  out.endLine();
  if (header.spindle_speed > 0.0) {
    writeWord(out, "SPINDL", {header.spindle_speed}, 1);
    out.endLine(",RPM,CLW\n");
  }
  double last = -1.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const double feed = i == 0 ? header.feed : tipFeed(poses[i - 1], poses[i], header.feed);
    if (feed > 0.0 && std::abs(feed - last) > 0.01 * last) {
      writeWord(out, "FEDRAT", {feed}, 3);
      out.endLine(",MMPM\n");
      last = feed;
    }
    writeGoto(out, poses[i].tip, poses[i].axis);
  }
  out.text(header.spindle_speed > 0.0 ? "SPINDL/OFF\nFINI\n" : "FINI\n");
  out.close();
}

} // namespace pcl_spiral
