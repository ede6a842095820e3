// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The generated surfaces of the acceptance table, and one run of the generator. Lengths in mm.
 */
#pragma once

#include "support/sampling.h"
#include "support/surfaces.h"

#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_spiral::acceptance {

using Generator = SpiralToolpathGenerator<pcl::PointXYZ>;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Path = pcl::PointCloud<ToolpathPoint>;

/** One row of the table: a sampled surface, a cutter, and limits. Limits of 0 are not checked. */
struct Job {
  std::string name;
  test::SurfacePtr surface;
  std::size_t points = 0;
  double tool_radius = 0.0, scallop_height = 0.0, chord_error = 0.0;
  double noise = 0.0;
  double deviation_rms = 0.0, deviation_p99 = 0.0, deviation_max = 0.0;
  bool scallop = true;         ///< scallop, gouge and uncut limits apply
  double length_ratio = 0.0;   ///< of the path to the integral of dA / exact step-over across circles of latitude
  double turning = 0.0;        ///< degrees between neighbouring moves
  bool may_refuse = false;     ///< a clear error is as good as a path
  std::size_t samples = 60000; ///< of the removed material
  double machined_max = 0.0;   ///< stock, scallop or gouge, by a second cloud
  double judge_seconds = 0.0;  ///< to judge with it; needs an idle computer
};

/** Every row that ends in a path. */
std::vector<Job> jobs();

/** Rows judged by a second cloud: the two published parts, each without and with noise, and a million points with a
 *  million moves. */
std::vector<Job> secondCloudJobs();

/** The row of that name; throws std::out_of_range if there is none. */
Job job(const std::string& name);

/** The job's points, noise included. */
test::Sampled sampled(const Job& job, std::uint64_t seed);

/** One run of the generator. */
struct Run {
  Path path;
  SpiralReport report;
  Status status;
  double seconds = 0.0;
};

/** Runs with the job's cutter on \p cloud; if \p view and \p start are null, the generator finds them. */
Run run(const Job& job, const Cloud::ConstPtr& cloud, int threads, const Eigen::Vector3d* view = nullptr,
        const Eigen::Vector3d* start = nullptr, SpiralSense sense = SpiralSense::CounterClockwise);

} // namespace pcl_spiral::acceptance
