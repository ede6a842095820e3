#include "post_text.h"

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/pose_list.h>

#include <cmath>

namespace pcl_spiral {
namespace {

constexpr int decimals = 6; // of mm and degrees

void
requireRows(const std::string& file, const std::vector<ToolPoses>& passes)
{
  if (passes.empty())
    throw FileError(file, "not written: there are no poses; give at least one row");
  for (std::size_t row = 0; row < passes.size(); ++row) {
    const auto require = [&](bool holds, const std::string& fault) {
      if (!holds)
        throw FileError(file, textOf("not written: row ", row + 1, fault));
    };
    require(passes[row].size() >= 2, textOf(" has ", passes[row].size(), " poses; give it two or more, or leave it out"));
    for (const ToolPose& pose : passes[row])
      require(pose.tip.allFinite() && pose.contact.allFinite() && std::abs(pose.axis.norm() - 1.0) < 1e-6,
              " has a pose at " + placeText(pose.tip) + " that is not finite, or whose axis " + placeText(pose.axis) +
                  " is no unit vector; leave it out");
  }
}

/** Angles of every row on one branch, the first going on from row to row. */
std::vector<RotaryPath>
anglesOf(const std::string& file, const std::vector<ToolPoses>& passes)
{
  Machine machine = xyzacTrunnion();
  RotaryPathSettings settings;
  settings.pole_cone = 0.0; // the poses are kept as they are
  std::vector<RotaryPath> rows;
  for (const ToolPoses& poses : passes) {
    rows.emplace_back();
    if (const Status status = rotaryPath(Kinematics(machine), poses, settings, rows.back()); !status.ok())
      throw FileError(file, textOf("not written: row ", rows.size(), ": ", status.message()));
    machine.rotary[0].home = rows.back().locations.back().angles.first;
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
  PostText out(file, decimals);
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
  const std::vector<RotaryPath> rows = anglesOf(file, passes);
  PostText out(file, decimals);
  for (const RotaryPath& row : rows) {
    if (&row != &rows.front())
      out.endLine();
    for (const MachineLocation& location : row.locations) {
      writeTip(out, location.pose);
      out.word("", location.angles.second * in_degrees);
      out.word("", location.angles.first * in_degrees);
      out.endLine();
    }
  }
  out.close();
}

} // namespace pcl_spiral
