#include "planning.h"
#include "terminal/terminal.h"

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/toolpath/cutter_location.h>
#include <pcl_spiral/toolpath/drive_path.h>

using namespace pcl_spiral;

namespace {

/** What a stage's failure is to the user. */
void
require(const Job& job, const Status& status)
{
  if (status.code() == StatusCode::Cancelled || cancelled())
    throw Cancelled();
  if (status.code() == StatusCode::InvalidArgument)
    throw UsageError(job.scan + ": " + status.message());
  if (!status.ok())
    throw FileError(job.scan, status.message());
}

Polyline
curveOf(const Job& job)
{
  ReadOptions read = job.read;
  read.columns.clear();
  const Scan curve = readCloud(job.curve_file, read);
  Polyline points;
  for (const pcl::PointXYZ& p : *curve.cloud)
    points.push_back(p.getVector3fMap().cast<double>());
  if (points.size() < 2)
    throw FileError(job.curve_file, "a curve needs at least two points");
  return points;
}

DrivePasses
drivePasses(const Job& job, ProgressBar& bar, Result& result)
{
  DrivePath<pcl::PointXYZ> drive;
  const DriveSettings& s = job.drive;
  drive.setInputCloud(result.scan.cloud);
  drive.setKind(s.kind);
  drive.setStepOver(s.step_over);
  drive.setPointSpacing(s.point_spacing);
  drive.setPlaneDirection(s.plane_angle);
  drive.setZigzag(s.zigzag);
  drive.setAxis(s.axis);
  drive.setAxisMode(s.axisMode());
  if (s.kind == DriveKind::Curve)
    drive.setCurve(curveOf(job));
  drive.setNumberOfThreads(job.threads);
  drive.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(0.5 * share, stage); });
  DrivePasses passes;
  drive.compute(passes);
  require(job, drive.getStatus());
  result.drive = drive.getReport();
  return passes;
}

std::vector<ToolLocations>
locate(const Job& job, const DrivePasses& passes, ProgressBar& bar, Result& result)
{
  CutterLocation<pcl::PointXYZ> location;
  location.setInputCloud(result.scan.cloud);
  location.setCutter(job.cutter);
  location.setHolder(job.holder);
  location.setHolderClearance(job.holder_clearance);
  location.setMaxRetilt(job.max_retilt);
  location.setPathTolerance(job.tolerance);
  location.setDrivePasses(passes);
  location.setNumberOfThreads(job.threads);
  location.setProgressCallback(
      [&bar](double share, const std::string& stage) { return bar.update(0.5 + 0.5 * share, stage); });
  std::vector<ToolLocations> located;
  location.compute(located);
  require(job, location.getStatus());
  result.locations = location.getFigures();
  result.bisection = location.getBisectionFigures();
  return located;
}

ToolPose
poseOf(const ToolLocation& location)
{
  const bool fitted = location.normal.squaredNorm() > 0.5;
  return {location.tip, location.axis, location.contact, fitted ? location.normal : location.axis};
}

/** Passes without the locations off the scan, cut in two there. */
void
takePoses(const std::vector<ToolLocations>& located, Result& result)
{
  for (const ToolLocations& pass : located) {
    ToolPoses poses;
    const auto close = [&] {
      if (poses.size() > 1)
        result.passes.push_back(poses);
      poses.clear();
    };
    for (const ToolLocation& location : pass) {
      if (location.state == LocationState::NoCloud) {
        ++result.off_scan;
        close();
        continue;
      }
      if (!poses.empty())
        result.length += (location.tip - poses.back().tip).norm();
      poses.push_back(poseOf(location));
    }
    close();
  }
}

void
requireNoCollision(const Job& job, const std::vector<ToolLocations>& located, const LocationFigures& figures)
{
  if (figures.collisions == 0 || job.accept_collisions)
    return;
  for (const ToolLocations& pass : located)
    for (const ToolLocation& location : pass)
      if (location.collision.found() && location.collision.depth >= figures.deepest_collision)
        throw FileError(job.scan,
                        textOf(job.holder[static_cast<std::size_t>(location.collision.segment)].name,
                               " would be ", location.collision.depth, " mm deep in the scan at ",
                               placeText(location.collision.place), ", the tip at ", placeText(location.tip), "; at ",
                               figures.collisions,
                               " locations in all: use a longer or slimmer tool, another axis, --max-retilt, or "
                               "--accept-collisions to see the path all the same"));
}

std::vector<std::string>
warningsOf(const Job& job, const Result& result)
{
  std::vector<std::string> warnings = result.scan.warnings;
  warnings.insert(warnings.end(), result.drive.warnings.begin(), result.drive.warnings.end());
  warnings.insert(warnings.end(), result.locations.warnings.begin(), result.locations.warnings.end());
  if (result.off_scan > 0)
    warnings.push_back(textOf(result.off_scan,
                              " locations have no point of the scan below the cutter and were left out; passes were cut "
                              "there"));
  if (result.bisection.unresolved > 0)
    warnings.push_back(textOf(result.bisection.unresolved, " moves are beyond the tolerance of ", job.tolerance,
                              " mm, the worst by an error of ", result.bisection.largest_error, " mm at ",
                              placeText(result.bisection.worst_place),
                              ": the axis turns or the surface is too steep there; check it before cutting"));
  return warnings;
}

} // namespace

Result
plan(const Job& job)
{
  ProgressBar bar(job.quiet);
  bar.update(0.0, "reading " + job.scan);
  Result result;
  StageClock clock(result.stages);
  result.scan = readCloud(job.scan, job.read);
  clock.end("reading");
  if (cancelled())
    throw Cancelled();
  const DrivePasses passes = drivePasses(job, bar, result);
  clock.end("drive path");
  const std::vector<ToolLocations> located = locate(job, passes, bar, result);
  clock.end("locations");
  bar.clear();
  requireNoCollision(job, located, result.locations);
  takePoses(located, result);
  if (result.passes.empty())
    throw FileError(job.scan, "no pass has two locations over the scan; check the drive path and the tool axis");
  result.warnings = warningsOf(job, result);
  return result;
}
