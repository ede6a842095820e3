// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cleaning/impl/closed_view.h>

#include "closed_sheets.h"
#include "closing_grid.h"
#include "core/median.h"
#include "graph/local_shape.h"
#include "search/neighbour_search.h"
#include "search/pieces.h"

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/impl/frame.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double cell_spacings = 0.4;   // nodes between the points, so that what the closing makes of one point is seen
constexpr double cells_per_radius = 25; // no more are needed: the ball bends by a 5000th of its radius in a cell
constexpr double most_nodes = 1e8;      // 2.8 GB at 28 bytes a node
constexpr int few = 8;                  // neighbours that tell the spacing

/** Median distance of neighbouring points, as if they were spread evenly. */
double
usualSpacing(const std::vector<Eigen::Vector3f>& points)
{
  const PointBlocks blocks(points);
  const std::size_t step = std::max<std::size_t>(1, blocks.blockCount() / 1024);
  NeighbourSearch search(blocks, few);
  std::vector<float> squared;
  for (std::size_t b = 0; b < blocks.blockCount(); b += step) {
    search.setRun(blocks.blockBox(b));
    for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i) {
      const Neighbourhood& near = search.find(blocks.position(i));
      squared.push_back(near.squared_distance[near.size - 1]);
    }
  }
  return evenSpacing(std::sqrt(static_cast<double>(medianOf(std::move(squared)))), few);
}

/** The nodes of the sheets. */
std::vector<Eigen::Vector3f>
nodesOf(const ClosingGrid& grid, const std::vector<std::uint32_t>& sheets, const HeightGrid& frame)
{
  std::vector<Eigen::Vector3f> points;
  for (std::int64_t row = 0; row < grid.rows(); ++row)
    for (std::int64_t column = 0; column < grid.columns(); ++column)
      if (const std::size_t node = grid.node(column, row); sheets[node] != 0)
        points.push_back(frame.outside({grid.u(column), grid.v(row), grid.height(node)}).cast<float>());
  return points;
}

/** Points that lie deeper under \p grid than a cell. */
std::size_t
countCovered(const DropBall& ball, const ClosingGrid& grid)
{
  return static_cast<std::size_t>(sumOverPoints(ball.points().size(), 0.0, [&](std::uint32_t i, double& covered) {
    const Eigen::Vector3d& p = ball.points()[i];
    covered += grid.lowestAbout(p.x(), p.y()) > p.z() + grid.cell() ? 1.0 : 0.0;
  }));
}

void
setFrame(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& along, HeightGrid& grid)
{
  Eigen::Vector3d e1, e2;
  tangentFrame(along, e1, e2);
  grid.axes << e1, e2, along;
  grid.origin = middleOf(points);
}

std::vector<Eigen::Vector3d>
insideOf(const HeightGrid& grid, const std::vector<Eigen::Vector3f>& points)
{
  std::vector<Eigen::Vector3d> inside(points.size());
  forPoints(points.size(), [&](std::uint32_t i) { inside[i] = grid.inside(points[i].cast<double>()); });
  return inside;
}

/** Refuses points, in the frame of the grid, so far apart that it would have too many nodes. */
Status
checkSize(const std::vector<Eigen::Vector3d>& inside, double radius, const ClosedView& view)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : inside)
    box.extend(p);
  const Eigen::Array2d nodes = (box.sizes().head<2>().array() + 4.0 * radius) / view.grid.cell;
  if (nodes.prod() <= most_nodes)
    return Status::success();
  return {StatusCode::InvalidInput,
          Diagnostic("the points of the {scan} lie ", box.sizes().x(), " by ", box.sizes().y(), " {mm} apart across the tool axis, ",
                     view.spacing, " {mm} from one to the next: such a grid would have ", nodes.prod(), " nodes, and at most ", most_nodes,
                     " are possible; leave points far away out of the file, or take a larger ball ({setToolRadius})")};
}

} // namespace

Eigen::Vector3d
middleOf(const std::vector<Eigen::Vector3f>& points)
{
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : points)
    box.extend(p);
  return box.center().cast<double>();
}

Status
closeByBall(const std::vector<Eigen::Vector3f>& points, const std::vector<Eigen::Vector3f>& obstacles, const Eigen::Vector3d& along,
            double radius, double rounding, ClosedView& view)
{
  view = ClosedView();
  if (points.size() < SurfaceGraph::fewest_points)
    return {StatusCode::InvalidInput, Diagnostic("the {cloud} has ", points.size(), " usable points; a surface needs at least ",
                                                 SurfaceGraph::fewest_points, ": {scan more densely}")};
  view.spacing = usualSpacing(points);
  if (!(radius > view.spacing))
    return {StatusCode::InvalidArgument,
            Diagnostic("the tool radius ", radius, " {mm} is not larger than the point spacing, ", view.spacing,
                       " {mm}: a ball would fall between the points; take a larger ball ({setToolRadius}), or {scan more densely}")};
  setFrame(points, along, view.grid);
  view.grid.cell = std::max(cell_spacings * view.spacing, radius / cells_per_radius);
  view.grid.reached_by = radius - rounding;
  std::vector<Eigen::Vector3d> inside = insideOf(view.grid, points), all = insideOf(view.grid, obstacles);
  all.insert(all.end(), inside.begin(), inside.end());
  if (const Status status = checkSize(all, radius, view); !status.ok())
    return status;
  const auto own = std::make_shared<const DropBall>(std::move(inside), radius);
  view.ball = obstacles.empty() ? own : std::make_shared<const DropBall>(std::move(all), radius);
  ClosingGrid grid(*own, view.grid.cell);
  if (!obstacles.empty())
    grid.leaveOut(ClosingGrid(*view.ball, view.grid.cell));
  view.covered = countCovered(*own, grid);
  const std::vector<std::uint32_t> sheets = closedSheets(grid, radius);
  if (rounding > 0.0)
    grid.offset(rounding);
  view.points = nodesOf(grid, sheets, view.grid);
  if (view.points.size() >= SurfaceGraph::fewest_points)
    return Status::success();
  return {StatusCode::InvalidInput, Diagnostic("a ball of radius ", radius,
                                               " {mm} that comes from the side of the sensor reaches no surface as wide as itself: take "
                                               "a smaller ball ({setToolRadius}), or scan from another side")};
}

} // namespace pcl_spiral
