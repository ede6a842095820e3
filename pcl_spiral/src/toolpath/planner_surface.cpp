// From points to a surface and its boundaries.
#include <pcl_spiral/toolpath/spiral_planner.h>

#include <pcl_spiral/common/message.h>
#include <pcl_spiral/features/surface_boundary.h>
#include <pcl_spiral/features/surface_parts.h>
#include <pcl_spiral/surface/clean_graph.h>
#include <pcl_spiral/surface/gap_filling.h>
#include <pcl_spiral/toolpath/boundary_choice.h>
#include <pcl_spiral/toolpath/path_size.h>
#include <pcl_spiral/toolpath/scan_warnings.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pcl_spiral {
namespace {

constexpr double two_sheets_scatter = 0.35; // of the spacing: more is no surface
constexpr double most_strays = 0.1;         // of all points: more are no outliers
constexpr double hopeless = 10.0;           // times the most path points that the area alone may ask for

/** The point that lies farthest off the surface, of some hundreds, and how far. */
std::pair<Eigen::Vector3d, double>
farthestOff(const MlsSurface& surface)
{
  constexpr std::size_t samples = 500;
  const SurfaceGraph& graph = surface.graph();
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < graph.size(); i += std::max<std::size_t>(1, graph.size() / samples))
    places.push_back(graph.position(i));
  std::vector<SurfaceFoot> feet;
  surface.project(places, feet);
  std::pair<Eigen::Vector3d, double> farthest{places.front(), 0.0};
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const double off = (feet[i].position - places[i]).norm(); feet[i].valid && off > farthest.second)
      farthest = {places[i], off};
  return farthest;
}

} // namespace

Status
SpiralPlanner::makeGraph(std::vector<Eigen::Vector3f> points, std::vector<Eigen::Vector3f> normals)
{
  SurfaceGraphOptions options;
  options.view_point = settings_.view_point;
  options.flip_normals = settings_.flip_normals;
  options.given_normals = std::move(normals);
  const std::size_t given = points.size();
  // With points put into gaps nothing more is left out: what was counted and told before stays true.
  const Status built = bridges_.empty() ? buildCleanGraph(std::move(points), options, graph_, source_)
                                        : graph_.build(std::move(points), options);
  if (!built.ok())
    return built;
  if (!bridges_.empty()) {
    source_ = GraphSource();
    source_.indices.resize(given);
    std::iota(source_.indices.begin(), source_.indices.end(), 0u);
  }
  const Box box = graph_.blocks().box();
  const Eigen::Vector3d middle = 0.5 * (Eigen::Map<const Eigen::Vector3f>(box.low.data()).cast<double>() +
                                        Eigen::Map<const Eigen::Vector3f>(box.high.data()).cast<double>());
  if (static_cast<double>(source_.strays.size()) > most_strays * static_cast<double>(given))
    return {StatusCode::InvalidInput,
            textOf(source_.strays.size(), " of ", given, " points stand alone, far off the densest part of the cloud, which lies about ",
                   placeText(middle), ", is ", box.diagonal(), " mm across and has a point every ", graph_.spacing(),
                   " mm: the scan does not hang together; leave that part out, or thin the cloud to an even spacing "
                   "(--thin)")};
  strays_ += source_.strays.size();
  if (bridges_.empty())
    report_.surplus_points += source_.surplus;
  surface_ = std::make_unique<MlsSurface>(graph_);
  report_.spacing = graph_.spacing();
  report_.noise = surface_->noise();
  report_.projection_neighbours = surface_->neighbours();
  if (surface_->noise() > two_sheets_scatter * graph_.spacing()) {
    const auto [place, off] = farthestOff(*surface_);
    return {StatusCode::InvalidInput,
            textOf("the points scatter by ", surface_->noise(), " mm about a local surface, by ", off, " mm at ",
                   placeText(place), ", against a spacing of ", graph_.spacing(),
                   " mm: this is no single sheet (a thin double wall, or noise above the point spacing); of a wall leave one "
                   "side in the cloud, with mere noise thin it to a spacing well above (--thin ",
                   4.0 * surface_->noise(), ")")};
  }
  return Status::success();
}

Status
SpiralPlanner::checkScale()
{
  const double across = graph_.blocks().box().diagonal();
  if (across < settings_.tool_radius)
    return {StatusCode::InvalidInput,
            textOf("the whole scan is ", across, " mm across, less than the tool radius ", settings_.tool_radius,
                   " mm: is the scan in metres or inches? Say its unit (--units m), or scale it to mm")};
  const double area = surfaceArea(graph_);
  for (const std::string& warning : scanWarnings(graph_, settings_))
    report_.warnings.push_back(warning);
  return checkPathSize(roughPathSize(area, settings_), area, settings_, hopeless * most_path_points);
}

Status
SpiralPlanner::keepLargestPart()
{
  SurfaceParts found = surfaceParts(graph_);
  if (!settings_.largest_part || found.parts.size() < 2)
    return Status::success();
  const auto largest = std::max_element(found.parts.begin(), found.parts.end(),
                                        [](const SurfacePart& a, const SurfacePart& b) { return a.area < b.area; });
  const auto kept = static_cast<std::size_t>(largest - found.parts.begin());
  const std::vector<std::uint8_t> apart = apartFrom(graph_, found, kept);
  report_.left_out_parts = found.parts.size() - 1;
  report_.left_out_points = static_cast<std::size_t>(std::count(apart.begin(), apart.end(), 1));
  const SurfaceParts all = found;
  const SurfacePart part = found.parts[kept];
  found.parts.erase(largest);
  report_.warnings.push_back(textOf("of ", report_.left_out_parts + 1, " separate parts the largest was kept, ",
                                    partsText({part}), "; left out with ", report_.left_out_points,
                                    " points: ", partsText(found.parts)));
  return keepPart(all, kept);
}

Status
SpiralPlanner::keepPart(const SurfaceParts& parts, std::size_t part)
{
  const std::vector<std::uint8_t> apart = apartFrom(graph_, parts, part);
  std::vector<Eigen::Vector3f> points, normals;
  for (std::size_t i = 0; i < graph_.size(); ++i) {
    if (apart[i])
      continue;
    points.push_back(graph_.blocks().point(i));
    if (!normals_.empty())
      normals.push_back(normals_[source_.indices[graph_.blocks().originalIndex(i)]]);
  }
  normals_ = normals;
  return makeGraph(std::move(points), std::move(normals));
}

Status
SpiralPlanner::findLoops(double from, double to)
{
  BoundaryCounts counts;
  BoundaryOptions options;
  options.progress = [&](double share) { return report(from + share * (to - from), "boundaries"); };
  if (const Status status = findBoundaryLoops(*surface_, options, report_.loops, &counts); !status.ok())
    return status;
  if (!bridges_.empty())
    return Status::success();
  if (counts.left_out_points > 0) { // they would bend the surface that is fitted near them
    if (const Status status = keepPart(surfaceParts(graph_), 0); !status.ok())
      return status;
    if (const Status status = findBoundaryLoops(*surface_, options, report_.loops); !status.ok())
      return status;
  }
  reportStrays(counts);
  return Status::success();
}

void
SpiralPlanner::reportStrays(const BoundaryCounts& counts)
{
  const std::size_t dropped = strays_ + counts.left_out_points;
  report_.outlier_points += dropped;
  report_.used_points -= dropped + report_.surplus_points + report_.left_out_points;
  if (report_.surplus_points > 0)
    report_.warnings.push_back(textOf(report_.surplus_points, " points were left out where they lie much closer together ",
                                      "than to the next scan line or the sparser part beside them: the path follows the ",
                                      "others, ", graph_.spacing(), " mm apart"));
  if (dropped == 0)
    return;
  std::string message = textOf(dropped, dropped == 1 ? " point" : " points", " off the surface ",
                               dropped == 1 ? "was" : "were", " left out: ");
  if (strays_ > 0)
    message += textOf(strays_, strays_ == 1 ? " that stands alone" : " that stand alone");
  if (counts.left_out_points > 0)
    message += textOf(strays_ > 0 ? ", " : "", counts.left_out_points, " in specks apart from it");
  report_.warnings.push_back(message);
}

Status
SpiralPlanner::bridgeGaps()
{
  BoundaryChoice choice;
  if (const Status status = chooseBoundaries(report_.loops, settings_.boundary_mode, choice); !status.ok())
    return status;
  const bool two = choice.inner;
  report_.boundaries = two ? 2 : 1;
  const std::vector<BoundaryLoop> loops = report_.loops;
  std::vector<BoundaryLoop> bridged;
  bool kept_hole = !two;
  for (const BoundaryLoop& loop : loops) {
    if (loop.type == LoopType::Outer)
      continue;
    if (loop.type == LoopType::Inner && !kept_hole) {
      kept_hole = true;
      continue;
    }
    if (settings_.gaps == GapHandling::Refuse)
      return {StatusCode::InvalidInput, textOf("the scan has a gap at ", placeText(loop.points.front()), ", ", loop.length,
                                               " mm round: rescan it, or allow gaps to be bridged")};
    const GapFill fill = fillGap(graph_, loop.points);
    bridged.push_back(loop);
    bridged.back().type = LoopType::ScanGap;
    bridges_.insert(bridges_.end(), fill.points.begin(), fill.points.end());
    report_.warnings.push_back(
        fill.points.empty()
            ? textOf("a gap in the scan at ", placeText(loop.points.front()), ", ", loop.length,
                     " mm round, is too narrow to be filled: the path runs over it as it is")
            : textOf("a gap in the scan at ", placeText(fill.centre), ", ", fill.width,
                     " mm wide, was bridged by a smooth patch; the points about it lie ", fill.residual,
                     " mm (rms) from it; a real hole there is ridden over like the rest"));
  }
  if (bridges_.empty())
    return Status::success();
  std::vector<Eigen::Vector3f> points = graph_.blocks().points(), known;
  for (std::size_t i = 0; !normals_.empty() && i < points.size(); ++i)
    known.push_back(normals_[source_.indices[graph_.blocks().originalIndex(i)]]);
  first_bridge_ = points.size();
  points.insert(points.end(), bridges_.begin(), bridges_.end());
  known.resize(normals_.empty() ? 0 : points.size(), Eigen::Vector3f::Zero());
  if (const Status status = makeGraph(std::move(points), std::move(known)); !status.ok())
    return status;
  if (const Status status = findLoops(0.35, 0.4); !status.ok())
    return status;
  // The gaps that were bridged stay in the report.
  report_.loops.insert(report_.loops.end(), bridged.begin(), bridged.end());
  return Status::success();
}

} // namespace pcl_spiral
