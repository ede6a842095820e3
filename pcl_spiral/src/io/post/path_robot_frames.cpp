// SPDX-License-Identifier: BSD-3-Clause
#include "exchange_check.h"
#include "post_text.h"

#include <pcl_spiral/core/impl/frame.h>
#include <pcl_spiral/io/path_exchange.h>

#include <Eigen/Geometry>

#include <algorithm>

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

/** The moves that are on the path: from the one whose end is its first pose to the last cut. */
std::pair<std::size_t, std::size_t>
pathOf(const ToolMoves& moves)
{
  const auto cuts = [](const ToolMove& move) { return move.section == BlockSection::Cut; };
  const auto comes = [](const ToolMove& move) { return move.section == BlockSection::LeadIn; };
  const auto first = std::find_if(moves.begin(), moves.end(), cuts);
  if (first == moves.end()) { // a path of one pose
    const auto last = std::find_if(moves.rbegin(), moves.rend(), comes);
    const std::size_t at = last == moves.rend() ? 0 : static_cast<std::size_t>(moves.rend() - last) - 1;
    return {at, at};
  }
  const auto last = std::find_if(moves.rbegin(), moves.rend(), cuts);
  const auto begin = static_cast<std::size_t>(first - moves.begin());
  return {begin == 0 ? 0 : begin - 1, static_cast<std::size_t>(moves.rend() - last) - 1};
}

/** Direction in which the contact travels at move \p i of the path \p first to \p last: to the next contact at another place, at the end
 *  from the one before. Zero if there is none. */
Eigen::Vector3d
travelAt(const ToolMoves& moves, std::size_t first, std::size_t last, std::size_t i)
{
  const auto place = [&moves](std::size_t k) -> const Eigen::Vector3d& { return moves[k].pose.contact; };
  for (std::size_t k = i + 1; k <= last; ++k)
    if (place(k) != place(i))
      return place(k) - place(i);
  for (std::size_t k = i; k-- > first;)
    if (place(k) != place(i))
      return place(i) - place(k);
  return Eigen::Vector3d::Zero();
}

/** Frame with \p z and x along \p travel, square to it. */
Eigen::Quaterniond
frameOf(const Eigen::Vector3d& z, const Eigen::Vector3d& travel)
{
  Eigen::Vector3d x = travel - travel.dot(z) * z, y;
  if (x.norm() > 1e-9 * travel.norm())
    x.normalize();
  else
    tangentFrame(z, x, y);
  Eigen::Matrix3d frame;
  frame << x, z.cross(x), z;
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
    const auto [first, last] = pathOf(moves);
    double speed = 0.0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      const ToolPose& pose = moves[i].pose;
      const std::size_t on_path = std::clamp(i, first, last);
      const Eigen::Vector3d z = (z_ == RobotZ::Axis ? pose.axis : pose.normal).normalized();
      const double way = i > 0 ? (placeOf(pose, z_) - placeOf(moves[i - 1].pose, z_)).norm() : 0.0;
      if (way > 0.0 && moves[i].minutes > 0.0) // where the place stays and the frame turns, the speed does
        speed = way / moves[i].minutes;
      begin(i == 0);
      number("{x: ", placeOf(pose, z_).x() / metre);
      number(", y: ", placeOf(pose, z_).y() / metre);
      number(", z: ", placeOf(pose, z_).z() / metre);
      const Eigen::Quaterniond q = frameOf(z, travelAt(moves, first, last, on_path));
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
  out.text("x: along the travel; metres; speed: of the place, m/s\n");
  FrameText frames(out, z);
  for (const ToolMoves& moves : passes)
    frames.add(moves);
  out.close();
}

} // namespace pcl_spiral
