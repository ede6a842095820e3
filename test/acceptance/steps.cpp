// SPDX-License-Identifier: BSD-3-Clause
// Steps whose side was not scanned: caps over a table, seen from above. What is apart, what is one surface, and how deep a path that is
// called good cuts into the body. Steep surfaces that are one are never parted.
#include "case_series.h"

#include "support/ball_turns.h"

#include <pcl_spiral/graph/impl/surface_parts.h>
#include <pcl_spiral/planning/spiral_planner.h>
#include <pcl_spiral/surface/scanned_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <sstream>

namespace pcl_spiral::acceptance {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Planner = SpiralPlanner<pcl::PointXYZ>;

constexpr double half_table = 32.0; ///< mm; points are 1 mm apart
constexpr double deep = 0.2;        ///< mm, beside the noise

/** A cap of a sphere on a table, in the middle; its side is upright and not seen. Lengths in mm. */
struct CapOnTable {
  double rim, gap, slope, sphere; ///< radius of the cap; height of its rim; slope there, radians; radius of the sphere
  double noise, ball;

  explicit CapOnTable(test::Random& random)
  : rim(random.uniform(12.0, 20.0)), gap(0.5 * std::pow(12.0, random.uniform())), slope(random.uniform(0.5, 85.0) * M_PI / 180.0),
    sphere(rim / std::sin(slope)), noise(random.uniform() < 0.5 ? 0.0 : random.uniform(0.0, 0.3)), ball(random.uniform(3.0, 8.0))
  {}

  double height(double r) const { return r > rim ? 0.0 : gap + std::sqrt(sphere * sphere - r * r) - sphere * std::cos(slope); }

  /** How deep a ball with its centre at \p c is in cap, side or table. */
  double depth(const Vector3d& c) const
  {
    const double r = c.head<2>().norm();
    const Vector2d from_sphere(r, c.z() - gap + sphere * std::cos(slope));
    const bool over_cap = from_sphere.y() > 0.0 && std::atan2(from_sphere.x(), from_sphere.y()) <= slope;
    const double cap = over_cap ? from_sphere.norm() - sphere : std::hypot(r - rim, c.z() - gap);
    const double side = std::hypot(r - rim, c.z() - std::clamp(c.z(), 0.0, gap));
    const bool inside = r < rim && c.z() < height(r);
    const double table = r > rim ? c.z() : side;
    return inside ? ball + std::min(std::abs(cap), side) : ball - std::min({cap, side, table});
  }
};

/** Places of four kinds of grids over a square: rows and columns, moved ones, lines, points at random. */
std::vector<Vector2d>
gridOf(test::Random& random)
{
  const std::size_t kind = random.below(4);
  const double turn = random.uniform(0.0, M_PI), across = kind == 2 ? random.uniform(1.0, 2.0) : 1.0;
  const double moved = kind == 1 ? 0.3 : 0.02;
  const int half = static_cast<int>(1.5 * half_table);
  std::vector<Vector2d> places;
  for (int i = -half; i <= half; ++i)
    for (int k = -half; k <= half; ++k) {
      Vector2d p(i * across + random.uniform(-moved, moved), k / across + random.uniform(-moved, moved));
      p = kind == 3 ? 1.5 * half_table * Vector2d(random.uniform(-1, 1), random.uniform(-1, 1)) : Eigen::Rotation2Dd(turn) * p;
      if (p.cwiseAbs().maxCoeff() < half_table)
        places.push_back(p);
    }
  return places;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
cloudOf(const std::vector<Vector2d>& places, test::Random& random, double noise, const std::function<double(const Vector2d&)>& height)
{
  std::vector<Vector3d> points;
  for (const Vector2d& p : places)
    points.emplace_back(p.x(), p.y(), height(p) + noise * random.normal());
  return test::toCloud(points);
}

/** What came of a scan. */
struct Found {
  bool is_path = false, is_joined = false; ///< joined: one path over cap and table
  double depth = 0.0;
  bool is_warned = false; ///< of a step or of points that stand out
};

Found
planned(const CapOnTable& body, const pcl::PointCloud<pcl::PointXYZ>::Ptr& cloud, bool part_alone)
{
  Planner planner;
  planner.setInputCloud(cloud);
  planner.setToolRadius(body.ball);
  planner.setScallopHeight(4.0 / (8.0 * body.ball)); // a step-over of two spacings
  planner.setQuiet(true);
  planner.setNumberOfThreads(1);
  if (part_alone)
    planner.setPartAt(Vector3d(0.0, 0.0, body.height(0.0)));
  Path path;
  planner.compute(path);
  Found found;
  found.is_path = planner.getStatus().ok();
  bool on_cap = false, on_table = false;
  for (const ToolpathPoint& p : path) {
    const double r = std::hypot(p.x, p.y);
    on_cap |= r < body.rim - 2.0;
    on_table |= r > body.rim + 2.0;
    if (r < 0.5 * (body.rim + half_table)) // not at the edge of the table
      found.depth = std::max(found.depth, body.depth(test::ballCentre(p, body.ball)));
  }
  found.is_joined = on_cap && on_table;
  found.is_warned = planner.getReport().missed.count > 0;
  return found;
}

/** "apart", "joined" or "refused", with the height of the step and the deepest cut of a path beside the noise. */
Outcome
judgeStep(std::uint64_t own)
{
  test::Random random(own);
  const CapOnTable body(random);
  const std::vector<Vector2d> places = gridOf(random);
  const auto cloud = cloudOf(places, random, body.noise, [&body](const Vector2d& p) { return body.height(p.norm()); });
  const Found whole = planned(body, cloud, false);
  const Found part = planned(body, cloud, true);
  const double allowed = deep + body.noise;
  std::ostringstream faults;
  const auto look = [&](const char* name, const Found& found) {
    if (found.is_path && found.depth > allowed && !found.is_warned)
      faults << name << " cuts " << found.depth << " deep; ";
  };
  look("the path over all", whole);
  look("the path over the cap", part);
  if (!faults.str().empty())
    faults << "gap " << body.gap << ", rim " << body.rim << ", slope " << body.slope * 180.0 / M_PI << ", noise " << body.noise << ", ball "
           << body.ball;
  const char* kind = part.is_path ? part.is_joined ? "joined" : "apart" : whole.is_path && whole.is_joined ? "joined" : "refused";
  const double deepest = std::max(whole.is_path ? whole.depth : 0.0, part.is_path ? part.depth : 0.0);
  std::ostringstream words;
  words << kind << ' ' << body.gap << ' ' << std::max(0.0, deepest - body.noise);
  return {words.str(), faults.str()};
}

/** Waves, roofs, pits and grooves of 30 to 78 degrees are one surface. */
Outcome
judgeSteep(std::uint64_t own)
{
  test::Random random(own);
  const double slope = std::tan(random.uniform(30.0, 78.0) * M_PI / 180.0), length = random.uniform(16.0, 30.0);
  const std::size_t kind = random.below(4);
  const auto height = [&](const Vector2d& p) {
    switch (kind) {
    case 0:
      return slope * length / (2.0 * M_PI) * std::sin(2.0 * M_PI * p.x() / length);
    case 1:
      return -slope * std::abs(p.x());
    case 2:
      return -slope * std::max(0.0, 0.5 * length - p.norm());
    default:
      return -slope * std::max(0.0, 0.5 * length - std::abs(p.x()));
    }
  };
  ScannedSurface<pcl::PointXYZ> scanned;
  const double noise = random.uniform() < 0.5 ? 0.0 : random.uniform(0.0, 0.2);
  scanned.setInputCloud(cloudOf(gridOf(random), random, noise, height));
  scanned.setViewPoint(Vector3d(0.0, 0.0, 1000.0));
  scanned.setStrict(false);
  scanned.setQuiet(true);
  scanned.setNumberOfThreads(1);
  Surface::ConstPtr surface;
  scanned.compute(surface);
  if (!surface)
    return {"none", ""};
  const std::vector<SurfacePart> parts = surfaceParts(surface->graph()).parts;
  const OtherParts others = otherParts(parts, largest_cluster);
  const bool parted = others == OtherParts::TooLarge || others == OtherParts::TooMany;
  return {parted ? "parted" : "one", parted ? "a surface of kind " + std::to_string(kind) + " is parted: slope " +
                                                  std::to_string(std::atan(slope) * 180.0 / M_PI) + ", length " + std::to_string(length) +
                                                  ", noise " + std::to_string(noise)
                                            : ""};
}

/** Steps of one range of heights. */
struct Row {
  int scans = 0, apart = 0, joined = 0, refused = 0, silent = 0;
  double deepest = 0.0;
};

} // namespace

int
judgeSteps(const Options& options)
{
  constexpr unsigned int longest = 120; // s
  constexpr std::array<double, 7> heights{0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0};
  std::array<Row, heights.size() - 1> rows;
  int silent = 0, parted = 0, steep = 0;
  for (std::uint64_t i = options.first; i < options.first + options.count; ++i) {
    const std::uint64_t own = options.seed * 1000003 + i;
    const bool is_step = i % 4 != 3;
    const Outcome outcome = isolated(longest, [&] { return is_step ? judgeStep(own) : judgeSteep(own); });
    if (!outcome.faults.empty())
      std::printf("  case %llu: %s\n", static_cast<unsigned long long>(i), outcome.faults.c_str());
    std::istringstream words(outcome.kind);
    std::string kind;
    double gap = 0.0, depth = 0.0;
    words >> kind >> gap >> depth;
    if (!is_step) {
      ++steep;
      parted += outcome.faults.empty() ? 0 : 1;
      continue;
    }
    const auto above = std::upper_bound(heights.begin() + 1, heights.end() - 1, gap);
    Row& row = rows[static_cast<std::size_t>(above - heights.begin() - 1)];
    ++row.scans;
    row.apart += kind == "apart" ? 1 : 0;
    row.joined += kind == "joined" ? 1 : 0;
    row.refused += kind == "refused" ? 1 : 0;
    row.deepest = std::max(row.deepest, depth);
    row.silent += outcome.faults.empty() ? 0 : 1;
    silent += outcome.faults.empty() ? 0 : 1;
  }
  std::printf("steps, seed %llu\n  height of the step, spacings  scans  apart  one surface  refused  deepest cut  deep without a warning\n",
              static_cast<unsigned long long>(options.seed));
  for (std::size_t k = 0; k < rows.size(); ++k)
    std::printf("  %.1f to %.1f  %5d  %5d  %5d  %5d  %8.3f  %5d\n", heights[k], heights[k + 1], rows[k].scans, rows[k].apart,
                rows[k].joined, rows[k].refused, rows[k].deepest, rows[k].silent);
  std::printf("  steep surfaces: %d, parted %d\n", steep, parted);
  return silent + parted;
}

} // namespace pcl_spiral::acceptance
