// SPDX-License-Identifier: BSD-3-Clause
// spiral(), drive() and ridge(): keywords, planner, path.
#include "parts.h"
#include "path.h"
#include "running.h"

#include "io/report/moved_places.h"
#include "io/setting_names.h"
#include "planning/pass_defaults.h"
#include <pcl_spiral/io/pass_report_writer.h>
#include <pcl_spiral/io/report_writer.h>
#include <pcl_spiral/planning/drive_planner.h>
#include <pcl_spiral/planning/ridge_planner.h>
#include <pcl_spiral/planning/spiral_planner.h>

#include <algorithm>
#include <filesystem>

namespace pcl_spiral::python {
namespace {

const std::vector<Input> holder_input{
    {"holder",
     "Sequence[Sequence[float]]",
     "shank and holder above the flank, upwards: (radius, length) or (lower radius, upper radius, length)",
     {"setHolder", "PassSettings::holder"}}};

/** A place of the user in the coordinates of the cloud. */
void
intoCloud(std::optional<Eigen::Vector3d>& place, const Eigen::Vector3d& shift)
{
  if (place)
    *place -= shift;
}

/** Settings that all calls share, and the scan. */
struct Call {
  GivenUnits units;
  SurfaceSettings surface; ///< of drive and ridge
  Words words;
  GivenScan scan;

  void read(const py::object& points, const Keywords& keywords, const std::optional<Eigen::Vector3d>& view_point,
            const std::string& normals = "normals")
  {
    words.vocabulary = keywords.vocabulary();
    words.vocabulary.words.insert(
        {{"setInputCloud", "points"}, {"ScannedSurface", "scan"}, {"Scale it to mm", "Give its unit=, or scale it to mm"}});
    if (!points.is_none())
      scan = scanOf(points, keywords, units, words, normals);
    words.shift = scan.shift;
    words.vocabulary = movedBy(scan.shift, words.vocabulary);
    if (scan.mesh)
      words.vocabulary.words.insert({{"scan", "mesh"}, {"cloud", "mesh"}, {"scanned surface", "surface"}, {"on the scan", "on the mesh"}});
    scan.asked_view_point = view_point;
    intoCloud(scan.asked_view_point, scan.shift);
  }

  ReadOptions beside() const { return units.options(scan.shift); }

  std::string title() const { return scan.name.empty() ? "points" : std::filesystem::path(scan.name).filename().string(); }

  RunFiles files() const
  {
    RunFiles files{scan.name, units.unit, units.origin.value_or(Eigen::Vector3d::Zero()), {}, {}};
    files.shift = scan.shift;
    files.words = words.vocabulary;
    files.words.place = nullptr; // the writer moves places
    return files;
  }

  std::vector<std::string> texts(const Diagnostics& warnings) const { return textsOf(warnings, words.vocabulary); }
};

/** The last plan of \p planner, which lives as long. */
template <typename Plan, typename Planner>
std::shared_ptr<const Plan>
planOf(const std::shared_ptr<Planner>& planner)
{
  return {planner, &planner->getPlan()};
}

template <typename Planner>
void
compute(const std::shared_ptr<Planner>& planner, const Keywords& keywords, const Words& words)
{
  const Run run(keywords["progress"]);
  planner->setQuiet(true);
  planner->setProgressCallback(run.progress());
  run([planner] { planner->compute(); });
  planner->setProgressCallback(nullptr);
  require(planner->getStatus(), words);
}

Diagnostics
joined(Diagnostics first, const Diagnostics& second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

struct SpiralCall : Call {
  SpiralSettings settings;
  double flank_length = 0.0, holder_clearance = 0.0, sample_spacing = 0.0;
  bool accept_collisions = false, ball_closing = false;
  Keywords keywords{
      "spiral",
      settingTable(settings) +
          std::vector<Setting>{
              Setting("flank_length", "setFlankLength", "flank length", "length of the shank from the centre of the ball up to the holder",
                      "20", flank_length)
                  .in("mm", NumberRange::from(0.0))
                  .zeroFor("none"),
              Setting("holder_clearance", "setHolderClearance", "clearance of the holder", "least distance between holder and scan", "1",
                      holder_clearance)
                  .in("mm", NumberRange::from(0.0)),
              Setting("accept_collisions", "setAcceptCollisions", "accepted collisions", "collisions of shank and holder are only warnings",
                      "", accept_collisions),
              Setting("ball_closing", "setBallClosing", "closing by the ball",
                      "for a scan from one side with steps, folds and overhangs: plan over what the ball can touch", "", ball_closing),
              Setting("sample_spacing", "setSampleSpacing", "sample spacing", "spacing of the samples of a mesh", "0.5", sample_spacing)
                  .in("mm", NumberRange::from(0.0))
                  .zeroFor("the spacing found from curvature and step-over")} +
          units.table(),
      partInputs() + holder_input + progress_input};
};

Path
spiral(const py::object& points, const py::dict& given)
{
  SpiralCall call;
  call.keywords.take(given);
  call.read(points, call.keywords, call.settings.view_point);
  const auto planner = std::make_shared<SpiralPlanner<pcl::PointXYZ>>();
  SpiralSettings settings = call.settings;
  settings.view_point = std::nullopt;
  for (std::optional<Eigen::Vector3d>* place : {&settings.centre, &settings.start_point, &settings.part_at})
    intoCloud(*place, call.scan.shift);
  planner->setSettings(settings);
  if (call.scan.mesh)
    planner->setInputMesh(call.scan.mesh);
  else
    planner->setInputCloud(call.scan.cloud);
  call.scan.setSide(*planner, call.scan.name.empty() || call.keywords.isGiven("trust_normals"));
  setPart(call.keywords, call.beside(), call.scan.shift, call.words, *planner);
  planner->setHolder(holderOf(call.keywords["holder"]));
  planner->setFlankLength(call.flank_length);
  planner->setHolderClearance(call.holder_clearance);
  planner->setAcceptCollisions(call.accept_collisions);
  planner->setBallClosing(call.ball_closing);
  planner->setSampleSpacing(call.sample_spacing);
  compute(planner, call.keywords, call.words);

  Path path;
  const SpiralPlan& plan = planner->getPlan();
  path.points = plan.path;
  path.motion = {settings.tool_radius, settings.feed, {}, plan.report.pass_begins, call.scan.shift};
  const Diagnostics reading = joined(call.scan.warnings, plan.part.warnings);
  RunFiles files = call.files();
  files.warnings = reading;
  path.report = reportJSON(files, reportOf(plan));
  path.warnings = call.texts(joined(reading, plan.report.warnings));
  path.source = std::make_shared<PathSource>(PathSource{planOf<SpiralPlan>(planner), nullptr, {}, call.title()});
  return path;
}

/** A planner of passes whose settings of the surface can be set at once. */
template <typename Planner>
struct OpenPlanner : Planner {
  void setSurface(const SurfaceSettings& asked, const Eigen::Vector3d& shift)
  {
    SurfaceSettings& settings = this->surfaceSettings();
    const bool strict = settings.strict;
    settings = asked;
    settings.strict = strict;
    settings.view_point = std::nullopt;
    intoCloud(settings.part_at, shift);
  }
};

/** What drive() and ridge() share. */
struct PassCall : Call {
  PassSettings tool;
  double feed = 1000.0, corner_radius = 0.0;
  bool leave_out_strays = false;

  /** The cutter; without a radius a beam. */
  std::vector<Setting> toolTable()
  {
    return cutterTable(NumberRange::from(0.0), tool.cutter, corner_radius) +
           std::vector<Setting>{
               Setting("feed", "setFeed", "feed", "feed at the contact", "2500", feed).in("mm/min", NumberRange::above(0.0)),
               Setting("accept_collisions", "setAcceptCollisions", "accepted collisions",
                       "collisions of shank and holder are only warnings", "", tool.accept_collisions),
               Setting("leave_out_strays", "setLeaveOutStrays", "left out outliers", "leave out points off the scanned surface", "",
                       leave_out_strays)};
  }

  /** The settings of the surface that planners of passes heed. */
  std::vector<Setting> surfaceTable() { return without(settingTable(surface), {"neighbours", "alpha"}); }

  AskedSettings asked(const Keywords& keywords) const
  {
    return {keywords.isGiven("rows"), keywords.isGiven("point_spacing"), keywords.isGiven("tolerance"), keywords.isGiven("chord_error")};
  }

  /** The path of \p plan; \p report of its JSON. */
  Path pathOf(const std::shared_ptr<const PassPlan>& plan, const Diagnostics& warnings, const std::string& report) const
  {
    Path path;
    PassPath all = joinedPasses(plan->passes);
    path.points = pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(std::move(all.path));
    path.motion = {tool.cutter.radius, feed, std::move(all.tips), std::move(all.begins), scan.shift};
    ToolPoses poses;
    for (const ToolPoses& pass : plan->passes)
      for (ToolPose pose : pass) {
        pose.contact += scan.shift;
        pose.tip += scan.shift;
        poses.push_back(pose);
      }
    path.poses = std::make_shared<const ToolPoses>(std::move(poses));
    path.report = report;
    path.warnings = texts(warnings);
    path.source = std::make_shared<PathSource>(PathSource{nullptr, plan, tool, title()});
    return path;
  }
};

struct DriveCall : PassCall {
  DriveSettings drive;
  MeshSettings mesh;
  bool gouge_check = true, curve_closed = false;
  std::optional<Eigen::Vector3d> column_axis, column_centre;
  Keywords keywords{
      "drive",
      toolTable() + settingTable(drive) + settingTable(tool) + settingTable(mesh) + surfaceTable() +
          std::vector<Setting>{
              Setting("gouge_check", "setGougeCheck", "check of gouges",
                      "on a mesh: False puts the cutter at the contacts of the sections and looks at nothing else", "", gouge_check),
              Setting("curve_closed", "setCurve", "closed curve", "the last point of the curve joins the first", "", curve_closed),
              Setting("column_axis", "setCylinder", "axis of the column", "direction that helix and rings go round", "0,0,1", column_axis)
                  .zeroFor("found from the scan"),
              Setting("column_centre", "DriveCylinder::origin", "centre of the column", "a place on that axis", "20,5,0", column_centre)
                  .zeroFor("0,0,0")} +
          units.table(),
      partInputs() + holder_input +
          std::vector<Input>{
              {"curve", "ArrayLike | str | PathLike[str] | None", "points in order, (N, 3) or a file, for drive='curve'", {}}} +
          progress_input};
};

using OpenDrivePlanner = OpenPlanner<DrivePlanner<pcl::PointXYZ>>;

void
setDrive(DriveCall& call, OpenDrivePlanner& planner)
{
  const bool on_mesh = call.scan.mesh != nullptr;
  completeCutter(call.keywords, call.corner_radius, call.words, call.tool.cutter);
  DriveSettings& drive = call.drive;
  completeDrive(call.asked(call.keywords), call.tool, on_mesh, drive);
  if (call.column_axis)
    drive.cylinder = DriveCylinder{call.column_centre.value_or(Eigen::Vector3d::Zero()) - call.scan.shift, *call.column_axis};
  if (const py::object curve = call.keywords["curve"]; !curve.is_none())
    drive.curve = lineOf("curve", curve, call.beside(), call.words);
  drive.curve_closed = call.curve_closed;
  if (on_mesh) {
    call.surface.flip_normals = false; // the mesh is turned
    planner.setInputMesh(call.scan.mesh);
  }
  else
    planner.setInputCloud(call.scan.cloud);
  planner.setSurface(call.surface, call.scan.shift);
  if (!on_mesh || call.scan.normals || call.scan.asked_view_point)
    call.scan.setSide(planner, call.scan.name.empty() || call.keywords.isGiven("trust_normals"));
  setPart(call.keywords, call.beside(), call.scan.shift, call.words, planner);
  planner.setHolder(holderOf(call.keywords["holder"]));
  planner.setSettings(drive);
  planner.setPassSettings(call.tool);
  planner.setMeshSettings(call.mesh);
  planner.setHolderClearance(call.tool.holder_clearance);
  planner.setAcceptCollisions(call.tool.accept_collisions);
  planner.setLeaveOutStrays(call.leave_out_strays);
  planner.setGougeCheck(call.gouge_check);
}

Path
drive(const py::object& points, const py::dict& given)
{
  DriveCall call;
  call.keywords.take(given);
  call.read(points, call.keywords, call.surface.view_point);
  const auto planner = std::make_shared<OpenDrivePlanner>();
  setDrive(call, *planner);
  compute(planner, call.keywords, call.words);
  const auto plan = planOf<PassPlan>(planner);
  const DriveRun run{{call.tool, call.feed, std::nullopt}, call.drive, call.gouge_check, call.surface.largest_part, call.surface.thinning};
  RunFiles files = call.files();
  files.warnings = joined(call.scan.warnings, plan->chosen.warnings);
  return call.pathOf(plan, joined(files.warnings, plan->warnings), driveReportJSON(files, run, *plan));
}

struct RidgeCall : PassCall {
  RidgeSettings ridge;
  RidgeRowSettings rows;
  bool closed = false;
  double half_width = 0.0;
  Keywords keywords{
      "ridge",
      toolTable() + settingTable(rows) + settingTable(ridge) + settingTable(tool) +
          without(surfaceTable(), {"flip_normals", "part_at", "clusters"}) +
          std::vector<Setting>{
              Setting("half_width", "setHalfWidth", "half width", "of the ridge in the scan, from its crest to each side", "12", half_width)
                  .in("mm", NumberRange::from(0.0)),
              Setting("closed", "setClosed", "closed ridge", "the ridge in the scan is a ring", "", closed)} +
          units.table(),
      std::vector<Input>{
          {"scan_normals", "ArrayLike | None", "(N, 3), one a point of the scan, out of the material", {"setInputNormals"}},
          {"rail", "ArrayLike | str | PathLike[str] | None", "points measured along the ridge, in any order", {"setMeasuredLines"}},
          {"generator", "ArrayLike | str | PathLike[str] | None", "points measured once across it", {}},
          {"through", "ArrayLike | str | PathLike[str] | None", "rough points on the ridge in the scan, in order", {"setRoughPoints"}}} +
          holder_input + progress_input};
};

using OpenRidgePlanner = OpenPlanner<RidgePlanner<pcl::PointXYZ>>;

void
setRidge(RidgeCall& call, OpenRidgePlanner& planner)
{
  completeCutter(call.keywords, call.corner_radius, call.words, call.tool.cutter);
  completeRidge(call.asked(call.keywords), call.tool, call.rows);
  call.tool.holder = holderOf(call.keywords["holder"]);
  if (!call.scan.cloud->empty())
    planner.setInputCloud(call.scan.cloud);
  planner.setSurface(call.surface, call.scan.shift);
  call.scan.setSide(planner, call.scan.name.empty() || call.keywords.isGiven("trust_normals"));
  const auto line = [&call](const char* name) {
    const py::object given = call.keywords[name];
    return given.is_none() ? Polyline() : lineOf(name, given, call.beside(), call.words);
  };
  planner.setMeasuredLines(line("rail"), line("generator"));
  planner.setRoughPoints(line("through"));
  planner.setClosed(call.closed);
  planner.setHalfWidth(call.half_width);
  planner.setRidgeSettings(call.ridge);
  planner.setRowSettings(call.rows);
  planner.setPassSettings(call.tool);
  planner.setNumberOfThreads(call.tool.threads);
  planner.setLeaveOutStrays(call.leave_out_strays);
}

Path
ridge(const py::object& points, const py::dict& given)
{
  RidgeCall call;
  call.scan.cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  call.keywords.take(given);
  call.read(points, call.keywords, call.surface.view_point, "scan_normals");
  const auto planner = std::make_shared<OpenRidgePlanner>();
  setRidge(call, *planner);
  compute(planner, call.keywords, call.words);
  const RidgePlan& plan = planner->getPlan();
  const RidgeRun run{
      {call.tool, call.feed, std::nullopt}, "", "", call.ridge, call.rows, planner->getRoughPoints(), call.half_width, call.closed};
  RunFiles files = call.files();
  files.warnings = call.scan.warnings;
  return call.pathOf(planOf<PassPlan>(planner), joined(files.warnings, plan.warnings), ridgeReportJSON(files, run, plan, plan));
}

} // namespace

py::list
spiralKeywords()
{
  return SpiralCall().keywords.table();
}

py::list
driveKeywords()
{
  return DriveCall().keywords.table();
}

py::list
ridgeKeywords()
{
  return RidgeCall().keywords.table();
}

void
addPlanning(py::module_& module)
{
  module.def("spiral", &spiral);
  module.def("drive", &drive);
  module.def("ridge", &ridge);
}

} // namespace pcl_spiral::python
