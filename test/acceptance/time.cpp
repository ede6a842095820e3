// SPDX-License-Identifier: BSD-3-Clause
#include "cases.h"
#include "table.h"

#include "support/pcl_pair.h"

#include <pcl/surface/mls.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include <omp.h>

namespace pcl_spiral::acceptance {

namespace {

/** Seconds of PCL's normals (k = 20), boundary (k = 30) and moving least squares (order 2, 3 spacings). */
double
pclSeconds(const Cloud::ConstPtr& cloud, double spacing, int threads)
{
  const auto from = std::chrono::steady_clock::now();
  const test::Tree::Ptr tree(new test::Tree);
  test::pclBoundary(cloud, test::pclNormals(cloud, tree, threads), tree);
  pcl::PointCloud<pcl::PointNormal> smooth;
  pcl::MovingLeastSquares<pcl::PointXYZ, pcl::PointNormal> mls;
  mls.setInputCloud(cloud);
  mls.setSearchMethod(tree);
  mls.setSearchRadius(3.0 * spacing);
  mls.setPolynomialOrder(2);
  mls.setComputeNormals(true);
  mls.setNumberOfThreads(static_cast<unsigned>(threads));
  mls.process(smooth);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

} // namespace

int
judgeTime(const Options& options)
{
  const Job row = job("freeform");
  const int threads = options.threads > 0 ? options.threads : omp_get_max_threads();
  Table table("time: the whole free-form run beside PCL's filters, " + std::to_string(threads) + " threads, best of three by turns");
  const Cloud::ConstPtr cloud = test::toCloud(sampled(row, options.seed).points);
  const double spacing = std::sqrt(row.surface->area() / static_cast<double>(row.points));
  double ours = 1e9, theirs = 1e9;
  for (int i = 0; i < 3; ++i) {
    const Run result = run(row, cloud, threads);
    table.holds("a path is made", result.status.ok(), result.status.message());
    ours = std::min(ours, result.seconds);
    theirs = std::min(theirs, pclSeconds(cloud, spacing, threads));
  }
  table.note("PCL: normals, boundary, MLS", theirs, "s");
  table.atMost("whole run", ours, theirs, "s");
  return table.broken();
}

} // namespace pcl_spiral::acceptance
