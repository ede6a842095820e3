#include "planning.h"
#include "terminal/terminal.h"

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/core/axis_field.h>
#include <pcl_spiral/io/file_error.h>
#include <pcl_spiral/toolpath/cutter_location.h>
#include <pcl_spiral/toolpath/drive_path.h>

#include <algorithm>
#include <cmath>

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

/** Axes of each pass, smoothed along it and held to the rate. */
void
smooth(const Job& job, DrivePasses& passes)
{
  constexpr double degree = 3.14159265358979323846 / 180.0;
  AxisFieldOptions options;
  options.smoothing_length = job.axis_smoothing;
  options.max_deviation = 20.0 * degree; // jumps of local planes are to go
  options.max_rate = job.max_axis_rate * degree;
  for (DrivePass& pass : passes) {
    Polyline points;
    std::vector<Eigen::Vector3d> axes;
    for (const DrivePoint& p : pass.points) {
      points.push_back(p.position);
      axes.push_back(p.axis.normalized());
    }
    const SmoothAxes smoothed = smoothAxes(points, axes, options);
    for (std::size_t i = 0; i < pass.points.size(); ++i)
      pass.points[i].axis = smoothed.axes[i];
  }
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
  drive.setOverrun(s.overrun);
  if (s.kind == DriveKind::Curve)
    drive.setCurve(curveOf(job));
  drive.setNumberOfThreads(job.threads);
  drive.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(0.5 * share, stage); });
  DrivePasses passes;
  drive.compute(passes);
  require(job, drive.getStatus());
  result.drive = drive.getReport();
  if (job.axis_smoothing > 0.0 || job.max_axis_rate > 0.0)
    smooth(job, passes);
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

/** Length at the ends of a column, along its axis, that no contact comes to; 0 where turns come as near as they are to
 *  each other. */
double
lengthNotReached(const std::vector<ToolLocations>& located, const DriveColumn& column, double step_over)
{
  constexpr int sectors = 72;
  const DriveCylinder& c = column.cylinder;
  const Eigen::Vector3d e1 = referenceAcross(c.direction), e2 = c.direction.cross(e1);
  std::vector<double> least(sectors, c.last), largest(sectors, c.first);
  for (const ToolLocations& pass : located)
    for (const ToolLocation& location : pass)
      if (location.state != LocationState::NoCloud) {
        const Eigen::Vector3d y = location.contact - c.origin;
        const double turn = std::atan2(y.dot(e2), y.dot(e1)) / (2.0 * M_PI) + 0.5;
        const int k = std::min(sectors - 1, static_cast<int>(turn * sectors));
        least[k] = std::min(least[k], y.dot(c.direction));
        largest[k] = std::max(largest[k], y.dot(c.direction));
      }
  double missed = 0.0;
  for (int k = 0; k < sectors; ++k)
    if (least[k] < largest[k]) // a sector that the scan covers
      missed = std::max({missed, least[k] - c.first, c.last - largest[k]});
  return missed > step_over ? missed : 0.0;
}

std::vector<std::string>
warningsOf(const Job& job, const std::vector<ToolLocations>& located, const Result& result)
{
  std::vector<std::string> warnings = result.scan.warnings;
  warnings.insert(warnings.end(), result.drive.warnings.begin(), result.drive.warnings.end());
  warnings.insert(warnings.end(), result.locations.warnings.begin(), result.locations.warnings.end());
  if (job.drive.goesRound())
    if (const double missed = lengthNotReached(located, *result.drive.column, result.drive.step_over); missed > 0.0)
      warnings.push_back(textOf("up to ", missed, " mm at an end of the column are not cut: the surface leans there, and "
                                "the cutter touches it beside its axis; let the path go on beyond the ends, such as "
                                "--overrun ", std::ceil(10.0 * (job.drive.overrun + missed)) / 10.0));
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
  result.warnings = warningsOf(job, located, result);
  return result;
}
