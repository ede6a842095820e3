// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What the checks of a path find: deviation, material left and cut, collisions of leads.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/core/tool_holder.h>
#include <pcl_spiral/machine/machine_program.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_spiral {

/** A measured value and where it was found. */
struct PlacedValue {
  double value = 0.0;                                 ///< in the unit of the figure
  Eigen::Vector3d position = Eigen::Vector3d::Zero(); ///< where it was found, mm
  std::size_t index = 0;                              ///< of the path point, or of the first point of the move
};

/** How the path moves between lifts. Angles in degrees. */
struct PathMotion {
  double length = 0.0;       ///< mm
  std::size_t lifts = 0;     ///< between passes, without cutting
  double lift_length = 0.0;  ///< mm
  PlacedValue gap;           ///< longest move, mm
  PlacedValue turn;          ///< largest angle between neighbouring moves
  PlacedValue axis_change;   ///< largest angle between neighbouring axes; 0 without axes
  PlacedValue normal_change; ///< largest angle between neighbouring normals
};

/** Unevenness of neighbouring turns, mm. At a contact of turn t with the deviation d (along the surface normal,
 *  positive out of the material) it is d(t) - (d(t - 1) + d(t + 1)) / 2: half the second difference across the
 *  feed. The deviations of the neighbouring turns are taken at the same share of a turn, between their two nearest
 *  contacts. An error that is the same on all turns, or changes evenly across them, gives no wobble. Independent
 *  errors of standard deviation s give a wobble of 1.22 s rms. If the deviation is measured from a scan, path and
 *  reference may share the same noise, and that part does not show: judge by a second scan to see it. */
struct TurnWobble {
  std::size_t measured = 0; ///< contacts with a measured deviation on their turn and on both neighbouring turns
  double rms = 0.0;         ///< of all measured contacts
  PlacedValue max;          ///< the largest in absolute value, with its sign
};

/** Figures of a path against a scan or a mesh. Lengths in mm, angles in degrees. */
struct DeviationReport {
  std::size_t points = 0;           ///< of the path
  std::size_t measured = 0;         ///< points with data of the scan around them: the figures are for these
  std::size_t beyond_rim = 0;       ///< just outside the outermost points; measured against the extended surface
  std::size_t unmeasured = 0;       ///< no surface there
  double rms = 0.0;                 ///< of the deviation
  double p99 = 0.0;                 ///< 99th percentile of the absolute deviation
  PlacedValue max;                  ///< the largest in absolute value, with its sign: positive out of the material
  PlacedValue rim_max;              ///< the same for the points beyond the rim
  std::size_t in_gaps = 0;          ///< in gaps of the scan, where there is no data to judge by
  PlacedValue gap_max;              ///< near the border of a gap: the largest distance from the extended surface
  std::size_t in_crease_band = 0;   ///< within crease_band of a crease of the mesh, where a fit rounds it; not part of the other figures
  double crease_band = 0.0;         ///< see ReferenceSurface::creaseBand
  PlacedValue crease_max;           ///< the largest distance of these from the rounded fit, with its sign; not a verdict
  std::size_t lifted = 0;           ///< off the surface by their own account (ToolpathPoint::lift); not part of the other figures
  PlacedValue lift_max;             ///< the largest of these lifts; no verdict: gouges and stock show whether it is right
  PlacedValue normal_error;         ///< largest angle between the path's normal and the surface's
  double normal_p99 = 0.0;          ///< 99th percentile of that angle
  std::size_t opposed = 0;          ///< points whose normal points into the material
  PlacedValue first_opposed;        ///< the first of these
  std::size_t inward_axes = 0;      ///< points whose tool axis points into the material: the shank would go there
  PlacedValue first_inward;         ///< the first of these
  TurnWobble wobble;                ///< of the deviation, from turn to turn
  PathMotion motion;                ///< how the path moves
  std::size_t reference_points = 0; ///< of the scan, or samples of the mesh
  bool by_mesh = false;             ///< the reference points are samples of a mesh; false: a scan
  double noise = 0.0;               ///< see ReferenceSurface::noise
  double fit_noise = 0.0;           ///< see ReferenceSurface::fitNoise; deviations below three times this are not known
  double seconds = 0.0;             ///< wall time of the measurement
  Diagnostics warnings;             ///< in full sentences, with the remedy
};

/** \deprecated Use DeviationReport. */
using DeviationFigures [[deprecated("use DeviationReport")]] = DeviationReport;

/** Heights above the surface, one value per place. */
struct StockReport {
  std::size_t samples = 0;  ///< places with a height
  std::size_t uncut = 0;    ///< samples without anything met within the reach; their height is then the reach
  double p50 = 0.0;         ///< median height, mm
  double p90 = 0.0;         ///< 90th percentile
  double p99 = 0.0;         ///< 99th percentile
  double p999 = 0.0;        ///< 99.9th percentile
  PlacedValue max;          ///< the largest height
  PlacedValue first_uncut;  ///< the first place where nothing was met
  double share_above = 0.0; ///< of the samples, above RemovalReport::limit
  /** Share of the samples that are uncut. */
  double uncutShare() const { return samples ? static_cast<double>(uncut) / static_cast<double>(samples) : 0.0; }
};

/** \deprecated Use StockReport. */
using StockFigures [[deprecated("use StockReport")]] = StockReport;

/** Figures of a path from what its cutter leaves. Indices are those of path points. */
struct RemovalReport {
  std::size_t reference_points = 0; ///< of the scan, or samples of the mesh
  std::size_t unmeasured = 0;       ///< reference points without a fit of the surface
  StockReport stock;                ///< at the reference points farther than one step-over from the rim
  StockReport scallop;    ///< at the tops of the ridges next to these points; max also next to every path point and between path points
  StockReport rim;        ///< at the reference points within one step-over of the rim
  PlacedValue gouge;      ///< deepest, at reference points and along every move; 0 if there is none
  PlacedValue rim_gouge;  ///< the same at the rim, just outside the outermost points; not looked for in gaps
  PlacedValue face_depth; ///< of a mesh: deepest below its flat faces as they are, off its creases; hollow curved faces lie below them
  PlacedValue face_gouge; ///< how much of such a depth is the most that the bends between the faces do not explain, see bendDepth
  StockReport unreached;  ///< at the reference points that a ball of this radius does not reach, and within one spacing of them. Not
                          ///< part of the other figures
  double fitting_radius = 0.0; ///< of the largest ball that reaches everything, at most that of the tool; mm
  StockReport crease;          ///< at the reference points within crease_band of a crease of the mesh, above the mesh
                               ///< itself. Not part of the other figures: a ball leaves stock in every hollow crease
  PlacedValue crease_gouge;    ///< the deepest there
  double crease_band = 0.0;    ///< see ReferenceSurface::creaseBand
  double limit = 0.0;          ///< 1.02 scallop heights plus the chord error
  double reach = 0.0;          ///< as used
  double area = 0.0;           ///< mm^2
  double rim_length = 0.0;     ///< mm
  double least_length = 0.0;   ///< mm: no path that cuts the same places to this scallop height is much shorter
  double path_length = 0.0;    ///< mm
  double efficiency = 0.0;     ///< eta = least_length / path_length
  double noise = 0.0;          ///< see ReferenceSurface::noise
  double fit_noise = 0.0;      ///< see ReferenceSurface::fitNoise; heights below three times this are not known
  double seconds = 0.0;        ///< wall time of the measurement
  Diagnostics warnings;        ///< in full sentences, with the remedy
};

/** \deprecated Use RemovalReport. */
using RemovalFigures [[deprecated("use RemovalReport")]] = RemovalReport;

/** A place where the tool would be in the scan. Lengths in mm. */
struct LeadCollision {
  ToolPart part = ToolPart::Cutter;              ///< that collides
  BlockSection section = BlockSection::Position; ///< purpose of the move; Cut from HolderCheck
  std::size_t block = 0;                         ///< of the program: the end of the move; of passes: the pose there, over all passes
  int segment = -1;                              ///< of the holder, from the cutter upwards; -1: none
  double depth = 0.0; ///< of the point in the tool; for cutter and shank the shorter way out, along the axis or across it
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< the point of the scan
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();   ///< of the tool, in that place of the move
};

/** What LeadCheck or HolderCheck found. */
struct LeadReport {
  std::size_t moves = 0;           ///< moves looked at: those that do not cut, or of HolderCheck those that do
  std::size_t collided = 0;        ///< number of these moves with a collision
  LeadCollision deepest;           ///< if there is one
  std::vector<std::size_t> blocks; ///< of LeadCheck, the ends of the moves with a collision
};

/** \deprecated Use LeadReport. */
using LeadFigures [[deprecated("use LeadReport")]] = LeadReport;

} // namespace pcl_spiral
