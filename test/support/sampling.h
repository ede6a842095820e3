// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Clouds sampled from test surfaces, the same on every platform for a given seed.
 */
#pragma once

#include "support/surfaces.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace pcl_spiral::test {

/** Random numbers from mt19937_64 with own formulas: the standard distributions differ between
 * libraries. */
class Random {
public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /** Uniform in [0, 1). */
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double uniform(double from, double to) { return from + (to - from) * uniform(); }
  /** Standard normal, Box-Muller. */
  double normal();
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(uniform() * static_cast<double>(n)); }

private:
  std::mt19937_64 engine_;
};

/** Points of a surface with exact normals. */
struct Sampled {
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;
};

/** \p count points, uniform by area. */
Sampled sampleUniform(const AnalyticSurface& surface, std::size_t count, std::uint64_t seed);

/** Points on chart rows \p across apart, \p along apart in the row, each row with a random start; \p jitter
 * moves each point along its row by up to that share of \p along. Spacings in chart units. */
Sampled sampleScanLines(const AnalyticSurface& surface, double along, double across, std::uint64_t seed, double jitter = 0.1);

/** Moves every point along its normal by Gaussian noise of standard deviation \p sigma. */
void addNoise(Sampled& sampled, double sigma, std::uint64_t seed);

/** A random order of 0 .. n-1. */
std::vector<std::size_t> shuffled(std::size_t n, std::uint64_t seed);

/** A random rotation (uniform) and a shift of up to \p reach in each coordinate. */
Eigen::Isometry3d randomMotion(std::uint64_t seed, double reach);

pcl::PointCloud<pcl::PointXYZ>::Ptr toCloud(const std::vector<Eigen::Vector3d>& points);

pcl::PointCloud<pcl::Normal>::Ptr toNormals(const std::vector<Eigen::Vector3d>& normals);

} // namespace pcl_spiral::test
