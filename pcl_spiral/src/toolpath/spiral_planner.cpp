#include <pcl_spiral/toolpath/spiral_planner.h>

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/surface/noise_warning.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

SpiralPlanner::SpiralPlanner(const SpiralSettings& settings, ProgressCallback progress, SpiralReport& report,
                             StageClock& clock)
: settings_(settings), progress_(std::move(progress)), report_(report), clock_(clock)
{
}

namespace {

/** Of ridges that rise higher at corners than asked for; empty where they do not. */
std::string
cornerWarning(const CornerRidge& ridge, const SpiralSettings& settings)
{
  constexpr double much = 1.05; // times the scallop height
  const double height = settings.scallop_height;
  if (ridge.height <= much * height)
    return {};
  const std::string left = ridge.height < settings.tool_radius
                               ? textOf("ridges rise to ", ridge.height, " mm, above the scallop height of ", height, " mm")
                               : "material is left uncut";
  return textOf("towards the corner of the outline at ", placeText(ridge.corner),
                " turns lie farther apart than along its sides: ", left, "; a path for a scallop height of ", ridge.remedy,
                " mm, longer, leaves about ", height, " mm there");
}

} // namespace

bool
SpiralPlanner::report(double share, const std::string& stage)
{
  return !progress_ || progress_(share, stage);
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
  if (const Status status = checkPathSize(turns.pathSize(), surfaceArea(graph_), settings_); !status.ok())
    return status;
  SpiralCurve spiral(set.lines, turns, settings_, graph_.spacing());
  spiral.setRim(set.rim, set.rim_corners);
  if (two)
    spiral.setInner(set.inner, set.inner_corners);
  curve = spiral.sample();
  report_.smallest_step_over = turns.smallestStepOver();
  report_.largest_step_over = turns.largestStepOver();
  const CornerRidge ridge = turns.highestCornerRidge();
  report_.corner_ridge = ridge.height;
  if (const std::string warning = cornerWarning(ridge, settings_); !warning.empty())
    report_.warnings.push_back(warning);
  report_.largest_allowed_step = spiral.largestAllowedStep();
  return Status::success();
}

Status
SpiralPlanner::prepareSurface(std::vector<Eigen::Vector3f> points, std::vector<Eigen::Vector3f> normals)
{
  if (!report(0.05, "surface"))
    return {StatusCode::Cancelled, "cancelled"};
  normals_ = normals;
  if (const Status status = makeGraph(std::move(points), std::move(normals)); !status.ok())
    return status;
  if (settings_.largest_part)
    if (const Status status = keepLargestPart(); !status.ok())
      return status;
  return checkScale();
}

Status
SpiralPlanner::prepareBoundaries()
{
  if (!report(0.25, "boundaries"))
    return {StatusCode::Cancelled, "cancelled"};
  if (const Status status = findLoops(0.25, 0.35); !status.ok())
    return status;
  if (const Status status = bridgeGaps(); !status.ok())
    return status;
  if (const auto warning = noiseWarning(*surface_, "scallop height", settings_.scallop_height))
    report_.warnings.push_back(*warning);
  if (!graph_.orientationIsClear() && normals_.empty())
    report_.warnings.push_back("the outer side could not be told from +z; the convex side was taken: give a view point "
                               "or flip the normals if the cutter comes from the other side");
  if (report_.boundaries == 2 && settings_.centre)
    return {StatusCode::InvalidArgument, textOf("a centre was given, ", placeText(*settings_.centre),
                                                ", but the surface has two boundaries: leave the centre out, or ask for "
                                                "one boundary")};
  return Status::success();
}

Status
SpiralPlanner::plan(std::vector<Eigen::Vector3f> points, std::vector<Eigen::Vector3f> normals, SpiralPath& path)
{
  const Status cancelled(StatusCode::Cancelled, "cancelled");
  if (const Status status = prepareSurface(std::move(points), std::move(normals)); !status.ok())
    return status;
  clock_.end("surface");
  if (const Status status = prepareBoundaries(); !status.ok())
    return status;
  clock_.end("boundaries");
  if (!report(0.4, "radial lines"))
    return cancelled;
  {
    std::vector<SpiralPoint> curve;
    if (const Status status = makeCurve(report_.boundaries == 2, curve); !status.ok())
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
  if (!report(0.95, "tool axis"))
    return cancelled;
  if (const Status status = checkPath(path); !status.ok())
    return status;
  clock_.end("tool axis");
  return report(1.0, "done") ? Status::success() : cancelled;
}

} // namespace pcl_spiral
