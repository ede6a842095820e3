// SPDX-License-Identifier: BSD-3-Clause
#include "console.h"
#include "job_check.h"
#include "judging/figures_table.h"
#include "program/exchange_files.h"
#include "program/machine_moves.h"
#include "terminal/scan_places.h"
#include "terminal/terminal.h"
#include "terminal/vocabulary.h"

#include "mesh/mesh_findings.h"

#include <pcl_spiral/io/motion_text.h>

#include <algorithm>
#include <cstdio>

namespace {

const char*
plural(std::size_t count)
{
  return count == 1 ? "" : "s";
}

/** Prints how the path passes each of the widest holes. */
void
printHoles(const pcl_spiral::SpiralReport& report)
{
  constexpr std::size_t most = 6;
  std::vector<pcl_spiral::HoleReport> holes = report.holes;
  std::stable_sort(holes.begin(), holes.end(), [](const auto& a, const auto& b) { return a.width > b.width; });
  for (std::size_t i = 0; i < std::min(most, holes.size()); ++i)
    std::printf("hole            %.3g mm wide at %.1f, %.1f, %.1f: the path runs %s\n", holes[i].width, holes[i].place.x(),
                holes[i].place.y(), holes[i].place.z(),
                holes[i].handling == pcl_spiral::HoleHandling::Around ? "round it" : "over it, marked in the outputs");
  if (holes.size() > most)
    std::printf("                and %zu narrower holes; the .json report lists all\n", holes.size() - most);
}

void
printMethod(const pcl_spiral::SpiralReport& report)
{
  if (report.method == pcl_spiral::SpiralMethod::ConstantScallop) {
    std::printf("method          constant scallop: %zu loop%s, %zu in the spiral, %zu joined by bridges; %zu finger%s\n",
                report.scallop_loops, plural(report.scallop_loops), report.chain_loops, report.bridges, report.fingers,
                plural(report.fingers));
    std::printf(
        "spiral          %zu turn%s, %zu points; %.0f %% against the requested sense; radius of the sharpest turns %.2f step-overs\n",
        report.turns, plural(report.turns), report.path_points, 100.0 * report.reversed_share, report.turn_radius);
    if (!report.pass_begins.empty())
      std::printf("passes          %zu, %.3f m of lifts between them\n", report.pass_begins.size() + 1, 0.001 * report.lift_length);
    return;
  }
  std::printf("radial lines    %zu, %s\n", report.radial_lines.size(), report.harmonic_lines ? "harmonic" : "geodesic");
  std::printf("spiral          %zu turn%s, %zu points, step-over %.4g to %.4g mm\n", report.turns, plural(report.turns), report.path_points,
              report.smallest_step_over, report.largest_step_over);
}

/** Prints what was found in the mesh and how it was sampled; does not end the last line. */
void
printMesh(const Job& job, const pcl_spiral::SampledMesh& mesh, const pcl_spiral::SpiralReport& report)
{
  std::printf("mesh            %s: %zu faces, %zu vertices\n", job.scan.c_str(), mesh.counts.faces, mesh.counts.vertices);
  if (const pcl_spiral::Diagnostic found = pcl_spiral::findingsText(mesh.counts); !found.empty())
    std::printf("found in it     %s\n", inWords(found).c_str());
  std::printf("samples         %zu, one per %.4g mm", report.input_points, mesh.spacing);
}

void
printSurface(const Job& job, const pcl_spiral::SpiralPlan& plan, const ScanSide& side)
{
  const pcl_spiral::SpiralReport report = inScan(plan.report);
  if (plan.mesh)
    printMesh(job, *plan.mesh, report);
  else
    std::printf("scan            %s: %zu points", job.scan.c_str(), report.input_points);
  const auto dropped = [](std::size_t count, const char* why) {
    if (count > 0)
      std::printf(", %zu %s", count, why);
  };
  dropped(report.nonfinite_points, "not finite");
  dropped(report.duplicate_points, "duplicates");
  dropped(report.outlier_points, "outliers");
  dropped(report.surplus_points, "surplus along scan lines or beside sparser parts");
  dropped(report.left_out_points, "in other parts");
  std::printf(", %zu used\n", report.used_points);
  std::printf("surface         spacing %.4g mm, %s %.2g mm\n", report.spacing, plan.mesh ? "samples off the fits" : "noise", report.noise);
  if (!plan.mesh)
    std::printf("%s\n", sideLine(side, report.side).c_str());
  std::size_t gaps = 0;
  for (const pcl_spiral::BoundaryLoop& loop : report.loops) {
    gaps += loop.type == pcl_spiral::LoopType::ScanGap;
    if (loop.type != pcl_spiral::LoopType::ScanGap)
      std::printf("%s      %.1f mm long, %zu corner%s\n", loop.type == pcl_spiral::LoopType::Outer ? "outer rim " : "inner loop",
                  loop.length, loop.corners.size(), plural(loop.corners.size()));
  }
  if (gaps > 0)
    std::printf("%s %zu, bridged\n", plan.mesh ? "narrow holes   " : "scan gaps      ", gaps);
  printHoles(report);
  if (report.boundaries == 1 && report.method != pcl_spiral::SpiralMethod::ConstantScallop)
    std::printf("centre          %.3f, %.3f, %.3f\n", report.centre.x(), report.centre.y(), report.centre.z());
}

/** Prints what the ball does not reach. */
void
printTight(const pcl_spiral::SpiralReport& report)
{
  constexpr std::size_t most = 6;
  for (std::size_t i = 0; i < std::min(most, report.tight_places.size()); ++i) {
    const pcl_spiral::TightPlace& tight = report.tight_places[i];
    std::printf("%s %.3g mm stay on %.4g mm2 at %.1f, %.1f, %.1f; ", tight.under_cluster ? "under cluster  " : "not reached    ",
                tight.height, tight.area, tight.place.x(), tight.place.y(), tight.place.z());
    if (tight.under_cluster)
      std::printf("the ball rides over it\n");
    else
      std::printf("a ball of radius %.4g mm reaches it\n", tight.radius);
  }
  if (report.tight_places.size() > most)
    std::printf("                and %zu other places; the .json report lists all\n", report.tight_places.size() - most);
  if (report.lifted_length > 0.0)
    std::printf("lifted          %.1f mm of path, by up to %.3g mm\n", report.lifted_length, report.largest_lift);
}

void
printPath(const Job& job, const pcl_spiral::SpiralReport& report)
{
  printMethod(report);
  if (report.deviating_points > 0)
    std::printf("tool axis       more than %g degrees from the requested tilt at %zu point%s, because of smoothing; "
                "at most %.3g degrees\n",
                job.settings.axis_deviation, report.deviating_points, plural(report.deviating_points), report.largest_axis_deviation);
  std::printf("path length     %.3f m", report.path_length / 1000.0);
  if (report.least_length > 0.0 && !job.verify)
    std::printf(", %.3f times the least possible length", report.path_length / report.least_length);
  std::printf("\n");
  if (!report.closest_place.isZero())
    std::printf("closest turns   %.4g mm apart at %.1f, %.1f, %.1f\n", report.smallest_step_over, report.closest_place.x(),
                report.closest_place.y(), report.closest_place.z());
  if (report.gap_points > 0)
    std::printf("over gaps       %.1f mm at %zu point%s: bridged, estimated from the surface around the gaps\n", report.gap_length,
                report.gap_points, plural(report.gap_points));
  printTight(report);
  std::printf("machining time  %s at %g mm/min\n", pcl_spiral::durationText(60.0 * report.path_length / job.settings.feed).c_str(),
              job.settings.feed);
}

void
printStage(const std::string& name, double seconds, double whole, const pcl_spiral::MemoryUse& memory = {})
{
  std::printf("  %-16s %9.2f %7.1f", name.c_str(), seconds, 100.0 * seconds / whole);
  for (const std::size_t bytes : {memory.resident, memory.peak})
    if (bytes > 0)
      std::printf(" %9.0f", 1e-6 * static_cast<double>(bytes));
  std::printf("\n");
}

/** Prints time and memory of every stage; the time outside the stages, such as writing reports, is "the rest". */
void
printStages(const Result& result, double seconds)
{
  std::printf("neighbourhoods  searched in %d pass%s over all points%s\n", result.plan.report.passes,
              result.plan.report.passes == 1 ? "" : "es",
              result.plan.surface && !result.plan.mesh ? "; planning and verification share the surface"
              : result.judged.verification             ? ", for planning and verification"
                                                       : "");
  std::printf("  %-16s %9s %7s %9s %9s\n", "stage", "s", "%", "MB", "peak MB");
  double rest = seconds;
  for (const pcl_spiral::StageCost& stage : result.plan.report.stages) {
    printStage(stage.name, stage.seconds, seconds, stage.memory);
    rest -= stage.seconds;
  }
  if (result.judged.verification) {
    printStage("judging", result.judged.verification->seconds, seconds);
    rest -= result.judged.verification->seconds;
  }
  printStage("the rest", std::max(0.0, rest), seconds);
}

/** Prints what the regions make together. */
void
printTogether(const Job& job, const Result& result)
{
  const pcl_spiral::SpiralReport& report = result.plan.report;
  std::printf("all regions     %zu, %zu passes, %zu points, %.3f m, machining time %s\n", result.regions.size(),
              report.pass_begins.size() + 1, report.path_points, report.path_length / 1000.0,
              pcl_spiral::durationText(60.0 * report.path_length / job.settings.feed).c_str());
  std::printf("links           %zu between regions, retracted to %.4g mm along z, clear of the scan\n", result.plan.regions.size() - 1,
              result.links.height);
}

} // namespace

void
printSummary(const Job& job, const Result& result, double seconds)
{
  for (std::size_t k = 0; k < result.regions.size(); ++k) {
    const pcl_spiral::SpiralPlan& region = result.plan.regions[k];
    std::printf("%s\n", region.region.c_str());
    printSurface(job, region, result.side);
    printPath(job, inScan(region.report));
    if (result.regions[k].verification)
      printFigures(inScan(*result.regions[k].verification));
  }
  if (result.regions.empty()) {
    printSurface(job, result.plan, result.side);
    printPath(job, inScan(result.plan.report));
  }
  else
    printTogether(job, result);
  if (result.program)
    printProgram(*result.program, *result.motion);
  printFrames(job.program, result.moves, job.outputs);
  std::printf("time            %s\n", pcl_spiral::durationText(seconds).c_str());
  if (job.verbose)
    printStages(result, seconds);
  if (job.read.origin != Eigen::Vector3d::Zero())
    std::printf("origin          the path is relative to %.10g, %.10g, %.10g in the scan's unit\n", job.read.origin.x(),
                job.read.origin.y(), job.read.origin.z());
  std::printf("%s", shiftLine().c_str());
  std::printf("written        ");
  for (const std::string& file : filesOf(job))
    std::printf(" %s", file.c_str());
  std::printf("\n");
  if (result.judged.verification)
    printFigures(inScan(*result.judged.verification));
}
