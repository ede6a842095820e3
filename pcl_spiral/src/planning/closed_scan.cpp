// SPDX-License-Identifier: BSD-3-Clause
#include "planning/closed_scan.h"

#include "planning/scan_clearance.h"
#include <pcl_spiral/cleaning/ball_closing.h>
#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/search/impl/point_selection.h>
#include <pcl_spiral/search/impl/usable_points.h>

#include <algorithm>
#include <array>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double reach = 2.0;        // radii: a point moves a ball so far from it, and that ball a surface
constexpr double parallel = 1e-9;    // sine between directions
constexpr double narrow_cells = 4.0; // narrower than that nothing is a hole: a cell that is missing, and those about it

/** Raised by a quarter of the radius, edges are no sharper than that, and hollows no tighter than three quarters: a fit can follow them. By
 *  half, both are half the radius, and the path is longer. Neither cuts more: with the curvature k of a closed surface, -1/R or more, the
 *  scallop of the tool of radius R is (R - r) / (R (1 + k r)) of that of the smaller ball on the surface raised by r, and so at most as
 *  high. */
constexpr std::array<ClosingTry, closing_tries> tries{
    {{0.25, false, false}, {0.5, false, false}, {0.25, true, false}, {0.5, true, false}, {0.25, false, true}}};

/** The point of \p cloud that is nearest to \p place. */
Eigen::Vector3d
nearestOf(const pcl::PointCloud<pcl::PointXYZ>& cloud, const Eigen::Vector3d& place)
{
  const auto nearer = [&place](const pcl::PointXYZ& a, const pcl::PointXYZ& b) {
    return (a.getVector3fMap().cast<double>() - place).squaredNorm() < (b.getVector3fMap().cast<double>() - place).squaredNorm();
  };
  return std::min_element(cloud.begin(), cloud.end(), nearer)->getVector3fMap().cast<double>();
}

/** Moves what the outlier filter takes for false echoes from the scan of \p input to \p echoes: the ball goes through these. */
Status
leaveEchoesOut(PlanInput& input, pcl::PointCloud<pcl::PointXYZ>& echoes)
{
  SpiralSettings& s = input.settings;
  if (s.outlier_neighbours <= 0 || !input.cloud)
    return Status::success();
  if (const Diagnostic fault = rangeFault(static_cast<SurfaceSettings&>(s)); !fault.empty())
    return {StatusCode::InvalidArgument, fault};
  const UsablePoints usable = usablePoints(*input.cloud, nullptr);
  const auto kept = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  kept->sensor_origin_ = input.cloud->sensor_origin_;
  std::vector<std::uint8_t> is_kept(usable.positions.size(), 0);
  for (const std::uint32_t i : statisticalInliers(usable.positions, s.outlier_neighbours, s.outlier_deviations))
    is_kept[i] = 1;
  for (std::size_t i = 0; i < is_kept.size(); ++i)
    (is_kept[i] != 0 ? *kept : echoes).push_back({usable.positions[i].x(), usable.positions[i].y(), usable.positions[i].z()});
  input.cloud = kept;
  s.outlier_neighbours = 0;
  return Status::success();
}

/** What became of the \p echoes: the path of \p plan leads the ball through them. */
Diagnostic
echoText(const SpiralPlan& plan, double radius, double allowed, const pcl::PointCloud<pcl::PointXYZ>& echoes)
{
  const Diagnostic left_out(echoes.size(), " points of the {scan} were left out as false echoes ({setOutlierRemoval})");
  const DeepestPoint deepest = deepestPoint(*plan.path, plan.report.pass_begins, radius, echoes);
  if (deepest.depth <= allowed)
    return left_out;
  return Diagnostic(left_out, ", and the ball goes up to ", deepest.depth, " {mm} into them, most at ", Place(deepest.place),
                    ": if they are of the part, leave the filter out");
}

/** Ok, or Failed with the place where the ball is deeper than \p allowed, mm, in the \p scan. */
Status
checkClear(const SpiralPlan& plan, double radius, double allowed, const pcl::PointCloud<pcl::PointXYZ>& scan)
{
  const DeepestPoint deepest = deepestPoint(*plan.path, plan.report.pass_begins, radius, scan);
  if (deepest.depth <= allowed)
    return Status::success();
  return {StatusCode::Failed,
          Diagnostic("the ball would cut ", deepest.depth, " {mm} into the {scan} at ", Place(deepest.place), ", where ", allowed,
                     " {mm} are allowed: close the {scan} by a larger ball ({setToolRadius}), or crop it ({setCrop})")};
}

/** How far \p place is from the crop of \p choice, across the \p fall of the ball, mm; 0: inside, or the crop is not along the fall. */
double
fromCrop(const PartChoice& choice, const Eigen::Vector3d& fall, const Eigen::Vector3d& place)
{
  double farthest = 0.0;
  if (choice.crop && choice.crop->axis().cross(fall).norm() < parallel)
    farthest = choice.crop->distance(place);
  if (choice.crop_box && Eigen::Vector3d::UnitZ().cross(fall).norm() < parallel) {
    const Eigen::AlignedBox2d box(choice.crop_box->min().head<2>(), choice.crop_box->max().head<2>());
    farthest = std::max(farthest, box.exteriorDistance(Eigen::Vector2d(place.head<2>())));
  }
  return farthest;
}

/** Leaves out of the scan of \p input what lies so far beside its crop that no ball over the crop, or over the rim's overhang, meets it. */
void
leaveFarPointsOut(PlanInput& input)
{
  const SpiralSettings& s = input.settings;
  const bool is_cropped = input.choice.crop || input.choice.crop_box;
  if (!is_cropped || input.indices || !input.cloud || (!s.fixed_axis && knowsSide(input)))
    return;
  const Eigen::Vector3d fall = s.fixed_axis ? s.fixed_axis->normalized() : Eigen::Vector3d::UnitZ();
  const double farthest = reach * s.tool_radius + std::max(0.0, s.rim_overhang);
  const auto near = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  near->sensor_origin_ = input.cloud->sensor_origin_;
  for (const pcl::PointXYZ& p : *input.cloud) // dilation, then erosion: twice the radius
    if (pcl::isFinite(p) && fromCrop(input.choice, fall, p.getVector3fMap().cast<double>()) <= farthest)
      near->push_back(p);
  input.cloud = near;
}

/** The figures of \p scan in place of those of the closed one. */
void
tellScan(const PlanInput& whole, std::size_t echoes, const ClosingReport& figures, ScanReport& report)
{
  report.input_points = whole.indices ? whole.indices->size() : whole.cloud->size();
  report.nonfinite_points = static_cast<std::size_t>(
      std::count_if(whole.cloud->begin(), whole.cloud->end(), [](const pcl::PointXYZ& p) { return !pcl::isFinite(p); }));
  report.outlier_points = echoes;
  report.used_points = figures.points;
  report.spacing = figures.spacing;
}

} // namespace

Status
checkClosable(const PlanInput& input)
{
  if (input.mesh)
    return {StatusCode::InvalidArgument,
            "{setBallClosing} belongs to scans, and a mesh is given ({setInputMesh}): leave one of the two out"};
  if (!input.choice.keep_outs.empty())
    return {StatusCode::InvalidArgument,
            "a keep-out ({addKeepOut}) does not go with {setBallClosing}, which rides over all that was scanned: leave "
            "the keep-out out, or cut what lies beside it by a crop ({setCrop})"};
  if (input.settings.thinning > 0.0)
    return {StatusCode::InvalidArgument,
            "thinning ({setThinning}) drops points that the ball must not touch, and {setBallClosing} makes an "
            "even surface itself: leave the thinning out"};
  if (input.choice.clusters != ClusterHandling::Refuse)
    return {StatusCode::InvalidArgument, "clusters ({setClusterHandling}) are of the surface over which {setBallClosing} leads the ball: "
                                         "leave one of the two out; the outlier filter ({setOutlierRemoval}) removes false echoes"};
  if (input.settings.tight == TightHandling::Refuse)
    return {
        StatusCode::InvalidArgument,
        "places that the ball does not reach cannot be refused ({setTightHandling}) with {setBallClosing}, which bridges them: leave one "
        "of the two out"};
  if (input.settings.flip_normals)
    return {StatusCode::InvalidArgument, "{setFlipNormals} turns the side, which {setBallClosing} takes from the tool axis: set the axis "
                                         "({setFixedAxis}), and leave the turn out"};
  return Status::success();
}

bool
knowsSide(const PlanInput& input)
{
  const Eigen::Vector3f sensor = input.cloud->sensor_origin_.head<3>();
  return input.settings.fixed_axis || input.settings.view_point || (sensor.allFinite() && !sensor.isZero(0.0f));
}

Status
closeScan(const PlanInput& given, const SeenParts& seen, const ClosingTry& how, ClosedScan& closed)
{
  closed.input = given;
  SpiralSettings& s = closed.input.settings;
  closed.rounding = how.rounding * s.tool_radius;
  BallClosing<pcl::PointXYZ> closing;
  closing.setInputCloud(seen.chosen ? seen.chosen : given.cloud);
  if (seen.chosen)
    closing.setObstacles(given.cloud);
  closing.setToolRadius(s.tool_radius);
  closing.setRounding(closed.rounding);
  closing.setNumberOfThreads(s.threads);
  closing.setQuiet(true);
  if (s.fixed_axis)
    closing.setDirection(*s.fixed_axis);
  else if (s.view_point)
    closing.setViewPoint(*s.view_point);
  const auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  closing.compute(*points);
  if (!closing.getStatus().ok())
    return closing.getStatus();
  const ClosingReport& figures = closed.figures = closing.getReport();
  if (figures.covered > 0)
    closed.warnings.push_back(
        Diagnostic("seen along the tool axis, ", 100.0 * static_cast<double>(figures.covered) / static_cast<double>(figures.points),
                   " % of the points of the {scan} lie under overhangs or in folds that a ball of ", s.tool_radius,
                   " {mm} cannot enter ({setBallClosing}): material stays there; scan and cut from another side, or take a smaller ball "
                   "({setToolRadius})"));
  closed.input.cloud = points;
  closed.input.normals.reset();
  closed.input.indices.reset();
  if (closed.input.choice.part_at) // the closed scan lies above the place
    closed.input.choice.part_at = nearestOf(*closed.input.cloud, *closed.input.choice.part_at);
  s.heights = closing.getHeightGrid();
  s.view_point.reset();
  s.fixed_axis = s.heights->along();
  if (closed.input.choice.crop_box)
    closed.input.choice.crop_box->translate(closed.rounding * s.heights->along());
  s.tool_radius -= closed.rounding;
  if (s.method == SpiralMethod::Shortest) // flanks and holes all round: radial lines lead over them the long way, if at all
    s.method = how.radial ? SpiralMethod::Radial : SpiralMethod::ConstantScallop;
  if (how.turned)
    s.sense = s.sense == SpiralSense::Clockwise ? SpiralSense::CounterClockwise : SpiralSense::Clockwise;
  if (!(s.hole_size > 0.0))
    s.hole_size = narrow_cells * figures.cell;
  closed.input.modifiers.push_back(std::make_shared<const ScanClearance>(closing.getDropBall(), *s.heights));
  return Status::success();
}

void
moveToScan(double rounding, SpiralPlan& plan)
{
  pcl::PointCloud<ToolpathPoint>& path = *plan.path;
  const std::vector<std::size_t>& passes = plan.report.pass_begins;
  double length = 0.0;
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < path.size(); ++i) {
    ToolpathPoint& p = path[i];
    const Eigen::Vector3d contact = p.getVector3fMap().cast<double>() - rounding * p.getNormalVector3fMap().cast<double>();
    p.getVector3fMap() = contact.cast<float>();
    if (i > 0 && !std::binary_search(passes.begin(), passes.end(), i))
      length += (contact - before).norm();
    p.arc_length = length;
    before = contact;
  }
  plan.report.path_length = length;
  plan.settings.tool_radius += rounding;
  plan.tool.cutter = CutterShape::ball(plan.settings.tool_radius, plan.tool.cutter.flank_length);
}

namespace {

/** The refusal after \p tries, of which the first gave \p said. */
Status
noPath(const Status& said, std::size_t tries)
{
  return {
      said.code(),
      Diagnostic("closed by the ball ({setBallClosing}) the {scan} gives no path, in ", tries,
                 " tries with two roundings, both senses and both methods: take another tool radius ({setToolRadius}) or scallop height "
                 "({setScallopHeight}), or crop the {scan} ({setCrop}). The first try ended with: ",
                 said.diagnostic())};
}

} // namespace

Status
planClosed(const PlanInput& whole, std::size_t most, const PlanRun& run, SpiralPlan& plan)
{
  if (const Status status = checkClosable(whole); !status.ok())
    return status;
  PlanInput given = whole;
  pcl::PointCloud<pcl::PointXYZ> echoes;
  leaveFarPointsOut(given);
  if (const Status status = leaveEchoesOut(given, echoes); !status.ok())
    return status;
  SeenParts seen;
  if (const Status status = findSeenParts(given, seen); !status.ok())
    return status;
  Status first = Status::success();
  std::vector<PlanAttempt> failed;
  if (whole.settings.method != SpiralMethod::Shortest)
    most = std::min(most, tries.size() - 1); // there is but one method
  for (std::size_t i = 0; i < most; ++i) {
    const ClosingTry& how = tries[i];
    std::vector<StageCost> stages;
    StageClock clock(stages);
    ClosedScan closed;
    if (const Status status = closeScan(given, seen, how, closed); !status.ok())
      return status;
    clock.end("ball closing");
    Status status = run(closed.input, closed.rounding, plan);
    clock.restart();
    if (status.ok())
      status = checkClear(plan, given.settings.tool_radius, given.settings.chord_error, *given.cloud);
    clock.end("clearance");
    if (status.ok()) {
      plan.cloud = given.cloud; // what pictures show below the path: the closed scan is raised
      for (SpiralPlan& region : plan.regions)
        region.cloud = given.cloud;
      plan.attempts.insert(plan.attempts.begin(), failed.begin(), failed.end());
      if (how.turned)
        closed.warnings.push_back("the path runs in the other sense than asked for ({setSense}): in that one no path was found over the "
                                  "closed scan ({setBallClosing})");
      if (!echoes.empty())
        closed.warnings.push_back(echoText(plan, given.settings.tool_radius, given.settings.chord_error, echoes));
      tellScan(whole, echoes.size(), closed.figures, plan.report);
      if (!seen.joined.empty())
        closed.warnings.push_back(seen.joined);
      plan.report.warnings.insert(plan.report.warnings.end(), closed.warnings.begin(), closed.warnings.end());
      plan.report.stages.insert(plan.report.stages.begin(), stages.begin(), stages.end());
      return status;
    }
    failed.insert(failed.end(), plan.attempts.begin(), plan.attempts.end());
    if (first.ok())
      first = status;
    const bool final = status.code() == StatusCode::InvalidArgument || status.code() == StatusCode::Cancelled;
    if (final || i + 1 == most) {
      plan = SpiralPlan();
      plan.attempts = std::move(failed);
      return final ? status : noPath(first, most);
    }
  }
  return first;
}

} // namespace pcl_spiral
