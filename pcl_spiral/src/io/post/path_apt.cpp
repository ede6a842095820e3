// SPDX-License-Identifier: BSD-3-Clause
#include "exchange_check.h"
#include "post_text.h"

#include "io/link_marks.h"

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

/** The calls of tool, spindle and coolant that \p header asks for. */
void
writeStart(PostText& out, const AptHeader& header)
{
  if (header.tool > 0)
    out.line("LOADTL/" + std::to_string(header.tool));
  if (header.spindle_speed > 0.0) {
    writeWord(out, "SPINDL", {header.spindle_speed}, 1);
    out.endLine(header.spindle_direction == SpindleDirection::Clockwise ? ",RPM,CLW\n" : ",RPM,CCLW\n");
  }
  if (header.coolant != Coolant::None)
    out.line(header.coolant == Coolant::Mist ? "COOLNT/MIST" : header.coolant == Coolant::Flood ? "COOLNT/FLOOD" : "COOLNT/THRU");
}

/** Writes moves, and what changes between them. */
class MoveText {
public:
  explicit MoveText(PostText& out) : out_(out) {}

  void add(const ToolMove& move)
  {
    const bool link = move.section == BlockSection::Link;
    if (link != in_link_)
      out_.line("$$ " + std::string(link ? link_begin : link_end));
    in_link_ = link;
    if (move.rapid)
      out_.line("RAPID");
    else if (moved_)
      writeFeed((move.pose.tip - before_).norm(), move.minutes);
    writeGoto(out_, move.pose.tip, move.pose.axis);
    before_ = move.pose.tip;
    moved_ = true;
  }

private:
  /** The speed of the tip; where it stays and the axis turns, the speed before. */
  void writeFeed(double way, double minutes)
  {
    if (!(way > 0.0 && minutes > 0.0) || std::abs(way / minutes - last_) <= 0.01 * last_)
      return;
    last_ = way / minutes;
    writeWord(out_, "FEDRAT", {last_}, 3);
    out_.endLine(",MMPM\n");
  }

  PostText& out_;
  Eigen::Vector3d before_ = Eigen::Vector3d::Zero();
  double last_ = 0.0;
  bool moved_ = false, in_link_ = false;
};

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
writeAPT(const std::string& file, const std::vector<ToolMoves>& passes, const AptHeader& header)
{
  requireMoves(file, passes);
  PostText out(file, millimetres);
  out.text("PARTNO " + commentText(header.title) + "\nUNITS/MM\nMULTAX/ON\n");
  const AptCutter& c = header.cutter;
  writeWord(out, "CUTTER", {c.diameter, c.corner_radius, c.corner_distance, c.corner_height, c.tip_angle, c.flank_angle, c.height},
            millimetres);
  out.endLine();
  writeStart(out, header);
  MoveText text(out);
  for (const ToolMoves& moves : passes)
    for (const ToolMove& move : moves)
      text.add(move);
  if (header.coolant != Coolant::None)
    out.line("COOLNT/OFF");
  if (header.spindle_speed > 0.0)
    out.line("SPINDL/OFF");
  out.line("FINI");
  out.close();
}

} // namespace pcl_spiral
