// SPDX-License-Identifier: BSD-3-Clause
// spiral(), drive() and ridge(): keywords, planner, path.
#include "parts.h"
#include "path.h"

#include "planning/input_tables.h"
#include "planning/pass_defaults.h"
#include <pcl_spiral/io/pass_report_writer.h>
#include <pcl_spiral/planning/drive_planner.h>
#include <pcl_spiral/planning/ridge_planner.h>
#include <pcl_spiral/planning/spiral_planner.h>

#include <filesystem>

namespace pcl_spiral::python {
namespace {

/** The last plan of \p planner, which lives as long. */
template <typename Plan, typename Planner>
std::shared_ptr<const Plan>
planOf(const std::shared_ptr<Planner>& planner)
{
  return {planner, &planner->getPlan()};
}

Diagnostics
joined(Diagnostics first, const Diagnostics& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/** For comments in programs. */
std::string
titleOf(const GivenScan& scan)
{
  return scan.name.empty() ? "points" : std::filesystem::path(scan.name).filename().string();
}

struct SpiralCall : Call {
  SpiralSettings settings;
  PlanInput input; ///< beside the settings
  Keywords keywords{"spiral", settingTable(settings) + settingTable(input) + units.table(), partInputs() + holder_input + progress_input};
};

void
setSpiral(SpiralCall& call, SpiralPlanner<pcl::PointXYZ>& planner)
{
  intoCloud(call.settings.centre, call.scan.shift);
  intoCloud(call.settings.start_point, call.scan.shift);
  planner.setSettings(call.settings);
  setPart(call, call.keywords, planner);
  planner.setHolder(holderOf(call.keywords.list("holder")));
  planner.setFlankLength(call.input.flank_length);
  planner.setHolderClearance(call.input.holder_clearance);
  planner.setAcceptCollisions(call.input.accept_collisions);
  planner.setBallClosing(call.input.ball_closing);
  planner.setSampleSpacing(call.input.sample_spacing);
}

Path
spiral(const py::object& points, const py::dict& given)
{
  SpiralCall call;
  call.keywords.take(given);
  call.read(points, call.keywords, call.settings);
  const auto planner = std::make_shared<SpiralPlanner<pcl::PointXYZ>>();
  setSpiral(call, *planner);
  compute(planner, call.keywords, call.words);
  const auto plan = planOf<SpiralPlan>(planner);
  const Diagnostics reading = joined(call.scan.warnings, plan->part.warnings);
  Path path;
  path.points = plan->path;
  path.motion = {call.settings.tool_radius, call.settings.feed, {}, plan->report.pass_begins, call.scan.shift};
  path.report = reportJSON(call.files(reading), reportOf(*plan));
  path.warnings = call.texts(joined(reading, plan->report.warnings));
  path.source = std::make_shared<PathSource>(PathSource{plan, nullptr, {}, titleOf(call.scan)});
  return path;
}

/** What drive() and ridge() share. Without a radius of the cutter the tool is a beam. */
struct PassCall : Call {
  SurfaceSettings surface;
  double feed = 1000.0;

  std::vector<Setting> passTable(PassSettings& tool)
  {
    return cutterTable(tool.cutter, NumberRange::from(0.0)) + settingTable(tool) +
           std::vector<Setting>{
               Setting("feed", "setFeed", "feed", "feed at the contact", "2500", feed).in("mm/min", NumberRange::above(0.0))} +
           without(settingTable(surface), {"neighbours", "alpha"}) + units.table(); // those that planners of passes heed
  }

  AskedSettings asked(const Keywords& keywords) const
  {
    return {keywords.isGiven("rows"), keywords.isGiven("point_spacing"), keywords.isGiven("tolerance"), keywords.isGiven("chord_error")};
  }

  Path pathOf(const std::shared_ptr<const PassPlan>& plan, const PassSettings& tool, const Diagnostics& warnings,
              const std::string& report) const
  {
    PassPath all = joinedPasses(plan->passes);
    ToolPoses poses;
    for (const ToolPoses& pass : plan->passes)
      poses.insert(poses.end(), pass.begin(), pass.end());
    for (ToolPose& pose : poses) {
      pose.contact += scan.shift;
      pose.tip += scan.shift;
    }
    return {pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(std::move(all.path)),
            {tool.cutter.radius, feed, std::move(all.tips), std::move(all.begins), scan.shift},
            std::make_shared<const ToolPoses>(std::move(poses)),
            report,
            texts(warnings),
            std::make_shared<PathSource>(PathSource{nullptr, plan, tool, titleOf(scan)})};
  }
};

struct DriveCall : PassCall {
  DrivePlanInput input;
  MeshSettings mesh;
  std::optional<Eigen::Vector3d> column_axis, column_centre;
  Keywords keywords{
      "drive",
      passTable(input.tool) + settingTable(input.drive) + settingTable(input) + settingTable(mesh) +
          std::vector<Setting>{
              Setting("column_axis", "setCylinder", "axis of the column", "direction that helix and rings go round", "0,0,1", column_axis)
                  .zeroFor("found from the scan"),
              Setting("column_centre", "DriveCylinder::origin", "centre of the column", "a place on that axis", "20,5,0", column_centre)
                  .zeroFor("0,0,0")},
      partInputs() + holder_input +
          std::vector<Input>{{"curve", "ArrayLike | File | None", "points in order, (N, 3) or a file, for drive='curve'", {}}} +
          progress_input};
};

using OpenDrivePlanner = OpenPlanner<DrivePlanner<pcl::PointXYZ>>;

void
setDrive(DriveCall& call, OpenDrivePlanner& planner)
{
  DriveSettings& drive = call.input.drive;
  const bool on_mesh = call.scan.mesh != nullptr;
  completeCutter(call.keywords, call.words, call.input.tool.cutter);
  completeDrive(call.asked(call.keywords), call.input.tool, on_mesh, drive);
  if (call.column_axis)
    drive.cylinder = DriveCylinder{call.column_centre.value_or(Eigen::Vector3d::Zero()) - call.scan.shift, *call.column_axis};
  drive.curve = lineOf(call.keywords["curve"], call.beside(), call.words);
  call.surface.flip_normals = call.surface.flip_normals && !on_mesh; // the mesh is turned
  planner.setSurface(call.surface);
  setPart(call, call.keywords, planner);
  planner.setHolder(holderOf(call.keywords.list("holder")));
  planner.setSettings(drive);
  planner.setPassSettings(call.input.tool);
  planner.setMeshSettings(call.mesh);
  planner.setHolderClearance(call.input.tool.holder_clearance);
  planner.setAcceptCollisions(call.input.tool.accept_collisions);
  planner.setLeaveOutStrays(call.input.leave_out_strays);
  planner.setGougeCheck(call.input.check_gouges);
}

Path
drive(const py::object& points, const py::dict& given)
{
  DriveCall call;
  call.keywords.take(given);
  call.read(points, call.keywords, call.surface);
  const auto planner = std::make_shared<OpenDrivePlanner>();
  setDrive(call, *planner);
  compute(planner, call.keywords, call.words);
  const auto plan = planOf<PassPlan>(planner);
  const DriveRun run{{call.input.tool, call.feed, std::nullopt},
                     call.input.drive,
                     call.input.check_gouges,
                     call.surface.largest_part,
                     call.surface.thinning};
  const Diagnostics reading = joined(call.scan.warnings, plan->chosen.warnings);
  return call.pathOf(plan, call.input.tool, joined(reading, plan->warnings), driveReportJSON(call.files(reading), run, *plan));
}

struct RidgeCall : PassCall {
  RidgePlanInput input;
  Keywords keywords{
      "ridge",
      settingTable(input.rows) + settingTable(input.ridge) + without(passTable(input.tool), {"flip_normals", "part_at", "clusters"}) +
          settingTable(input),
      std::vector<Input>{{"scan_normals", "ArrayLike | None", "(N, 3), one a point of the scan, out of the material", {"setInputNormals"}},
                         {"rail", "ArrayLike | File | None", "points measured along the ridge, in any order", {"setMeasuredLines"}},
                         {"generator", "ArrayLike | File | None", "points measured once across it", {}},
                         {"through", "ArrayLike | File | None", "rough points on the ridge in the scan, in order", {"setRoughPoints"}}} +
          holder_input + progress_input};
};

using OpenRidgePlanner = OpenPlanner<RidgePlanner<pcl::PointXYZ>>;

void
setRidge(RidgeCall& call, OpenRidgePlanner& planner)
{
  RidgePlanInput& input = call.input;
  completeCutter(call.keywords, call.words, input.tool.cutter);
  completeRidge(call.asked(call.keywords), input.tool, input.rows);
  input.tool.holder = holderOf(call.keywords.list("holder"));
  if (!call.scan.cloud->empty())
    planner.setInputCloud(call.scan.cloud);
  planner.setSurface(call.surface);
  call.scan.setSide(planner);
  const auto line = [&call](const char* name) { return lineOf(call.keywords[name], call.beside(), call.words); };
  planner.setMeasuredLines(line("rail"), line("generator"));
  planner.setRoughPoints(line("through"));
  planner.setClosed(input.closed);
  planner.setHalfWidth(input.half_width);
  planner.setRidgeSettings(input.ridge);
  planner.setRowSettings(input.rows);
  planner.setPassSettings(input.tool);
  planner.setLeaveOutStrays(input.leave_out_strays);
}

Path
ridge(const py::object& points, const py::dict& given)
{
  RidgeCall call;
  call.keywords.take(given);
  call.read(points, call.keywords, call.surface, "scan_normals");
  const auto planner = std::make_shared<OpenRidgePlanner>();
  setRidge(call, *planner);
  compute(planner, call.keywords, call.words);
  const RidgePlanInput& input = call.input;
  const RidgePlan& plan = planner->getPlan();
  const RidgeRun run{
      {input.tool, call.feed, std::nullopt}, "", "", input.ridge, input.rows, planner->getRoughPoints(), input.half_width, input.closed};
  return call.pathOf(planOf<PassPlan>(planner), input.tool, joined(call.scan.warnings, plan.warnings),
                     ridgeReportJSON(call.files(call.scan.warnings), run, plan, plan));
}

} // namespace

void
addPlanning(py::module_& module, py::dict& tables)
{
  module.def("spiral", &spiral);
  module.def("drive", &drive);
  module.def("ridge", &ridge);
  tables["spiral"] = SpiralCall().keywords.table();
  tables["drive"] = DriveCall().keywords.table();
  tables["ridge"] = RidgeCall().keywords.table();
}

} // namespace pcl_spiral::python
