// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Acceptance cases: each prints a table and returns the number of broken limits.
 */
#pragma once

#include "job.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace pcl_spiral::acceptance {

struct Options {
  std::uint64_t seed = 1;
  int threads = 0;                     ///< 0: all
  std::uint64_t first = 0, count = 19; ///< of the random cases
  std::string method = "radial";       ///< of outlines and random cases, the beginning of a word of SpiralMethod
  bool one_way = false;                ///< outlines without cuts against the sense
  std::string only;                    ///< names of outlines, separated by commas; empty: all
  std::string picture;                 ///< folder for paths and pictures of outlines; empty: none
  bool places = false;                 ///< print the places of all figures, not only of broken ones
  std::uint64_t variation = 0;         ///< of the outlines; 0: none
  double size = 1.0;                   ///< of the outlines
  double scallop = 0.1;                ///< mm, on the outlines
  std::size_t points = 0;              ///< on each outline; 0: 8,000 to 14,000
};

/** Path, removed material, report, against the exact surface. */
int judge(const Job& job, const Options& options);

/** Deviation and error after simulated machining, by a cloud of the part that the planner does not have. */
int judgeBySecondCloud(const Job& job, const Options& options);

/** The same path if the cloud is moved, mirrored, scaled with all lengths, shuffled, or processed with another number of
 *  threads. */
int judgeInvariance(const Job& job, const Options& options);

/** A ball of radius 200 in a bowl of radius 130 must be refused, with the place. */
int judgeRefusal(const Options& options);

/** Impossible clouds and settings must be refused with a reason; outliers must be removed. */
int judgeBadInput(const Options& options);

/** Boundary loops of exact outlines: their number, and their distance from the outlines. */
int judgeLoops(const Options& options);

/** Difficult scans of exact parts compared with clean scans of the same quality: scan lines far apart; varying density;
 *  overlapping passes; outliers. The same loops, and a path with at most twice the error. */
int judgeLines(const Options& options);
int judgeUneven(const Options& options);
int judgePasses(const Options& options);
int judgeOutliers(const Options& options);

/** Noise of a tenth of the spacing: the remaining deviation, and the wobble from turn to turn. */
int judgeNoise(const Options& options);

/** Geodesics on the spheroid against the published distances and the exact curves. */
int judgeGeodesics(const Options& options);

/** Distances from the pole of the spheroid, at 200,000 and 2 million points, against exact distances. */
int judgeField(const Options& options);

/** The whole free-form run compared with PCL's own filters on the same cloud and threads. */
int judgeTime(const Options& options);

/** Random surfaces, outlines, scans and jobs: each ends in a good path, or is refused with a reason. Prints the
 *  other cases, and the number of each outcome. */
int judgeRandom(const Options& options);

/** Clean random scans: in how many separate parts, outliers, clusters, gaps or edges are seen that are not there; at most one in fifty of
 *  each. */
int judgeAlarms(const Options& options);

/** Steps of 0.5 to 6 spacings whose side was not scanned, by their height: what is apart, what is one surface, and how deep a path cuts
 *  into the body; and steep surfaces, which are one. */
int judgeSteps(const Options& options);

/** Random cases moved, mirrored, scaled with all lengths, shuffled, and processed with other numbers of threads: each gives
 *  the same result. */
int judgeProperties(const Options& options);

/** One path over every kind of outline: heights, length over the least, motion and faults, by an oracle with the exact
 *  surface. One line per outline, with the limits. */
int judgeOutlines(const Options& options);

/** Sections of meshes against the exact surface behind them; and with noise. --only grid, moved, random or bonnet. */
int judgeMeshes(const Options& options);
int judgeNoisyMeshes(const Options& options);
/** Ridges between even and kept rows on the landform. */
int judgeMeshRows(const Options& options);

} // namespace pcl_spiral::acceptance
