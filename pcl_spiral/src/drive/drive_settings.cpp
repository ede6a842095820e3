// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/drive/drive_settings.h>

#include "choice_words.h"
#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/drive/impl/drive_cylinder.h>

#include <Eigen/Geometry>

#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double shortest = 1e-9;      // length of a direction
constexpr double most_parallel = 1e-4; // sine of the angle between axis and passes

Status
bad(Diagnostic message)
{
  return {StatusCode::InvalidArgument, std::move(message)};
}

bool
isPositive(double value)
{
  return value > 0.0 && std::isfinite(value);
}

Status
checkDirections(const DriveSettings& s)
{
  if (!s.axis.allFinite() || !(s.axis.norm() > shortest))
    return bad(
        Diagnostic("the tool axis is ", Direction(s.axis), ", which has no direction; set it from the tip to the shank ({setAxis})"));
  if (s.kind != DriveKind::Planes)
    return Status::success();
  if (!s.plane_direction.allFinite())
    return bad("the direction of the section planes is not finite; set an angle in {degrees}, or a vector ({setPlaneDirection})");
  if (!s.plane_direction.isZero(0.0) && !(s.axis.normalized().cross(s.plane_direction.normalized()).norm() > most_parallel))
    return bad(Diagnostic("the direction of the passes ", Direction(s.plane_direction), " is parallel to the tool axis ", Direction(s.axis),
                          ": they define no plane; set a direction across the axis ({setPlaneDirection})"));
  return Status::success();
}

Status
checkCurve(const DriveSettings& s)
{
  for (std::size_t i = 0; i < s.curve.size(); ++i)
    if (!s.curve[i].allFinite())
      return bad(Diagnostic("point ", i, " of the curve is not finite; remove it"));
  if (s.curve.size() < 2 || !(length(s.curve, s.curve_closed) > 0.0))
    return bad(Diagnostic("the curve has ", s.curve.size(), " points and a length of ", length(s.curve, s.curve_closed),
                          " {mm}; call {setCurve} with at least two different points"));
  return Status::success();
}

/** Whether the settings use the step-over. */
bool
needsStep(const DriveSettings& s)
{
  return s.kind != DriveKind::Curve && s.rows == DriveRows::Even;
}

Status
checkRows(const DriveSettings& s)
{
  if (s.link_rows && s.kind != DriveKind::Planes)
    return bad("only rows of section planes can be linked; choose planes ({setKind}), or leave links out ({setLinkRows})");
  if (s.link_rows && !s.zigzag)
    return bad("one-way rows begin far from the end of the row before and cannot be linked; run them back and forth "
               "({setZigzag}), or leave links out ({setLinkRows})");
  if (s.rows == DriveRows::Even)
    return Status::success();
  if (s.kind != DriveKind::Planes)
    return bad("only section planes can keep rows to a scallop height; choose planes ({setKind}), or even rows "
               "({setRows})");
  if (s.axisMode() == DriveAxisMode::Cylinder)
    return bad("rows kept to a scallop height need axes that are fixed or normal to the surface, not to a cylinder; "
               "choose another axis mode ({setAxisMode}), or even rows ({setRows})");
  const double radius = s.cutter ? s.cutter->radius : 0.0;
  if (!isPositive(radius) || !(s.scallop_height > 0.0 && s.scallop_height < radius))
    return bad(Diagnostic("for rows kept to a scallop height the cutter's radius is ", radius, " {mm} and the scallop height ",
                          s.scallop_height,
                          " {mm}; set the radius above 0 ({setCutter}), and the height above 0 and below the radius ({setScallopHeight})"));
  return Status::success();
}

} // namespace

std::vector<Setting>
settingTable(DriveSettings& s)
{
  return {
      Setting("drive", "setKind", "kind of drive path", "kind of drive path", "helix", s.kind),
      Setting("step_over", "setStepOver", "step-over", "largest distance between neighbouring passes", "1", s.step_over)
          .in("mm", NumberRange::from(0.0))
          .writtenBy("step-over"),
      Setting("scallop", "setScallopHeight", "scallop height",
              "largest height of the ridge left between passes, on slopes too; refused, with the height that is reached, where the passes "
              "leave more",
              "0.02", s.scallop_height)
          .in("mm", NumberRange::from(0.0))
          .writtenBy("scallop"),
      Setting("point_spacing", "setPointSpacing", "spacing of drive points", "largest distance between drive points of a pass", "0.5",
              s.point_spacing)
          .in("mm", NumberRange::above(0.0))
          .writtenBy("point-spacing"),
      Setting("chord_error", "setChordError", "chord error", "largest distance of straight moves from the curved surface of a mesh",
              "0.002", s.chord_error)
          .in("mm", NumberRange::above(0.0))
          .onlyInCode(),
      Setting("overrun", "setOverrun", "overrun", "helix and rings go this far beyond the ends of the column, for walls that lean", "1.5",
              s.overrun)
          .in("mm", NumberRange::from(0.0)),
      Setting("direction", "setPlaneDirection", "direction of the passes", "planes: direction of passes about the tool axis, from X", "45",
              s.plane_angle)
          .in("degrees", NumberRange()),
      Setting("rows", "setRows", "rows", "planes: at even steps, or everywhere as close as the scallop height needs", "kept", s.rows)
          .writtenBy("rows"),
      Setting("link", "setLinkRows", "linked rows", "planes: join rows on the surface where the next begins within two step-overs", "",
              s.link_rows),
      Setting("zigzag", "setZigzag", "zigzag", "every second pass runs backwards", "", s.zigzag).writtenBy("one-way"),
      Setting("axis", "setAxis", "tool axis", "tool axis, from tip to shank, for fixed axes and for planes", "0,1,1", s.axis),
      Setting("axis_mode", "setAxisMode", "source of tool axes",
              "source of tool axes; cylinder for helix and rings, else fixed, if it is "
              "not given",
              "surface", s.axis_mode),
  };
}

Status
checkSettings(const DriveSettings& s)
{
  if (const Status status = checkRows(s); !status.ok())
    return status;
  if (const Diagnostic fault = s.cutter ? faultOf(*s.cutter) : Diagnostic(); !fault.empty())
    return bad(Diagnostic(fault, " ({setCutter})"));
  if (needsStep(s) && !isPositive(s.step_over))
    return bad(Diagnostic("the step-over is ", s.step_over, " {mm}: set it above 0 ({setStepOver})"));
  if (const Diagnostic fault = rangeFault(s); !fault.empty())
    return bad(fault);
  if (s.cylinder)
    if (const Status status = checkCylinder(*s.cylinder); !status.ok())
      return status;
  if (const Status status = checkDirections(s); !status.ok())
    return status;
  return s.kind == DriveKind::Curve ? checkCurve(s) : Status::success();
}

} // namespace pcl_spiral
