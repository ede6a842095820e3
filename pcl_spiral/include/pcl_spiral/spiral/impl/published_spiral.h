// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The spiral of Wu et al. 2025, for comparison.
 */
#pragma once

#include <pcl_spiral/common/impl/progress.h>
#include <pcl_spiral/common/impl/stage_clock.h>
#include <pcl_spiral/common/status.h>
#include <pcl_spiral/features/boundary_loop.h>
#include <pcl_spiral/graph/impl/surface_graph.h>
#include <pcl_spiral/spiral/impl/radial_lines_engine.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Figures of the published method. Lengths in mm. */
struct PublishedReport {
  std::size_t lines = 0;
  std::size_t unsettled_lines = 0;     ///< geodesics that still moved sideways by more than the chord error at the end
  double largest_line_move = 0.0;      ///< largest move of any of them at the end
  double largest_line_deviation = 0.0; ///< of a B-spline from the points it was fitted to
  double step = 0.0;                   ///< (13)-(15): requested between points of the path
  double step_over = 0.0;              ///< (16): requested between turns, along the lines
  std::size_t turns = 0;               ///< between the boundaries
  double longest_move = 0.0;           ///< between points of the path, on the surface
  double largest_axis_change = 0.0;    ///< degrees between neighbouring points
};

/** The published path as parallel arrays, with its inputs and its cost. */
struct PublishedResult {
  std::vector<BoundaryLoop> loops;
  RadialLineSet lines;
  Polyline contacts;
  std::vector<Eigen::Vector3d> normals; ///< unit, out of the material: PCA at the point of the cloud nearest to the contact
  std::vector<Eigen::Vector3f> axes;    ///< unit, tip to shank
  std::vector<double> arc_lengths;
  std::vector<float> turns;
  PublishedReport figures;
  std::vector<StageCost> stages; ///< in the order they ran
  Diagnostics warnings;
};

/** A spiral by the method of Wu, Chai, Bo, Liu, Wang, "Spiral machining trajectory planning method based on
 * discrete point cloud construction of radial lines", China Mechanical Engineering 36(4), 2025: the reference
 * for other methods.
 *
 *  | stage | equations |
 *  |---|---|
 *  | boundary points by the centroid of their neighbours, walked over | (1) |
 *  | ways over the elliptic Gabriel graph, made geodesics by Newton steps | (2)-(7) |
 *  | projection to the directional centroid | (8)-(11) |
 *  | Taubin's curvatures on the lines | (12) |
 *  | one step for the whole path, of the least radius | (13)-(15) |
 *  | one step-over, of a plane | (16) |
 *  | turns by arc length along the lines | (17)-(19) |
 *  | PCA normals, tilted about the feed; axes are not smoothed | |
 *
 *  Where the printed method cannot work, the corrected form is used: geodesics with fixed ends; turns that all
 * lines share, each line's part in proportion to the rim, so that every turn ends where the next begins; lines
 * left out near the centre where they are too close; one turn along the rim, and along the inner loop of an
 * annulus; points closer than the one step where turns bend more than the chord error allows. Everything else
 * is as published, and fails where the published method fails, with a message that gives place and cause: no
 * other method repairs it. Warnings report holes that are not bridged, lines that did not converge and places
 * where the cutter gouges. The centre, if none is given (balancedCentre), and the smooth outlines of loops
 * are those of this library, because the publication does not define them.
 *
 *  It uses these \p settings: radius, scallop height, chord error, longest step, tilt and lead, centre, start
 * point, boundary mode, gap handling, direction and sense. Call it within a ThreadLimit to set the number of threads;
 * the bytes are the same for any. */
Status planPublished(const SurfaceGraph& graph, const SpiralSettings& settings, const ProgressCallback& progress, PublishedResult& result);

/** The same between given \p loops, instead of equation (1) and the walk. Refused if they do not belong to the
 * surface (checkLoops). */
Status planPublishedWithin(const SurfaceGraph& graph, const std::vector<BoundaryLoop>& loops, const SpiralSettings& settings,
                           const ProgressCallback& progress, PublishedResult& result);

} // namespace pcl_spiral
