// SPDX-License-Identifier: BSD-3-Clause
#include "idle_settings.h"

#include "drive/choice_words.h"
#include "pass_defaults.h"

namespace pcl_spiral {
namespace {

constexpr const char* of_scan = " belongs to scans, and {setInputMesh} uses the faces of a mesh: leave one of the two out";
constexpr const char* of_mesh = ": belongs to meshes; add {setInputMesh} to use the faces of the file, or leave it out";

void
requireHolder(const AskedJob& job, IdleRules& rules)
{
  rules.require(job.has_holder, {"holder_clearance"}, ": no {setHolder} is given; give one, or leave it out");
}

/** What belongs to one kind of drive path. */
void
requireKind(const DriveSettings& drive, IdleRules& rules)
{
  const DriveKind kind = drive.kind;
  const Diagnostic is(": {setKind} ", choiceName(kind), " does not use it; leave it out");
  const bool is_planes = kind == DriveKind::Planes, is_curve = kind == DriveKind::Curve;
  rules.require(drive.goesRound(), {"overrun"}, is);
  rules.require(drive.goesRound() || drive.axisMode() == DriveAxisMode::Cylinder, {"column_axis"},
                Diagnostic(is, " (or give {setAxisMode} cylinder)"));
  rules.require(rules.isAsked("column_axis"), {"column_centre"}, ": no {DriveCylinder::axis} is given; give the direction too");
  rules.require(is_planes, {"direction", "rows", "link"}, is);
  rules.require(is_planes || kind == DriveKind::Rings, {"zigzag"}, is);
  rules.require(!is_curve, {"step_over", "scallop"}, is);
  rules.require(is_curve, {"curve", "curve_closed"},
                Diagnostic(": {setKind} is ", choiceName(kind), "; use {setKind} curve, or leave it out"));
}

} // namespace

void
IdleRules::forbid(std::initializer_list<const char*> names, const Diagnostic& remedy)
{
  for (const char* name : names)
    if (!found_ && isAsked(name))
      found_ = IdleSetting{name, remedy};
}

std::optional<IdleSetting>
idleSetting(const AskedNames& asked, const SpiralSettings& settings, const AskedJob& job)
{
  IdleRules rules(asked);
  rules.require(!settings.fixed_axis && !job.keeps_axis, {"tilt", "lead", "axis_smoothing", "axis_deviation", "max_axis_rate"},
                Diagnostic(" changes the tool axis along the path, and ", settings.fixed_axis ? "{setFixedAxis}" : "{setBallClosing}",
                           " keeps it; leave one of the two out"));
  rules.require(!job.on_mesh, {"view_point"},
                " belongs to scans, and {setInputMesh} is given: the faces define the side ({setFlipNormals} turns them); leave one of the "
                "two out");
  rules.require(!job.on_mesh,
                {"columns", "skip_lines", "raw_scan", "ball_closing", "thin", "outlier_neighbours", "crop", "regions", "keep_outs"},
                of_scan);
  rules.require(!job.keeps_axis, {"verify", "stock", "max_gouge", "max_scallop", "max_deviation", "max_uncut", "raw_scan", "reach"},
                ": with {setBallClosing} the path runs over a closed {scan}, and is checked against every point of the {scan}; leave this "
                "out");
  rules.require(job.on_mesh, {"sample_spacing"},
                ": a scan has its own points; add {setInputMesh} to use the faces of the file, or leave it out");
  rules.require(job.has_holder, {"flank_length"}, ": no {setHolder} is given, and only the holder begins there; give one, or leave it out");
  requireHolder(job, rules);
  return rules.found();
}

std::optional<IdleSetting>
idleSetting(const AskedNames& asked, const DriveSettings& drive, const PassSettings& tool, const AskedJob& job)
{
  IdleRules rules(asked);
  rules.require(!job.on_mesh,
                {"columns", "skip_lines", "raw_scan", "leave_out_strays", "largest", "thin", "view_point", "part_at", "regions", "crop",
                 "keep_outs", "clusters"},
                of_scan);
  rules.require(job.on_mesh, {"crease_angle", "gouge_check"}, of_mesh);
  rules.require(job.checks_gouges, {"max_retilt", "ceiling"},
                ": belongs to the check of gouges, which is left out ({setGougeCheck}); leave one of the two out");
  requireKind(drive, rules);
  rules.require(tool.max_retilt > 0.0, {"retilt_step"}, ": no {PassSettings::max_retilt} is given; give one, or leave it out");
  requireHolder(job, rules);
  return rules.found();
}

std::optional<IdleSetting>
idleSetting(const AskedNames& asked, const PassSettings& tool, const AskedJob& job)
{
  IdleRules rules(asked);
  rules.require(tool.cutter.radius > 0.0,
                {"corner_radius", "flank_length", "flank_angle", "holder", "holder_clearance", "ceiling", "max_retilt", "retilt_step",
                 "accept_collisions", "scallop", "pole_cone", "stay_down"},
                ": belongs to a cutter, and no {PassSettings::cutter} is given; give it for a cutter, or leave this out for a beam");
  rules.require(tool.max_retilt > 0.0, {"retilt_step"}, ": no {PassSettings::max_retilt} is given; give one, or leave it out");
  requireHolder(job, rules);
  return rules.found();
}

std::optional<IdleSetting>
idleOfJudging(const AskedNames& asked, const AskedJob& job)
{
  IdleRules rules(asked);
  rules.require(job.on_mesh, {"crease_angle", "sample_spacing"}, " belongs to meshes; add {setInputMesh}, or leave it out");
  rules.require(!job.on_mesh, {"columns", "skip_lines", "view_point", "part_at", "regions", "crop", "keep_outs", "clusters"},
                " belongs to scans; the faces of a mesh define its side: leave it out, or turn the mesh over ({MeshSettings::flip})");
  return rules.found();
}

} // namespace pcl_spiral
