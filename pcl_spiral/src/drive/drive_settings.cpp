// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/drive/drive_settings.h>

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
    return bad(Diagnostic("the tool axis is ", Direction(s.axis), ", which has no direction; set it from the tip to the shank"));
  if (s.kind != DriveKind::Planes)
    return Status::success();
  if (!std::isfinite(s.plane_angle) || !s.plane_direction.allFinite())
    return bad("the direction of the section planes is not finite; set an angle in {degrees}, or a vector");
  if (!s.plane_direction.isZero(0.0) && !(s.axis.normalized().cross(s.plane_direction.normalized()).norm() > most_parallel))
    return bad(Diagnostic("the direction of the passes ", Direction(s.plane_direction), " is parallel to the tool axis ", Direction(s.axis),
                          ": they define no plane; set a direction across the axis"));
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
                          s.scallop_height, " {mm}; set both above 0, and the height below the radius ({setScallop})"));
  return Status::success();
}

} // namespace

Status
checkSettings(const DriveSettings& s)
{
  if (const Status status = checkRows(s); !status.ok())
    return status;
  if (const Diagnostic fault = s.cutter ? faultOf(*s.cutter) : Diagnostic(); !fault.empty())
    return bad(Diagnostic(fault, " ({setCutter})"));
  if (needsStep(s) && !isPositive(s.step_over))
    return bad(Diagnostic("the step-over is ", s.step_over, " {mm}; set it above 0"));
  if (!(s.overrun >= 0.0) || !std::isfinite(s.overrun))
    return bad(Diagnostic("the overrun is ", s.overrun, " {mm}; set it to 0 or more"));
  if (!isPositive(s.point_spacing))
    return bad(Diagnostic("the spacing of drive points is ", s.point_spacing, " {mm}; set it above 0"));
  if (!isPositive(s.chord_error))
    return bad(Diagnostic("the chord error is ", s.chord_error, " {mm}; set it above 0 ({setChordError})"));
  if (s.cylinder)
    if (const Status status = checkCylinder(*s.cylinder); !status.ok())
      return status;
  if (const Status status = checkDirections(s); !status.ok())
    return status;
  return s.kind == DriveKind::Curve ? checkCurve(s) : Status::success();
}

} // namespace pcl_spiral
