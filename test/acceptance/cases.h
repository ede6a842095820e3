// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Acceptance cases: each prints a table and returns how many limits were broken.
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
  std::string method = "radial";       ///< of outlines and random cases, as SpiralMethod's words begin
  bool one_way = false;                ///< outlines without parts against the sense
  std::string only;                    ///< names of outlines, commas between; empty: all
  std::string picture;                 ///< folder for paths and pictures of outlines; empty: none
  bool places = false;                 ///< print where every figure was found, not the broken ones alone
  std::uint64_t variation = 0;         ///< of the outlines; 0: as drawn
  double size = 1.0;                   ///< of the outlines
  double scallop = 0.1;                ///< mm, on the outlines
  std::size_t points = 0;              ///< on each outline; 0: 8,000 to 14,000
};

/** Path, removed material, report, against the exact surface. */
int judge(const Job& job, const Options& options);

/** Deviation and error after simulated machining by a cloud of the part that the planner has not seen. */
int judgeBySecondCloud(const Job& job, const Options& options);

/** The same path when the cloud is moved, mirrored, scaled with all lengths, shuffled, or worked on by another number of
 *  threads. */
int judgeInvariance(const Job& job, const Options& options);

/** A ball of radius 200 in a bowl of radius 130 must be refused, and the place named. */
int judgeRefusal(const Options& options);

/** Clouds and settings that cannot be worked on must be refused with a reason; stray points must be dropped. */
int judgeBadInput(const Options& options);

/** Boundary loops of outlines known exactly: how many, and how far from the truth. */
int judgeLoops(const Options& options);

/** Scans of parts known exactly beside clean ones of the same worth: scan lines far apart; density changing over the part;
 *  overlapping passes; outliers. The same loops, and a path no more than twice as far off. */
int judgeLines(const Options& options);
int judgeUneven(const Options& options);
int judgePasses(const Options& options);
int judgeOutliers(const Options& options);

/** Noise of a tenth of the spacing: the deviation that is left, and the wobble from turn to turn. */
int judgeNoise(const Options& options);

/** Geodesics on the spheroid against the published distances and the exact curves. */
int judgeGeodesics(const Options& options);

/** Distances from the pole of the spheroid, at 200,000 and 2 million points, against the exact ones. */
int judgeField(const Options& options);

/** The whole free-form run beside PCL's own filters on the same cloud and threads. */
int judgeTime(const Options& options);

/** Surfaces, outlines, scans and jobs by chance: each ends in a path that holds, or is refused with a reason. Prints the
 *  cases that do not, and how many ended in what. */
int judgeRandom(const Options& options);

/** Random cases moved, mirrored, scaled with all lengths, shuffled, and worked on by other numbers of threads: each comes
 *  out alike. */
int judgeProperties(const Options& options);

/** One path over every kind of outline: heights, length over the least, motion and faults by an oracle that knows the
 *  surface. One line an outline, limits beside. */
int judgeOutlines(const Options& options);

/** Sections of meshes against the exact surface behind them; and with noise. --only grid, moved, random or bonnet. */
int judgeMeshes(const Options& options);
int judgeNoisyMeshes(const Options& options);
/** Ridges between even and kept rows on the landform. */
int judgeMeshRows(const Options& options);

} // namespace pcl_spiral::acceptance
