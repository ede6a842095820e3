// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The path as lines over the part, in a picture or in the viewer.
 */
#pragma once

#include "part_view.h"

#include "shown_turns.h"

#include <cstdint>
#include <functional>

namespace pcl_spiral {

constexpr double least_turn_pitch = 4.0; ///< pixels between drawn turns; nearer turns cannot be seen apart
constexpr double least_path_move = 1.0;  ///< pixels between drawn points
constexpr Color over_gap_color{0.90, 0.15, 0.85};
constexpr Color path_start_color{0.10, 0.65, 0.20}, path_end_color{0.85, 0.05, 0.05};

inline Eigen::Vector3d
placeOf(const ToolpathPoint& point)
{
  return point.getVector3fMap().cast<double>();
}

inline Eigen::Vector3d
normalOf(const ToolpathPoint& point)
{
  return point.getNormalVector3fMap().cast<double>();
}

/** Part of a path as lines. */
struct PathLines {
  vtkSmartPointer<vtkPolyData> data;
  std::vector<std::uint32_t> points; ///< index of the path point for each point of the data
};

/** The longest move except lifts, mm: both ends of a move that crosses a view may be so far outside it. */
double longestMove(const pcl::PointCloud<ToolpathPoint>& path);

/** The runs of the path's passes for which \p shown is true, without the points nearer than \p least to the point
 * before. */
PathLines pathLines(const pcl::PointCloud<ToolpathPoint>& path, double least, const std::function<bool(const ToolpathPoint&)>& shown);

/** The lines coloured by turn. */
vtkSmartPointer<vtkActor> turnActor(const pcl::PointCloud<ToolpathPoint>& path, const PathLines& lines, vtkScalarsToColors* colors);

/** The surface, and the path coloured by turn: the points whose turn \p shows. */
void addPath(PartView& view, const pcl::PointCloud<ToolpathPoint>& path, const std::function<bool(double)>& shows,
             vtkScalarsToColors* colors);

/** The surface and the shown turns. Returns the legend entry. */
LegendEntry addSpiral(PartView& view, const pcl::PointCloud<ToolpathPoint>& path, const ShownTurns& turns, vtkScalarsToColors* colors);

/** The shown turns again where they run over bridged gaps of the scan; nothing without gaps. Adds an entry to the
 *  legend. */
void addOverGaps(PartView& view, const pcl::PointCloud<ToolpathPoint>& path, const ShownTurns& turns, std::vector<LegendEntry>& legend);

/** Marks at the start and end of the path. Returns their legend entries. */
std::vector<LegendEntry> markEnds(PartView& view, const pcl::PointCloud<ToolpathPoint>& path);

} // namespace pcl_spiral
