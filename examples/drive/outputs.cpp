#include "outputs.h"
#include "drive_report.h"
#include "job_check.h"
#include "pass_scene.h"
#include "program/machine_moves.h"
#include "program/program_check.h"
#include "terminal/file_names.h"
#include "terminal/terminal.h"

#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/io/setting_names.h>
#include <pcl_spiral/io/toolpath_writer.h>
#include <pcl_spiral/visualization/rotary_picture.h>

#include <cstdio>
#include <filesystem>

using namespace pcl_spiral;

namespace {

/** All passes one after the other, the turn counting them, and the tips of a cutter of any shape. */
pcl::PointCloud<ToolpathPoint>
joined(const Job& job, const Result& result, ToolpathMotion& motion)
{
  pcl::PointCloud<ToolpathPoint> path;
  motion.tool_radius = job.cutter.radius;
  motion.feed = job.feed;
  double length = 0.0;
  for (std::size_t pass = 0; pass < result.passes.size(); ++pass) {
    if (pass > 0)
      motion.passes.push_back(path.size());
    const ToolPose* before = nullptr;
    for (const ToolPose& pose : result.passes[pass]) {
      length += before ? (pose.contact - before->contact).norm() : 0.0;
      before = &pose;
      ToolpathPoint p;
      p.getVector3fMap() = pose.contact.cast<float>();
      p.getNormalVector3fMap() = pose.normal.cast<float>();
      p.getAxisVector3fMap() = pose.axis.cast<float>();
      p.arc_length = length;
      p.turn = static_cast<float>(pass);
      path.push_back(p);
      motion.tips.push_back(pose.tip);
    }
  }
  return path;
}

std::string
titleOf(const Job& job)
{
  return std::filesystem::path(job.scan).filename().string();
}

/** The passes, and the angles of a program beside them: as many files as filesOf names. */
void
writePictures(const Job& job, const Result& result, const OutputFiles& files, std::size_t& next)
{
  ToolpathMotion motion;
  writePasses(files.temporary(next++), passScene(job, result, titleOf(job), joined(job, result, motion)));
  if (result.program)
    writeRotaryAngles(files.temporary(next++), titleOf(job), *result.program);
}

void
writeOne(const Job& job, const Result& result, const std::string& output, const std::string& file)
{
  const std::string extension = extensionOf(output), title = titleOf(job);
  ProgramHeader header = job.program.header;
  header.title = title;
  if (isProgram(output))
    return writeProgram(file, *result.program, extension == ".ngc" ? Dialect::LinuxCNC : job.program.dialect, header);
  if (extension == ".json")
    return writeDriveReport(file, job, result);
  ToolpathMotion motion;
  const pcl::PointCloud<ToolpathPoint> path = joined(job, result, motion);
  if (extension == ".yaml")
    return writeRobotFrames(file, path);
  if (isExchange(output)) {
    ToolPoses poses;
    for (const ToolPoses& pass : result.passes)
      poses.insert(poses.end(), pass.begin(), pass.end());
    return writeAPT(file, poses, {title, aptCutter(CutterProfile(job.cutter)), header.spindle_speed, job.feed});
  }
  writeToolpath(file, path, motion);
}

} // namespace

void
writeOutputs(const Job& job, const Result& result, OutputFiles& files)
try {
  for (const std::string& output : job.outputs)
    requireOnePass(result.passes.size(), output, "drive one pass (--drive helix, curve)");
  std::size_t next = 0;
  for (const std::string& output : job.outputs) {
    if (cancelled())
      throw Cancelled();
    if (extensionOf(output) == ".png")
      writePictures(job, result, files, next);
    else
      writeOne(job, result, output, files.temporary(next++));
  }
  if (cancelled())
    throw Cancelled();
  files.commit();
}
catch (const FileError& error) {
  throw std::runtime_error(files.asGiven(error.what()) + "; no output has been changed");
}

void
printSummary(const Job& job, const Result& result, double seconds)
{
  std::size_t locations = 0;
  for (const ToolPoses& pass : result.passes)
    locations += pass.size();
  if (result.mesh)
    std::printf("mesh            %s: %zu faces, %zu vertices\n", job.scan.c_str(), result.mesh->faceCount(), result.mesh->vertexCount());
  else
    std::printf("scan            %s: %zu points\n", job.scan.c_str(), result.scan.cloud->size());
  if (result.drive.column)
    std::printf("column          radius %.4g to %.4g mm, covered over %.0f degrees\n", result.drive.column->least_radius,
                result.drive.column->largest_radius, result.drive.column->covered_angle);
  std::printf("drive path      %s: %zu pass%s, %zu drive points, step-over %.4g mm\n",
              choiceName(job.drive.kind).c_str(), result.passes.size(), result.passes.size() == 1 ? "" : "es",
              result.drive.points, result.drive.step_over);
  if (job.drive.rows == DriveRows::Kept)
    std::printf("rows            %zu kept to the scallop, %.4g to %.4g mm apart\n", result.drive.rows,
                result.drive.smallest_step, result.drive.step_over);
  if (job.drive.link_rows)
    std::printf("links           %zu rows joined on the surface, %zu not\n", result.drive.links, result.drive.rows_apart);
  std::printf("locations       %zu, %zu of them put in between; largest error of a move %.3g mm\n", locations,
              result.bisection.inserted, result.bisection.largest_error);
  const LocationFigures& f = result.locations;
  if (f.retilted > 0)
    std::printf("axis            turned at %zu locations, by up to %.3g degrees\n", f.retilted, f.largest_retilt);
  if (f.collisions > 0)
    std::printf("collisions      shank or holder at %zu locations, up to %.4g mm deep\n", f.collisions,
                f.deepest_collision);
  std::printf("path length     %.3f m of the tip\n", result.length / 1000.0);
  if (result.program)
    printProgram(*result.program);
  std::printf("time            %s\n", duration(seconds).c_str());
  if (job.verbose)
    for (const StageCost& stage : result.stages)
      std::printf("  %-16s %9.2f s\n", stage.name.c_str(), stage.seconds);
  std::printf("written        ");
  for (const std::string& file : filesOf(job))
    std::printf(" %s", file.c_str());
  std::printf("\n");
}
