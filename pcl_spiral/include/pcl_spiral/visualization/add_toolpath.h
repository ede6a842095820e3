// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A toolpath, its loops and its radial lines in your own pcl::visualization::PCLVisualizer.
 *
 *  Header only. The program that includes it must link PCL's visualization, which no library of pcl_spiral
 *  needs: find_package(PCL REQUIRED COMPONENTS visualization), then pcl_visualization among its libraries.
 */
#pragma once

#include <pcl_spiral/common/point_types.h>
#include <pcl_spiral/spiral/radial_line.h>
#include <pcl_spiral/visualization/impl/colored_lines.h>

#include <pcl/point_cloud.h>
#include <pcl/visualization/pcl_visualizer.h>

#include <vtkActor.h>
#include <vtkProperty.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace pcl_spiral {

/** From blue, at 0, through green to yellow, at 1: visible on a dark and on a light background. */
inline Color
turnColor(double share)
{
  constexpr Color steps[] = {{0.20, 0.45, 0.95}, {0.10, 0.70, 0.55}, {0.80, 0.80, 0.10}};
  const int k = share < 0.5 ? 0 : 1;
  const double t = 2.0 * share - k;
  Color color{};
  for (std::size_t i = 0; i < color.size(); ++i)
    color[i] = (1.0 - t) * steps[k][i] + t * steps[k + 1][i];
  return color;
}

/** Gray. */
constexpr Color radial_line_color{0.55, 0.55, 0.58};

namespace detail {

/** The value of a registered field; \p otherwise if the type has none. */
template <typename Field, typename PointT>
double
fieldOr(const PointT& point, double otherwise)
{
  if constexpr (pcl::traits::has_field<PointT, Field>::value) {
    typename pcl::traits::datatype<PointT, Field>::type value{};
    pcl::getFieldValue(point, pcl::traits::offset<PointT, Field>::value, value);
    return static_cast<double>(value);
  }
  return otherwise;
}

/** One line per pass, coloured by turn. */
template <typename PointT>
ColoredLines
pathLines(const pcl::PointCloud<PointT>& path)
{
  const auto turn = [](const PointT& point) { return fieldOr<pcl::fields::turn>(point, 0.0); };
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const PointT& point : path)
    if (std::isfinite(turn(point))) {
      low = std::min(low, turn(point));
      high = std::max(high, turn(point));
    }
  const auto arc = [](const PointT& point) { return fieldOr<pcl::fields::arc_length>(point, 0.0); };
  const bool measured = !path.empty() && arc(path.back()) > arc(path.front());
  ColoredLines lines;
  const auto place = [](const PointT& point) { return Eigen::Vector3d(point.x, point.y, point.z); };
  const PointT* before = nullptr;
  for (const PointT& point : path) {
    if (measured && before && isLift((place(point) - place(*before)).norm(), arc(point) - arc(*before)))
      lines.end(false);
    before = &point;
    const double share = high > low && std::isfinite(turn(point)) ? (turn(point) - low) / (high - low) : 0.0;
    const bool guessed = fieldOr<pcl::fields::over_gap>(point, 0.0) != 0.0;
    lines.add(place(point), guessed ? loopColor(LoopType::ScanGap) : turnColor(share));
  }
  lines.end(false);
  return lines;
}

inline ColoredLines
loopLines(const std::vector<BoundaryLoop>& loops)
{
  ColoredLines lines;
  for (const BoundaryLoop& loop : loops) {
    for (const Eigen::Vector3d& place : loop.curve.empty() ? loop.points : loop.curve)
      lines.add(place, loopColor(loop.type));
    lines.end(true);
  }
  return lines;
}

inline void
addLine(ColoredLines& lines, const Polyline& line)
{
  for (const Eigen::Vector3d& place : line)
    lines.add(place, radial_line_color);
  lines.end(false);
}

inline void
addLine(ColoredLines& lines, const RadialLine& line)
{
  for (const SurfaceFoot& foot : line.feet)
    lines.add(foot.position, radial_line_color);
  lines.end(false);
}

/** Adds the lines as one shape, bright in every view. No shape if there are no lines. */
inline bool
showLines(pcl::visualization::PCLVisualizer& viewer, const ColoredLines& lines, double width, const std::string& shape, int viewport)
{
  if (lines.empty() || !viewer.addModelFromPolyData(lines.data(), shape, viewport))
    return false;
  if (auto* const actor = vtkActor::SafeDownCast(viewer.getShapeActorMap()->at(shape))) {
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  }
  return true;
}

} // namespace detail

/** Removes what addToolpath added under this id, from every viewport; no effect if there is nothing. */
inline void
removeToolpath(pcl::visualization::PCLVisualizer& viewer, const std::string& id = "toolpath")
{
  for (const char* const part : {"_path", "_loops", "_lines"})
    if (viewer.getShapeActorMap()->count(id + part) != 0)
      viewer.removeShape(id + part);
}

/** Shows a toolpath with its boundary loops and radial lines.
 *
 *  At most three shapes, each one actor for any number of lines; empty ones are left out:
 *
 *  | shape | what | colour | width, pixels |
 *  |---|---|---|---|
 *  | ID_path | the path as one line a pass | by turn, see turnColor; over bridged gaps magenta | 1.5 |
 *  | ID_loops | a closed line a loop, its curve where it has one | by type, see loopColor | 3 |
 *  | ID_lines | a line a radial line | gray | 1 |
 *
 *  Use these names in PCLVisualizer::setShapeRenderingProperties for other widths, colours, or opacity.
 *  Points that are not finite are skipped, and the line goes straight to the next point. What was shown
 *  under the id before is replaced; the camera does not move. PCLVisualizer itself ends the program if
 *  there is no display: call displayFault of pcl_spiral/visualization/pictures.h before you make one.
 *
 *  \tparam PathPointT a registered point type; without a field turn
 *  it is drawn in one colour, without over_gap it shows no gaps
 *  \tparam LineT RadialLine, as from RadialLines, or Polyline, as in SpiralReport
 *  \param[in,out] viewer your viewer; call from the thread that made it
 *  \param[in] path,loops,lines lengths in the unit of everything else in the viewer
 *  \param[in] id a name for the three shapes
 *  \param[in] viewport from PCLVisualizer::createViewPort; 0 for all
 *  \return whether there was anything to show */
template <typename PathPointT, typename LineT = RadialLine>
bool
addToolpath(pcl::visualization::PCLVisualizer& viewer, const pcl::PointCloud<PathPointT>& path, const std::vector<BoundaryLoop>& loops = {},
            const std::vector<LineT>& lines = {}, const std::string& id = "toolpath", int viewport = 0)
{
  removeToolpath(viewer, id);
  ColoredLines radial;
  for (const LineT& line : lines)
    detail::addLine(radial, line);
  const bool lines_shown = detail::showLines(viewer, radial, 1.0, id + "_lines", viewport);
  const bool loops_shown = detail::showLines(viewer, detail::loopLines(loops), 3.0, id + "_loops", viewport);
  const bool path_shown = detail::showLines(viewer, detail::pathLines(path), 1.5, id + "_path", viewport);
  return lines_shown || loops_shown || path_shown;
}

} // namespace pcl_spiral
