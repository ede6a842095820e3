// SPDX-License-Identifier: BSD-3-Clause
#include "cases.h"
#include "outline_distance.h"
#include "table.h"

#include <pcl_spiral/features/impl/boundary_loops_engine.h>
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <cmath>

namespace pcl_spiral::acceptance {

namespace {

/** A cloud with known outlines. */
struct Outlined {
  std::string name;
  test::SurfacePtr surface;
  std::vector<Eigen::Vector3d> points;
  double spacing; ///< of evenly spread points of the same number
};

Outlined
uniform(const std::string& name, const test::SurfacePtr& surface, std::size_t count, std::uint64_t seed)
{
  return {name, surface, test::sampleUniform(*surface, count, seed).points, std::sqrt(surface->area() / static_cast<double>(count))};
}

std::vector<Outlined>
outlinedClouds(std::uint64_t seed)
{
  using namespace test;
  const auto holes = [] { return flat(Region({rectangle(100, 80), circle({-25, 5}, 12), circle({22, -8}, 16)})); };
  std::vector<Outlined> all{uniform("square", flat(Region({rectangle(100, 100)})), 10000, seed),
                            uniform("L", flat(Region({ell(100, 40)})), 10000, seed),
                            uniform("slot", flat(Region({slot(120, 40)})), 10000, seed),
                            uniform("star", flat(Region({star(5, 60, 30)})), 10000, seed), uniform("two holes", holes(), 10000, seed)};
  for (const char* name : {"freeform", "dome200k_annulus", "saddle", "annulus", "kidney", "ell"})
    all.push_back(uniform(name, job(name).surface, job(name).points, seed));

  Outlined lines{"scan lines 10:1", flat(Region({ell(100, 40)})), {}, 0.0};
  lines.points = sampleScanLines(*lines.surface, 0.2, 2.0, seed).points;
  lines.spacing = 2.0; // the outline cannot be known better than the distance of the lines
  all.push_back(lines);

  Outlined rough = uniform("noise 0.3 spacing along the normal", flat(Region({rectangle(100, 100)})), 10000, seed);
  Sampled points = sampleUniform(*rough.surface, 10000, seed);
  addNoise(points, 0.3 * rough.spacing, seed + 1);
  rough.points = points.points;
  all.push_back(rough);
  return all;
}

void
judgeCloud(const Outlined& cloud, Table& table)
{
  std::vector<Eigen::Vector3f> points;
  for (const Eigen::Vector3d& p : cloud.points)
    points.push_back(p.cast<float>());
  SurfaceGraph graph;
  const Status built = graph.build(points, {});
  std::vector<BoundaryLoop> loops;
  const Status found = built.ok() ? findBoundaryLoops(graph, {}, loops) : built;
  table.holds(cloud.name, found.ok(), found.message());
  const std::vector<Polyline>& outlines = cloud.surface->outlines();
  table.atMost("  loops too many or too few", std::abs(static_cast<double>(loops.size()) - static_cast<double>(outlines.size())), 0.0, "");
  for (const Polyline& outline : outlines) {
    test::Place by_curve, by_points;
    by_curve.value = by_points.value = 1e9;
    for (const BoundaryLoop& loop : loops) { // the loop that fits this outline best
      const test::Place p = hausdorff(outline, loop.points, 0.1 * cloud.spacing);
      if (p.value < by_points.value) {
        by_points = p;
        by_curve = hausdorff(outline, loop.curve, 0.1 * cloud.spacing);
      }
    }
    by_curve.value /= cloud.spacing;
    by_points.value /= cloud.spacing;
    table.atMost("  curve to the outline", by_curve, 1.5, "spacings");
    table.note("  points to the outline", by_points.value, "spacings");
  }
}

} // namespace

int
judgeLoops(const Options& options)
{
  Table table("loops: outlines found against the true ones (Hausdorff distance, both ways)");
  for (const Outlined& cloud : outlinedClouds(options.seed))
    judgeCloud(cloud, table);
  return table.broken();
}

} // namespace pcl_spiral::acceptance
