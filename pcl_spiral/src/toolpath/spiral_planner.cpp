#include <pcl_spiral/toolpath/spiral_planner.h>

#include <pcl_spiral/core/self_crossing.h>
#include <pcl_spiral/core/tool_axis.h>
#include <pcl_spiral/features/surface_boundary.h>
#include <pcl_spiral/search/stray_removal.h>
#include <pcl_spiral/surface/gap_filling.h>
#include <pcl_spiral/toolpath/boundary_choice.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>

namespace pcl_spiral {
namespace {

constexpr double two_sheets_scatter = 0.35; // of the spacing: more is no surface
constexpr double gap_in_spacings = 2.7;       // on random points one in 10^9 lies so far from the next
constexpr std::size_t chunk = 1u << 16;     // path points between progress reports

double
radians(double degrees)
{
  return degrees * M_PI / 180.0;
}

template <typename... Parts>
std::string
text(const Parts&... parts)
{
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

std::string
at(const Eigen::Vector3d& p)
{
  return text("(", p.x(), ", ", p.y(), ", ", p.z(), ")");
}

} // namespace

SpiralPlanner::SpiralPlanner(const SpiralSettings& settings, ProgressCallback progress, SpiralReport& report,
                             StageClock& clock)
: settings_(settings), progress_(std::move(progress)), report_(report), clock_(clock)
{
}

bool
SpiralPlanner::report(double share, const std::string& stage)
{
  return !progress_ || progress_(share, stage);
}

Status
SpiralPlanner::makeGraph(std::vector<Eigen::Vector3f> points, std::vector<Eigen::Vector3f> normals)
{
  SurfaceGraphOptions options;
  options.view_point = settings_.view_point;
  options.flip_normals = settings_.flip_normals;
  options.given_normals = std::move(normals);
  if (const Status status = buildWithoutStrays(std::move(points), std::move(options), graph_, source_); !status.ok())
    return status;
  if (bridges_.empty()) {
    report_.outlier_points += source_.strays;
    report_.surplus_points = source_.surplus;
    report_.used_points = source_.indices.size();
    if (source_.strays > 0)
      report_.warnings.push_back(text(source_.strays, " points that stand alone off the surface were left out"));
    if (source_.surplus > 0)
      report_.warnings.push_back(text(source_.surplus, " points were left out where they lie much closer together than to ",
                                      "the next scan line or the sparser part beside them: the path follows the others, ",
                                      graph_.spacing(), " mm apart"));
  }
  surface_ = std::make_unique<MlsSurface>(graph_);
  report_.spacing = graph_.spacing();
  report_.noise = surface_->noise();
  report_.projection_neighbours = surface_->neighbours();
  if (surface_->noise() > two_sheets_scatter * graph_.spacing())
    return {StatusCode::InvalidInput,
            text("the points scatter by ", surface_->noise(), " mm about a local surface, against a spacing of ",
                 graph_.spacing(), " mm: this is no single sheet (a double wall, or noise above the point spacing); ",
                 "separate the sheets, or thin the cloud to a spacing well above the noise")};
  return Status::success();
}

Status
SpiralPlanner::findLoops()
{
  BoundaryCounts counts;
  if (const Status status = findBoundaryLoops(*surface_, BoundaryOptions(), report_.loops, &counts); !status.ok())
    return status;
  if (counts.left_out_parts > 0 && bridges_.empty())
    report_.warnings.push_back(text(counts.left_out_parts, " specks apart from the surface were left out"));
  return Status::success();
}

Status
SpiralPlanner::bridgeGaps(const std::vector<Eigen::Vector3f>& normals)
{
  BoundaryChoice choice;
  if (const Status status = chooseBoundaries(report_.loops, settings_.boundary_mode, choice); !status.ok())
    return status;
  const bool two = choice.inner;
  report_.boundaries = two ? 2 : 1;
  const std::vector<BoundaryLoop> loops = report_.loops;
  bool kept_hole = !two;
  for (const BoundaryLoop& loop : loops) {
    if (loop.type == LoopType::Outer)
      continue;
    if (loop.type == LoopType::Inner && !kept_hole) {
      kept_hole = true;
      continue;
    }
    if (settings_.gaps == GapHandling::Refuse)
      return {StatusCode::InvalidInput, text("the scan has a gap at ", at(loop.points.front()), ", ", loop.length,
                                             " mm round: rescan it, or allow gaps to be bridged")};
    const GapFill fill = fillGap(graph_, loop.points);
    bridges_.insert(bridges_.end(), fill.points.begin(), fill.points.end());
    report_.warnings.push_back(text("a gap in the scan at ", at(fill.centre), ", ", fill.width,
                                    " mm wide, was bridged by a smooth patch; the points about it lie ",
                                    fill.residual, " mm (rms) from it"));
  }
  if (bridges_.empty())
    return Status::success();
  std::vector<Eigen::Vector3f> points = graph_.blocks().points(), known;
  for (std::size_t i = 0; !normals.empty() && i < points.size(); ++i)
    known.push_back(normals[source_.indices[graph_.blocks().originalIndex(i)]]);
  first_bridge_ = points.size();
  points.insert(points.end(), bridges_.begin(), bridges_.end());
  known.resize(normals.empty() ? 0 : points.size(), Eigen::Vector3f::Zero());
  if (const Status status = makeGraph(std::move(points), std::move(known)); !status.ok())
    return status;
  if (const Status status = findLoops(); !status.ok())
    return status;
  // The gaps that were bridged stay in the report.
  for (const BoundaryLoop& loop : loops)
    if (loop.type == LoopType::ScanGap)
      report_.loops.push_back(loop);
  return Status::success();
}

Status
SpiralPlanner::makeLines(bool two, RadialLineSet& set)
{
  const BoundaryLoop* rim = &report_.loops.front();
  const BoundaryLoop* inner = nullptr;
  for (const BoundaryLoop& loop : report_.loops)
    if (loop.type == LoopType::Inner && (!inner || loop.length > inner->length))
      inner = &loop;
  if (two && !inner)
    return {StatusCode::Failed, "the second boundary was lost when gaps were bridged; refuse gaps to see them"};
  RadialLineRequest request{*surface_, *rim, two ? inner : nullptr, settings_.centre, settings_.start_point,
                            settings_.lines, 0.05, 0.2 * settings_.chord_error,
                            [this](double share) { return report(0.4 + 0.2 * share, "radial lines"); }};
  request.tolerance = 0.02 * std::sqrt(8.0 * settings_.scallop_height * settings_.tool_radius);
  if (const Status status = buildRadialLines(request, set); !status.ok())
    return status;
  report_.centre = set.centre;
  report_.harmonic_lines = set.harmonic;
  if (set.harmonic && settings_.lines == LineMethod::Automatic)
    report_.warnings.push_back("harmonic radial lines were used: " + set.why_harmonic);
  for (const RadialLine& line : set.lines) {
    Polyline points;
    for (std::size_t k = 0; k < line.feet.size(); k += 4)
      points.push_back(line.feet[k].position);
    report_.radial_lines.push_back(std::move(points));
  }
  return Status::success();
}

Status
SpiralPlanner::makeCurve(bool two, std::vector<SpiralPoint>& curve)
{
  RadialLineSet set;
  if (const Status status = makeLines(two, set); !status.ok())
    return status;
  graph_.dropTriangulation(); // the projection looks at neighbourhoods alone
  clock_.end("radial lines");
  if (!report(0.6, "spiral"))
    return {StatusCode::Cancelled, "cancelled"};
  TurnFunction turns(set.lines, settings_, graph_.spacing());
  if (const Status status = turns.compute(); !status.ok())
    return status;
  SpiralCurve spiral(set.lines, turns, settings_, graph_.spacing());
  spiral.setRim(set.rim, set.rim_corners);
  if (two)
    spiral.setInner(set.inner, set.inner_corners);
  curve = spiral.sample();
  report_.smallest_step_over = turns.smallestStepOver();
  report_.largest_step_over = turns.largestStepOver();
  report_.largest_allowed_step = spiral.largestAllowedStep();
  return Status::success();
}

Status
SpiralPlanner::putOnSurface(const std::vector<SpiralPoint>& curve, SpiralPath& path)
{
  const double hollowest = -1.0 / settings_.tool_radius;
  path.contacts.resize(curve.size());
  path.normals.resize(curve.size());
  path.turns.resize(curve.size());
  path.over_gap.resize(curve.size());
  std::vector<Eigen::Vector3d> queries;
  std::vector<SurfaceFoot> feet;
  for (std::size_t begin = 0; begin < curve.size(); begin += chunk) {
    const std::size_t end = std::min(curve.size(), begin + chunk);
    const auto count = static_cast<std::int64_t>(end - begin);
    queries.resize(end - begin);
    for (std::int64_t i = 0; i < count; ++i)
      queries[i] = curve[begin + i].position;
    surface_->project(queries, feet);
    std::int64_t first_bad = count;
#pragma omp parallel for schedule(static) reduction(min : first_bad)
    for (std::int64_t i = 0; i < count; ++i) {
      if (!feet[i].valid || feet[i].curvature2 <= hollowest)
        first_bad = std::min(first_bad, i);
      path.contacts[begin + i] = feet[i].position;
      path.normals[begin + i] = feet[i].normal;
      path.over_gap[begin + i] = isOverGap(feet[i]);
      path.turns[begin + i] = static_cast<float>(curve[begin + i].turn);
    }
    if (first_bad < count) {
      const SurfaceFoot& foot = feet[first_bad];
      const SpiralPoint& asked = curve[begin + first_bad];
      if (!foot.valid)
        return {StatusCode::Failed, text("the path leaves the scanned surface at ", at(asked.position), " in turn ",
                                         asked.turn, ": the scan has a gap or a ragged rim there")};
      return {StatusCode::Failed,
              text("the surface is hollow with radius ", -1.0 / foot.curvature2, " mm at ", at(foot.position),
                   ", tighter than the tool radius ", settings_.tool_radius,
                   " mm: the cutter would gouge; use a smaller tool")};
    }
    if (!report(0.65 + 0.25 * static_cast<double>(end) / static_cast<double>(curve.size()), "projection"))
      return {StatusCode::Cancelled, "cancelled"};
  }
  path.arc_lengths = arcLengths(path.contacts); // serial: a sum whose rounding depends on its order
  return reportGaps(path);
}

/** Whether there is no point of the scan near, but perhaps one that was put into a gap. */
bool
SpiralPlanner::isOverGap(const SurfaceFoot& foot) const
{
  return foot.nearest_distance > gap_in_spacings * graph_.spacing(foot.nearest) ||
         (!bridges_.empty() && source_.indices[graph_.blocks().originalIndex(foot.nearest)] >= first_bridge_);
}

Status
SpiralPlanner::reportGaps(const SpiralPath& path)
{
  for (std::size_t i = 0; i < path.contacts.size(); ++i) {
    report_.gap_points += path.over_gap[i];
    if (i > 0 && (path.over_gap[i - 1] || path.over_gap[i]))
      report_.gap_length += path.arc_lengths[i] - path.arc_lengths[i - 1];
    if (path.over_gap[i] && settings_.gaps == GapHandling::Refuse)
      return {StatusCode::InvalidInput, text("the scan has a gap at ", at(path.contacts[i]),
                                             ": no point of it lies near the path there; rescan it, or allow gaps to be bridged")};
  }
  if (report_.gap_points > 0)
    report_.warnings.push_back(text(report_.gap_points, " path points, ", report_.gap_length,
                                    " mm, lie over gaps of the scan, where the surface is a guess; they are marked"));
  return Status::success();
}

Status
SpiralPlanner::setAxes(SpiralPath& path)
{
  ToolAxisOptions options;
  options.side_tilt = radians(settings_.tilt_angle);
  options.lead = radians(settings_.lead_angle);
  options.max_rate = radians(settings_.max_axis_rate);
  ToolAxes axes = toolAxes(path.contacts, path.normals, options);
  const auto count = static_cast<std::int64_t>(axes.axes.size());
  path.axes.resize(axes.axes.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i)
    path.axes[i] = axes.axes[i].cast<float>();
  report_.largest_axis_change = axes.largest_change * 180.0 / M_PI;
  report_.limited_points = axes.limited_points;
  report_.largest_tilt_reduction = axes.largest_reduction * 180.0 / M_PI;
  if (axes.exceeded_moves > 0)
    report_.warnings.push_back(text("on ", axes.exceeded_moves, " of ", path.contacts.size() - 1,
                                    " moves the surface alone turns the tool axis faster than the largest axis rate of ",
                                    settings_.max_axis_rate, " degrees per mm: the axis follows the surface there; ",
                                    "slow the feed, or smooth the scan"));
  return Status::success();
}

Status
SpiralPlanner::checkPath(const SpiralPath& path)
{
  constexpr double slack = 1.05; // steps stretch a little when put on the surface
  for (std::size_t i = 1; i < path.contacts.size(); ++i) {
    const double gap = (path.contacts[i] - path.contacts[i - 1]).norm();
    report_.largest_gap = std::max(report_.largest_gap, gap);
    if (!(gap <= slack * report_.largest_allowed_step))
      return {StatusCode::Failed,
              text("the path jumps by ", gap, " mm at ", at(path.contacts[i]), " in turn ", path.turns[i],
                   ", above the longest step ", report_.largest_allowed_step,
                   " mm: the surface is too rough or too sparse there; scan more densely or raise the longest step")};
  }
  report_.turns = static_cast<std::size_t>(std::lround(std::abs(path.turns.back() - path.turns.front())));
  report_.path_points = path.contacts.size();
  report_.path_length = path.arc_lengths.back();
  // Turns that are not in order cross somewhere: each goes once round.
  if (const auto crossing = firstSelfCrossing(path.contacts, path.normals, settings_.chord_error))
    return {StatusCode::Failed,
            text("the path crosses itself at ", at(path.contacts[*crossing]), " in turn ", path.turns[*crossing],
                 ": the radial lines there are not in order; give another centre, or machine the part in pieces")};
  return Status::success();
}

Status
SpiralPlanner::plan(std::vector<Eigen::Vector3f> points, const std::vector<Eigen::Vector3f>& normals, SpiralPath& path)
{
  const Status cancelled(StatusCode::Cancelled, "cancelled");
  if (!report(0.05, "surface"))
    return cancelled;
  if (const Status status = makeGraph(std::move(points), normals); !status.ok())
    return status;
  if (const double across = graph_.blocks().box().diagonal(); across < settings_.tool_radius)
    return {StatusCode::InvalidInput, text("the whole scan is ", across, " mm across, less than the tool radius ",
                                           settings_.tool_radius, " mm: is the scan in metres or inches? Say its unit (--units m), or scale it to mm")};
  clock_.end("surface");
  if (!report(0.25, "boundaries"))
    return cancelled;
  if (const Status status = findLoops(); !status.ok())
    return status;
  if (const Status status = bridgeGaps(normals); !status.ok())
    return status;
  if (!graph_.orientationIsClear() && normals.empty())
    report_.warnings.push_back("the outer side could not be told from +z; the convex side was taken: give a view point "
                               "or flip the normals if the cutter comes from the other side");
  clock_.end("boundaries");
  if (!report(0.4, "radial lines"))
    return cancelled;
  const bool two = report_.boundaries == 2;
  if (two && settings_.centre)
    return {StatusCode::InvalidArgument, text("a centre was given, ", at(*settings_.centre), ", but the surface has two ",
                                              "boundaries: leave the centre out, or ask for one boundary")};
  {
    std::vector<SpiralPoint> curve;
    if (const Status status = makeCurve(two, curve); !status.ok())
      return status;
    clock_.end("spiral");
    if (const Status status = putOnSurface(curve, path); !status.ok())
      return status;
  }
  surface_.reset();
  graph_ = SurfaceGraph();
  clock_.end("projection");
  if (!report(0.9, "tool axis"))
    return cancelled;
  if (const Status status = setAxes(path); !status.ok())
    return status;
  if (const Status status = checkPath(path); !status.ok())
    return status;
  clock_.end("tool axis");
  return report(1.0, "done") ? Status::success() : cancelled;
}

} // namespace pcl_spiral
