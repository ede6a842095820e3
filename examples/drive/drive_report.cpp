#include "drive_report.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/setting_names.h>
#include <pcl_spiral/mesh/mesh_findings.h>

#include <nlohmann/json.hpp>

#include <fstream>

using namespace pcl_spiral;
using Json = nlohmann::ordered_json;

namespace {

Json
settingsOf(const Job& job)
{
  const CutterShape& c = job.cutter;
  const DriveSettings& d = job.drive;
  return {{"cutter",
           {{"radius", c.radius},
            {"corner_radius", c.corner_radius},
            {"flank_length", c.flank_length},
            {"flank_angle", c.flank_angle}}},
          {"drive", choiceName(d.kind)},
          {"step_over", d.step_over},
          {"rows", choiceName(d.rows)},
          {"link", d.link_rows},
          {"point_spacing", d.point_spacing},
          {"axis_mode", choiceName(d.axisMode())},
          {"tolerance", job.tolerance},
          {"gouge_check", !job.no_gouge_check},
          {"largest", job.largest_part},
          {"thin", job.thinning},
          {"feed", job.feed}};
}

Json
rowsOf(const DriveReport& report)
{
  return {{"count", report.rows},
          {"smallest_step", report.smallest_step},
          {"largest_step", report.step_over},
          {"held_share", report.held_share},
          {"links", report.links},
          {"apart", report.rows_apart}};
}

Json
meshOf(const SurfaceMesh& mesh)
{
  const MeshCounts& counts = mesh.counts();
  Json found;
  for (const auto& [words, finding] : mendedFindings(counts))
    found[words] = finding.count;
  return {{"faces", counts.faces},
          {"vertices", counts.vertices},
          {"parts", counts.parts},
          {"boundary_loops", counts.loops},
          {"crease_length", counts.crease_length},
          {"noise", counts.noise},
          {"uncorrected_edges", counts.limited.count},
          {"found", found}};
}

Json
statesOf(const LocationFigures& figures)
{
  Json states;
  for (std::size_t i = 0; i < location_states; ++i)
    states[nameOf(static_cast<LocationState>(i))] = figures.states[i];
  return states;
}

Json
locationsOf(const Result& result)
{
  const LocationFigures& f = result.locations;
  const BisectionFigures& b = result.bisection;
  std::size_t locations = 0;
  for (const ToolPoses& pass : result.passes)
    locations += pass.size();
  return {{"count", locations},
          {"drive_points", result.drive.points},
          {"put_in", b.inserted},
          {"largest_error", b.largest_error},
          {"unresolved_moves", b.unresolved},
          {"states", statesOf(f)},
          {"off_scan", result.off_scan},
          {"over_rim", f.over_rim},
          {"retilted", f.retilted},
          {"largest_retilt", f.largest_retilt},
          {"collisions", f.collisions},
          {"deepest_collision", f.deepest_collision},
          {"noise_allowance", f.noise_allowance}};
}

} // namespace

void
writeDriveReport(const std::string& file, const Job& job, const Result& result)
{
  Json stages = Json::array();
  for (const StageCost& stage : result.stages)
    stages.push_back({{"stage", stage.name}, {"seconds", stage.seconds}});
  Json report = {{"program", "pcl_spiral_drive"},
                 {"scan", job.scan},
                 {"settings", settingsOf(job)},
                 {"passes", result.passes.size()},
                 {"step_over", result.drive.step_over},
                 {"tip_length", result.length},
                 {"locations", locationsOf(result)},
                 {"stages", stages},
                 {"warnings", result.warnings}};
  if (result.mesh)
    report["mesh"] = meshOf(*result.mesh);
  else
    report["points"] = result.scan.cloud->size();
  if (job.drive.kind == DriveKind::Planes)
    report["rows"] = rowsOf(result.drive);
  if (result.program)
    report["machine"] = {{"name", result.program->machine.name},
                         {"blocks", result.program->blocks.size()},
                         {"minutes", result.program->report.minutes}};
  std::ofstream out(file);
  out << report.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
  if (!out.flush())
    throw FileError(file, "cannot be written; is there room on the disk?");
}
