// SPDX-License-Identifier: BSD-3-Clause
#include "input_tables.h"

namespace pcl_spiral {
namespace {

Setting
acceptedCollisions(bool& accepted)
{
  return Setting("accept_collisions", "setAcceptCollisions", "accepted collisions", "collisions of shank and holder are only warnings", "",
                 accepted);
}

Setting
leftOutOutliers(bool& left_out)
{
  return Setting("leave_out_strays", "setLeaveOutStrays", "left out outliers", "leave out points off the scanned surface", "", left_out);
}

} // namespace

std::vector<Setting>
cutterTable(CutterShape& cutter, const NumberRange& radius)
{
  const NumberRange length = NumberRange::from(0.0);
  return {Setting("tool_radius", "setCutter", "tool radius", "radius of the cutter at the upper end of its flank", "6", cutter.radius)
              .in("mm", radius),
          Setting("corner_radius", "CutterShape::corner_radius", "corner radius", "of the end of the cutter; a ball if it is not given",
                  "1", cutter.corner_radius)
              .in("mm", length),
          Setting("flank_length", "setFlankLength", "flank length", "of the cutting flank along its slant, above the corner", "20",
                  cutter.flank_length)
              .in("mm", length),
          Setting("flank_angle", "CutterShape::flank_angle", "flank angle", "between flank and axis", "5", cutter.flank_angle)
              .in("degrees", length.below(90.0))};
}

Setting
remedyTries(int& tries)
{
  return Setting("remedy_tries", "setRemedyTries", "search for a remedy",
                 "how many paths a search for a single change may cost that gives a path where there is none; 0: no search", "0", tries)
      .in("paths", NumberRange::from(0.0).upTo(most_remedy_tries));
}

std::vector<Setting>
settingTable(PlanInput& input)
{
  const NumberRange length = NumberRange::from(0.0);
  return {Setting("flank_length", "setFlankLength", "flank length", "length of the shank from the centre of the ball up to the holder",
                  "20", input.flank_length)
              .in("mm", length)
              .zeroFor("none"),
          Setting("holder_clearance", "setHolderClearance", "clearance of the holder", "least distance between holder and scan", "1",
                  input.holder_clearance)
              .in("mm", length),
          acceptedCollisions(input.accept_collisions),
          Setting("ball_closing", "setBallClosing", "closing by the ball",
                  "for a scan from one side with steps, folds and overhangs: plan over what the ball can touch", "", input.ball_closing),
          remedyTries(input.remedy_tries),
          Setting("sample_spacing", "setSampleSpacing", "sample spacing", "spacing of the samples of a mesh", "0.5", input.sample_spacing)
              .in("mm", length)
              .zeroFor("the spacing found from curvature and step-over")};
}

std::vector<Setting>
settingTable(DrivePlanInput& input)
{
  return {leftOutOutliers(input.leave_out_strays), acceptedCollisions(input.tool.accept_collisions),
          Setting("gouge_check", "setGougeCheck", "check of gouges",
                  "on a mesh; without it the cutter stands at the contacts of the sections", "", input.check_gouges),
          Setting("curve_closed", "setCurve", "closed curve", "the last point of the curve joins the first", "", input.drive.curve_closed)};
}

std::vector<Setting>
settingTable(RidgePlanInput& input)
{
  return {
      leftOutOutliers(input.leave_out_strays), acceptedCollisions(input.tool.accept_collisions),
      Setting("half_width", "setHalfWidth", "half width", "of the ridge in the scan, from its crest to each side", "12", input.half_width)
          .in("mm", NumberRange::from(0.0)),
      Setting("closed", "setClosed", "closed ridge", "the ridge in the scan is a ring", "", input.closed)};
}

} // namespace pcl_spiral
