#include "planning.h"
#include "column_ends.h"
#include "mesh_part.h"
#include "program/program_check.h"
#include "scan_surface.h"
#include "terminal/setter_names.h"
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

Polyline
curveOf(const Job& job, Result& result)
{
  ReadOptions read = job.read;
  read.columns.clear();
  const Scan curve = readCloud(job.curve_file, read);
  Polyline points;
  for (const pcl::PointXYZ& p : *curve.cloud)
    points.push_back(p.getVector3fMap().cast<double>());
  if (points.size() < 2)
    throw FileError(job.curve_file, "a curve needs at least two points");
  result.warnings.insert(result.warnings.end(), curve.warnings.begin(), curve.warnings.end());
  return points;
}

/** A pass as its points and axes; a ring three times round, so that its middle knows no ends. */
void
unroll(const DrivePass& pass, Polyline& points, std::vector<Eigen::Vector3d>& axes)
{
  for (int round = 0; round < (pass.closed ? 3 : 1); ++round)
    for (const DrivePoint& p : pass.points) {
      points.push_back(p.position);
      axes.push_back(p.axis.normalized());
    }
}

/** Axes of each pass, smoothed along it and held to the rate. */
void
smooth(const Job& job, DrivePasses& passes, std::vector<std::string>& warnings)
{
  constexpr double degree = 3.14159265358979323846 / 180.0;
  constexpr double most_smoothed = 20.0, farthest = 45.0; // degrees; farther off, passes no longer cover the surface
  AxisFieldOptions options;
  options.smoothing_length = job.axis_smoothing;
  options.max_deviation = most_smoothed * degree;
  options.max_rate = job.max_axis_rate * degree;
  double largest = 0.0;
  for (DrivePass& pass : passes) {
    Polyline points;
    std::vector<Eigen::Vector3d> axes;
    unroll(pass, points, axes);
    const SmoothAxes smoothed = smoothAxes(points, axes, options);
    const std::size_t first = pass.closed ? pass.points.size() : 0;
    for (std::size_t i = 0; i < pass.points.size(); ++i)
      pass.points[i].axis = smoothed.axes[first + i];
    largest = std::max(largest, smoothed.largest_deviation / degree);
  }
  if (largest > farthest)
    throw UsageError(textOf("--max-axis-rate ", job.max_axis_rate, ", --axis-smoothing ", job.axis_smoothing,
                            ": axes would lean ", largest, " degrees off those asked for, and not cover the surface; raise "
                            "the rate, or smooth over less"));
  if (largest > 1.0)
    warnings.push_back(textOf("smoothing and rate lead axes up to ", largest, " degrees off those asked for"));
}

/** The mesh, or the scan's points and the surface through them. */
template <typename Stage>
void
setPart(const Job& job, const Result& result, const Surface::ConstPtr& surface, Stage& stage)
{
  if (result.mesh) {
    stage.setInputMesh(result.mesh);
    stage.setNumberOfThreads(job.threads);
    return;
  }
  stage.setInputCloud(result.scan.cloud);
  stage.setInputSurface(surface); // null: it says what is wrong
  setSurface(job, stage);
}

DrivePasses
drivePasses(const Job& job, const Surface::ConstPtr& surface, ProgressBar& bar, Result& result)
{
  DrivePath<pcl::PointXYZ> drive;
  const DriveSettings& s = job.drive;
  setPart(job, result, surface, drive);
  drive.setKind(s.kind);
  drive.setStepOver(s.step_over);
  drive.setPointSpacing(s.point_spacing);
  drive.setPlaneDirection(s.plane_angle);
  drive.setZigzag(s.zigzag);
  drive.setRows(s.rows);
  drive.setScallop(s.tool_radius, s.scallop_height);
  drive.setLinkRows(s.link_rows);
  drive.setAxis(s.axis);
  drive.setAxisMode(s.axisMode());
  drive.setOverrun(s.overrun);
  if (job.column_axis)
    drive.setCylinder({job.column_centre, *job.column_axis});
  if (s.kind == DriveKind::Curve)
    drive.setCurve(curveOf(job, result));
  drive.setChordError(0.5 * job.tolerance); // half is for the moves between locations
  drive.setProgressCallback([&bar](double share, const std::string& stage) { return bar.update(0.5 * share, stage); });
  DrivePasses passes;
  drive.compute(passes);
  require(job, drive.getStatus());
  result.drive = drive.getReport();
  if (job.axis_smoothing > 0.0 || job.max_axis_rate > 0.0)
    smooth(job, passes, result.warnings);
  return passes;
}

std::vector<ToolLocations>
locate(const Job& job, const Surface::ConstPtr& surface, const DrivePasses& passes, ProgressBar& bar, Result& result)
{
  CutterLocation<pcl::PointXYZ> location;
  setPart(job, result, surface, location);
  location.setCutter(job.cutter);
  location.setHolder(job.holder);
  location.setHolderClearance(job.holder_clearance);
  location.setContactTolerance(std::min(location.getContactTolerance(), job.tolerance));
  location.setPathTolerance(job.tolerance);
  location.setDrivePasses(passes);
  location.setProgressCallback(
      [&bar](double share, const std::string& stage) { return bar.update(0.5 + 0.5 * share, stage); });
  std::vector<ToolLocations> located;
  location.compute(located);
  require(job, location.getStatus());
  result.locations = location.getFigures();
  result.bisection = location.getBisectionFigures();
  return located;
}

/** Without a fit the surface's normal is taken from the cutter, which lies against it. */
Eigen::Vector3d
normalAt(const CutterProfile& cutter, const ToolLocation& location)
{
  if (location.normal.squaredNorm() > 0.5)
    return location.normal;
  const Eigen::Vector3d from_tip = location.contact - location.tip;
  const Eigen::Vector3d across = from_tip - from_tip.dot(location.axis) * location.axis;
  const double l = std::min(across.norm(), cutter.radius());
  const Eigen::Vector2d out = cutter.normal(l);
  const Eigen::Vector3d side = l > 0.0 ? Eigen::Vector3d(across.normalized()) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  return -(out.x() * side + out.y() * location.axis).normalized();
}

/** Passes without the locations off the scan, cut in two there. */
void
takePoses(const CutterProfile& cutter, const std::vector<ToolLocations>& located, Result& result)
{
  for (const ToolLocations& pass : located) {
    ToolPoses poses;
    const auto close = [&] {
      if (poses.size() > 1)
        result.passes.push_back(poses);
      result.off_scan += poses.size() == 1;
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
      poses.push_back({location.tip, location.axis, location.contact, normalAt(cutter, location)});
    }
    close();
  }
}

void
requireNoCollision(const Job& job, const std::vector<ToolLocations>& located, const LocationFigures& figures)
{
  if (figures.collisions == 0 || job.program.accept_collisions)
    return;
  for (const ToolLocations& pass : located)
    for (const ToolLocation& location : pass)
      if (location.collision.found() && location.collision.depth >= figures.deepest_collision)
        throw FileError(job.scan,
                        textOf(job.holder[static_cast<std::size_t>(location.collision.segment)].name,
                               " would be ", location.collision.depth, " mm deep in the scan at ",
                               placeText(location.collision.place), ", the tip at ", placeText(location.tip), "; at ",
                               figures.collisions,
                               " locations in all: use a longer or slimmer tool, another axis, or "
                               "--accept-collisions to see the path all the same"));
}

/** Says what of a column's ends no contact comes to. */
void
warnOfEnds(const Job& job, const std::vector<ToolLocations>& located, Result& result)
{
  ColumnEnds scan(result.drive.column->cylinder), contacts(result.drive.column->cylinder);
  for (const pcl::PointXYZ& p : *result.scan.cloud)
    if (p.getVector3fMap().allFinite())
      scan.add(p.getVector3fMap().cast<double>());
  for (const ToolLocations& pass : located)
    for (const ToolLocation& location : pass)
      if (location.state != LocationState::NoCloud)
        contacts.add(location.contact);
  const double missed = scan.missedBy(contacts);
  if (!(missed > result.drive.step_over))
    return;
  const double most = job.cutter.radius + result.drive.step_over, overrun = std::min(job.drive.overrun + missed, most);
  const bool helps = job.drive.axisMode() == DriveAxisMode::Cylinder && job.drive.overrun < most;
  result.warnings.push_back(textOf("up to ", missed, " mm at an end of the column are not cut",
                                   helps ? textOf("; where it leans the cutter touches it beside its axis: let the path go "
                                                  "on beyond the ends, such as --overrun ", std::ceil(10.0 * overrun) / 10.0)
                                         : std::string(": check the path there")));
}

std::vector<std::string>
warningsOf(const Job& job, const Result& result)
{
  std::vector<std::string> warnings = result.scan.warnings;
  warnings.insert(warnings.end(), result.warnings.begin(), result.warnings.end());
  warnings.insert(warnings.end(), result.drive.warnings.begin(), result.drive.warnings.end());
  warnings.insert(warnings.end(), result.locations.warnings.begin(), result.locations.warnings.end());
  if (result.off_scan > 0)
    warnings.push_back(textOf(result.off_scan,
                              " locations have nothing of the part below the cutter and were left out; passes were cut there"));
  if (job.no_gouge_check)
    warnings.push_back("the cutter was not checked against the rest of the mesh (--no-gouge-check): hollows narrower than the "
                       "cutter are cut into");
  const double flat = CutterProfile(job.cutter).flatRadius();
  if (job.scallop > 0.0 && flat > 0.0)
    warnings.push_back(textOf("the step-over of ", job.drive.step_over, " mm leaves ridges of ", job.scallop,
                              " mm only where the surface lies straight across the tool axis; on slopes the edge of this "
                              "cutter leaves far higher ones: give a --step-over there"));
  if (result.bisection.unresolved > 0)
    warnings.push_back(textOf(result.bisection.unresolved, " moves are beyond the tolerance of ", job.tolerance,
                              " mm, the worst by an error of ", result.bisection.largest_error, " mm at ",
                              placeText(result.bisection.worst_place),
                              ": the axis turns or the surface is too steep there; check it before cutting"));
  return warnings;
}

/** The scan, and the surface through its points. */
Surface::ConstPtr
readScan(const Job& job, ProgressBar& bar, Result& result, StageClock& clock)
{
  result.scan = readCloud(job.scan, job.read);
  result.scan.warnings = inOptions(result.scan.warnings);
  result.whole_scan = result.scan.cloud;
  clock.end("reading");
  if (cancelled())
    throw Cancelled();
  if (job.leave_out_strays) {
    bar.update(0.0, "strays");
    leaveOutStrays(job, result);
    clock.end("strays");
  }
  const Surface::ConstPtr surface = surfaceOf(job, bar, result);
  clock.end("surface");
  return surface;
}

} // namespace

Result
plan(const Job& job)
{
  ProgressBar bar(job.quiet);
  bar.update(0.0, "reading " + job.scan);
  Result result;
  StageClock clock(result.stages);
  Surface::ConstPtr surface;
  if (job.mesh) {
    readMeshPart(job, result);
    clock.end("mesh");
    if (hasProgram(job.program, job.outputs) || job.drive.goesRound()) {
      sampleMeshPart(job, result);
      clock.end("samples");
    }
  }
  else
    surface = readScan(job, bar, result, clock);
  const DrivePasses passes = drivePasses(job, surface, bar, result);
  clock.end("drive path");
  const std::vector<ToolLocations> located =
      job.no_gouge_check ? standAtContacts(job, passes) : locate(job, surface, passes, bar, result);
  clock.end("locations");
  bar.clear();
  requireNoCollision(job, located, result.locations);
  takePoses(CutterProfile(job.cutter), located, result);
  if (result.passes.empty())
    throw FileError(job.scan, "no pass has two locations over the part; check the drive path and the tool axis");
  if (job.drive.goesRound())
    warnOfEnds(job, located, result);
  result.warnings = inOptions(warningsOf(job, result));
  return result;
}
