// SPDX-License-Identifier: BSD-3-Clause
// spiral(), drive() and ridge(): keywords, planner, path.
#include "path.h"
#include "stages.h"

#include "planning/input_tables.h"
#include "planning/pass_defaults.h"
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/io/pass_report_writer.h>
#include <pcl_spiral/planning/drive_planner.h>
#include <pcl_spiral/planning/ridge_planner.h>
#include <pcl_spiral/planning/spiral_planner.h>

#include <pybind11/stl.h>

#include <array>
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
  Keywords keywords{"spiral", settingTable(settings) + settingTable(input) + units.table(),
                    partInputs() + holder_input + own_stage_inputs + progress_input};
};

void
setSpiral(const SpiralCall& call, const Run& run, SpiralPlanner<pcl::PointXYZ>& planner)
{
  AskedJob job = call.asked(call.keywords);
  job.keeps_axis = call.input.ball_closing;
  requireUsed(idleSetting(call.keywords.asked(), call.settings, job), call.words);
  planner.setSettings(call.settings);
  setPart(call, call.keywords, planner);
  planner.setHolder(holderOf(call.keywords.list("holder")));
  planner.setFlankLength(call.input.flank_length);
  planner.setHolderClearance(call.input.holder_clearance);
  planner.setAcceptCollisions(call.input.accept_collisions);
  planner.setBallClosing(call.input.ball_closing);
  planner.setRemedyTries(call.input.remedy_tries);
  planner.setSampleSpacing(call.input.sample_spacing);
  setOwnStages(call.keywords, run, call.scan.shift, planner);
}

Path
spiral(const py::object& points, const py::dict& given)
{
  SpiralCall call;
  call.begin(call.keywords, given, points, call.settings);
  const Run run(call.keywords["progress"]);
  const auto planner = std::make_shared<SpiralPlanner<pcl::PointXYZ>>();
  setSpiral(call, run, *planner);
  compute(planner, run, call.words);
  const auto plan = planOf<SpiralPlan>(planner);
  const Diagnostics reading = joined(call.scan.warnings, plan->part.warnings);
  Path path;
  path.points = plan->path;
  path.motion = {call.settings.tool_radius, call.settings.feed, {}, plan->report.pass_begins, call.scan.shift};
  path.report = reportJSON(call.files(reading), reportOf(*plan));
  path.warnings = call.texts(joined(reading, plan->report.warnings));
  path.source = std::make_shared<PathSource>(PathSource{plan, nullptr, {}, titleOf(call.scan), call.words.read});
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
           only(settingTable(surface), {"neighbours", "alpha"}, false) + units.table(); // those that planners of passes heed
  }

  AskedSettings completed(const Keywords& keywords) const
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
            std::make_shared<PathSource>(PathSource{nullptr, plan, tool, titleOf(scan), words.read})};
  }
};

/** drive(), or with passes of the user's own cutter_locations(), or sections(). */
struct DriveCall : PassCall {
  DrivePlanInput input;
  MeshSettings mesh;
  std::optional<Eigen::Vector3d> column_axis, column_centre;
  Keywords keywords;

  explicit DriveCall(const std::string& name)
  : keywords(name,
             name == "cutter_locations"
                 ? passTable(input.tool) + settingTable(mesh) + only(settingTable(input), {"curve_closed", "gouge_check"}, false)
             : name == "sections" ? path() + cutterTable(input.tool.cutter, NumberRange::from(0.0)) + settingTable(surface) + units.table()
                                  : path() + passTable(input.tool) + settingTable(input),
             name == "sections" ? scanInputs() + curve_input + progress_input
                                : partInputs() + holder_input + (name == "drive" ? curve_input : std::vector<Input>()) + progress_input)
  {}

  void begin(const py::dict& given, const py::object& points)
  {
    Call::begin(keywords, given, points, surface);
    AskedJob job = asked(keywords);
    job.checks_gouges = input.check_gouges;
    requireUsed(idleSetting(keywords.asked(), input.drive, input.tool, job), words);
    if (column_axis)
      input.drive.cylinder = DriveCylinder{column_centre.value_or(Eigen::Vector3d::Zero()), *column_axis};
    input.drive.curve = lineOf(keywords["curve"], words);
    surface.flip_normals = surface.flip_normals && !job.on_mesh; // the mesh is turned
  }

private:
  /** Those of the drive path. */
  std::vector<Setting> path()
  {
    return settingTable(input.drive) + settingTable(mesh) +
           std::vector<Setting>{
               Setting("column_axis", "setCylinder", "axis of the column", "direction that helix and rings go round", "0,0,1", column_axis)
                   .zeroFor("found from the scan"),
               Setting("column_centre", "DriveCylinder::origin", "centre of the column", "a place on that axis", "20,5,0", column_centre)
                   .zeroFor("0,0,0")};
  }
  static inline const std::vector<Input> curve_input{
      {"curve", "ArrayLike | File | None", "points in order, (N, 3) or a file, for drive='curve'", {}}};
};

using OpenDrivePlanner = OpenPlanner<DrivePlanner<pcl::PointXYZ>>;

void
setDrive(DriveCall& call, OpenDrivePlanner& planner)
{
  completeCutter(call.keywords, call.words, call.input.tool.cutter);
  completeDrive(call.completed(call.keywords), call.input.tool, call.scan.mesh != nullptr, call.input.drive);
  planner.setSurface(call.surface);
  setPart(call, call.keywords, planner);
  planner.setHolder(holderOf(call.keywords.list("holder")));
  planner.setSettings(call.input.drive);
  planner.setPassSettings(call.input.tool);
  planner.setMeshSettings(call.mesh);
  planner.setHolderClearance(call.input.tool.holder_clearance);
  planner.setAcceptCollisions(call.input.tool.accept_collisions);
  planner.setLeaveOutStrays(call.input.leave_out_strays);
  planner.setGougeCheck(call.input.check_gouges);
}

Path
planDrive(DriveCall& call, const DrivePasses& passes)
{
  const auto planner = std::make_shared<OpenDrivePlanner>();
  setDrive(call, *planner);
  planner->setDrivePasses(passes);
  compute(planner, Run(call.keywords["progress"]), call.words);
  const auto plan = planOf<PassPlan>(planner);
  const DriveRun run{{call.input.tool, call.feed, std::nullopt, std::nullopt},
                     call.input.drive,
                     call.input.check_gouges,
                     call.surface.largest_part,
                     call.surface.thinning};
  const Diagnostics reading = joined(call.scan.warnings, plan->chosen.warnings);
  return call.pathOf(plan, call.input.tool, joined(reading, plan->warnings), driveReportJSON(call.files(reading), run, *plan));
}

Path
drive(const py::object& points, const py::dict& given)
{
  DriveCall call("drive");
  call.begin(given, points);
  return planDrive(call, {});
}

/** Passes as rows of positions, axes and normals, mm. A closed one ends where it begins. */
py::list
sections(const py::object& points, const py::dict& given)
{
  DriveCall call("sections");
  call.begin(given, points);
  if (call.keywords.isGiven("tool_radius")) {
    completeCutter(call.keywords, call.words, call.input.tool.cutter);
    completeDrive(call.completed(call.keywords), call.input.tool, call.scan.mesh != nullptr, call.input.drive);
  }
  const auto path = std::make_shared<OpenPlanner<DrivePath<pcl::PointXYZ>>>();
  path->setSurface(call.surface);
  setScan(call.scan, *path);
  if (SurfaceMesh::ConstPtr mesh; call.scan.mesh) {
    require(SurfaceMesh::make(*call.scan.mesh, call.mesh, mesh), call.words);
    path->setInputMesh(mesh);
  }
  path->setSettings(call.input.drive);
  const auto passes = std::make_shared<DrivePasses>();
  compute(path, Run(call.keywords["progress"]), call.words, passes);
  py::list all;
  for (DrivePass& pass : *passes) {
    if (pass.closed)
      pass.points.push_back(pass.points.front());
    Polyline columns[3];
    for (const DrivePoint& p : pass.points) {
      columns[0].push_back(p.position);
      columns[1].push_back(p.axis);
      columns[2].push_back(p.normal);
    }
    all.append(py::make_tuple(rowsOf(columns[0], call.scan.shift), rowsOf(columns[1]), rowsOf(columns[2])));
  }
  return all;
}

Path
cutterLocations(const py::object& points, const py::list& given_passes, const py::dict& given)
{
  DriveCall call("cutter_locations");
  call.begin(given, points);
  DrivePasses passes;
  for (const py::handle pass : given_passes) {
    const auto columns = pass.cast<std::array<py::array_t<double>, 3>>();
    const auto positions = vectorsOf<Eigen::Vector3d>(columns[0]), axes = vectorsOf<Eigen::Vector3d>(columns[1]),
               normals = vectorsOf<Eigen::Vector3d>(columns[2]);
    passes.emplace_back();
    for (std::size_t i = 0; i < positions.size(); ++i)
      passes.back().points.push_back({positions[i] - call.scan.shift, axes[i], normals[i]});
  }
  return planDrive(call, passes);
}

struct RidgeCall : PassCall {
  RidgePlanInput input;
  Keywords keywords{
      "ridge",
      settingTable(input.rows) + settingTable(input.ridge) + only(passTable(input.tool), {"flip_normals", "part_at", "clusters"}, false) +
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
  requireUsed(idleSetting(call.keywords.asked(), input.tool, call.asked(call.keywords)), call.words);
  completeCutter(call.keywords, call.words, input.tool.cutter);
  completeRidge(call.completed(call.keywords), input.tool, input.rows);
  input.tool.holder = holderOf(call.keywords.list("holder"));
  if (!call.scan.cloud->empty())
    planner.setInputCloud(call.scan.cloud);
  planner.setSurface(call.surface);
  call.scan.setSide(planner);
  const auto line = [&call](const char* name) { return lineOf(call.keywords[name], call.words); };
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
  call.begin(call.keywords, given, points, call.surface, "scan_normals");
  const auto planner = std::make_shared<OpenRidgePlanner>();
  setRidge(call, *planner);
  compute(planner, Run(call.keywords["progress"]), call.words);
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
  module.def("sections", &sections);
  module.def("cutter_locations", &cutterLocations);
  module.def("ridge", &ridge);
  SpiralCall().keywords.addTo(tables);
  for (const char* name : {"drive", "sections", "cutter_locations"})
    DriveCall(name).keywords.addTo(tables);
  RidgeCall().keywords.addTo(tables);
}

} // namespace pcl_spiral::python
