// SPDX-License-Identifier: BSD-3-Clause
#include "exchange_check.h"
#include "post_text.h"

#include <pcl_spiral/io/path_exchange.h>

#include <Eigen/Geometry>

namespace pcl_spiral {
namespace {

constexpr int decimals = 9;                // a nanometre
constexpr double metre = 1e3;              // mm
constexpr double metre_a_second = 6e4;     // mm/min
constexpr std::size_t line_of_pass = 4;    // columns before the dash of a segment
constexpr std::size_t line_of_place = 6;   // columns before the dash of a waypoint
constexpr const char* first_dash = "- - "; // of a fragment and of its path

Eigen::Vector3d
placeOf(const ToolPose& pose, RobotZ z)
{
  return z == RobotZ::Axis ? pose.tip : pose.contact;
}

Eigen::Quaterniond
quaternionOf(const Eigen::Matrix3d& frame)
{
  Eigen::Quaterniond q(frame);
  if (q.w() < 0.0)
    q.coeffs() *= -1.0;
  return q.normalized();
}

const char*
wordOf(const ToolMove& move)
{
  return move.rapid ? "rapid" : move.section == BlockSection::Cut ? "cut" : "lead";
}

class FrameText {
public:
  FrameText(PostText& out, RobotZ z) : out_(out), z_(z) {}

  void add(const ToolMoves& moves)
  {
    const std::vector<Eigen::Matrix3d> turned = toolFrames(moves, z_);
    double speed = 0.0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const ToolPose& pose = moves[i].pose;
      const double way = i > 0 ? (placeOf(pose, z_) - placeOf(moves[i - 1].pose, z_)).norm() : 0.0;
      if (way > 0.0 && moves[i].minutes > 0.0) // where the place stays and the frame turns, the speed does
        speed = way / moves[i].minutes;
      begin(i == 0);
      number("{x: ", placeOf(pose, z_).x() / metre);
      number(", y: ", placeOf(pose, z_).y() / metre);
      number(", z: ", placeOf(pose, z_).z() / metre);
      const Eigen::Quaterniond q = quaternionOf(turned[i]);
      number(", qw: ", q.w());
      number(", qx: ", q.x());
      number(", qy: ", q.y());
      number(", qz: ", q.z());
      if (!moves[i].rapid && speed > 0.0)
        number(", speed: ", speed / metre_a_second);
      out_.text(", move: ");
      out_.text(wordOf(moves[i]));
      out_.endLine("}\n");
    }
  }

private:
  /** The dashes of a waypoint. */
  void begin(bool first_of_segment)
  {
    if (!first_of_segment)
      return out_.text(std::string(line_of_place, ' ') + "- ");
    out_.text(any_ ? std::string(line_of_pass, ' ') : first_dash);
    out_.text("- - ");
    any_ = true;
  }

  void number(const char* name, double value)
  {
    out_.text(name);
    out_.number(value, decimals);
  }

  PostText& out_;
  RobotZ z_;
  bool any_ = false;
};

} // namespace

void
writeRobotFrames(const std::string& file, const std::vector<ToolMoves>& passes, RobotZ z)
{
  requireMoves(file, passes);
  PostText out(file, decimals);
  out.text(z == RobotZ::Axis ? "# place: tip of the tool; z: tool axis, from the tip to the shank; "
                             : "# place: contact; z: normal of the surface, out of the material; ");
  out.text("x: along the travel of the tip; metres; speed: of the place, m/s\n");
  FrameText frames(out, z);
  for (const ToolMoves& moves : passes)
    frames.add(moves);
  out.close();
}

} // namespace pcl_spiral
