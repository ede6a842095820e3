// SPDX-License-Identifier: BSD-3-Clause
// Harmonic fields against exact fields of the plane: radii, logarithms, circles through the limiting points. For
// outlines without a formula, lines reach the middle and never cross.
#include "support/sampling.h"
#include "support/surfaces.h"

#include "geodesic/harmonic_field.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <complex>
#include <functional>

namespace harmonic_field_test {

namespace {

using namespace pcl_spiral;
using Complex = std::complex<double>;
using Eigen::Vector2d;
using Eigen::Vector3d;

/** A sampled surface, its graph, and its boundary loops, the longest first. */
struct Scan {
  SurfaceGraph graph;
  std::vector<std::vector<std::uint32_t>> loops;

  explicit Scan(const std::vector<Vector3d>& points)
  {
    std::vector<Eigen::Vector3f> floats;
    for (const Vector3d& p : points)
      floats.push_back(p.cast<float>());
    const Status status = graph.build(floats, {});
    EXPECT_TRUE(status.ok()) << status.message();
    const Triangulation& mesh = graph.triangulation();
    for (const auto& loop : mesh.boundaryLoops()) {
      loops.emplace_back();
      for (const std::uint32_t h : loop)
        loops.back().push_back(mesh.origin(h));
    }
    const auto extent = [&](const std::vector<std::uint32_t>& loop) {
      double sum = 0.0;
      for (const std::uint32_t i : loop)
        sum += (graph.position(i) - graph.position(loop[0])).norm();
      return sum;
    };
    std::stable_sort(loops.begin(), loops.end(), [&](auto& a, auto& b) { return extent(a) > extent(b); });
  }
};

Complex
plane(const Vector3d& p)
{
  return {p.x(), p.y()};
}

/** Largest sideways error of lines that must be level lines of arg f, in spacings. \p slope: |f' / f|. */
double
sidewaysError(const HarmonicField& field, const Polyline& rim, double spacing, const std::function<Complex(Complex)>& f,
              const std::function<double(Complex)>& slope)
{
  double largest = 0.0;
  const std::vector<Polyline> lines = field.trace(rim);
  for (std::size_t l = 0; l < rim.size(); ++l) {
    const Polyline& line = lines[l];
    EXPECT_GE(line.size(), 3u);
    if (line.empty())
      continue;
    EXPECT_EQ(line.back(), rim[l]);
    const Complex level = f(plane(rim[l]));
    for (std::size_t i = 1; i < line.size(); ++i)
      largest = std::max(largest, std::abs(std::arg(f(plane(line[i])) / level)) / slope(plane(line[i])));
  }
  return largest / spacing;
}

/** How far \p line goes to the right of its neighbour \p other, which must be on its right; seen from above. */
double
overlap(const Polyline& line, const Polyline& other)
{
  double worst = 0.0;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Vector2d p = line[i].head<2>();
    double nearest = 1e30, right = 0.0;
    for (std::size_t k = 0; k + 1 < other.size(); ++k) {
      const Vector2d a = other[k].head<2>(), d = other[k + 1].head<2>() - a;
      const double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      const double distance = (p - a - t * d).norm();
      if (distance < nearest) {
        nearest = distance;
        right = ((p - a).x() * d.y() - (p - a).y() * d.x()) / d.norm();
      }
    }
    worst = std::max(worst, std::min(right, nearest));
  }
  return worst;
}

TEST(HarmonicField, DiscLinesAreRadii)
{
  const auto surface = test::flat(test::Region({test::circle({0, 0}, 100.0)}));
  for (const std::uint64_t seed : {1, 2}) {
    const Scan scan(test::sampleUniform(*surface, 20000, seed).points);
    HarmonicField field;
    const Status status = field.compute(scan.graph, Vector3d::Zero(), scan.loops[0]);
    ASSERT_TRUE(status.ok()) << status.message();
    const auto f = [](Complex z) { return z; };
    const auto slope = [](Complex z) { return 1.0 / std::abs(z); };
    const double error = sidewaysError(field, resampled(surface->outlines()[0], 400, true), scan.graph.spacing(), f, slope);
    EXPECT_LT(error, 0.9);
  }
}

TEST(HarmonicField, OffCentreDisc)
{
  const double radius = 100.0;
  const auto surface = test::flat(test::Region({test::circle({0, 0}, radius)}));
  const Scan scan(test::sampleUniform(*surface, 20000, 3).points);
  const Complex p(50.0, 20.0);
  HarmonicField field;
  const Status status = field.compute(scan.graph, Vector3d(p.real(), p.imag(), 0), scan.loops[0]);
  ASSERT_TRUE(status.ok()) << status.message();
  const auto f = [&](Complex z) { return (z - p) / (radius * radius - std::conj(p) * z); };
  const auto slope = [&](Complex z) { return std::abs(1.0 / (z - p) + std::conj(p) / (radius * radius - std::conj(p) * z)); };
  const double error = sidewaysError(field, resampled(surface->outlines()[0], 400, true), scan.graph.spacing(), f, slope);
  EXPECT_LT(error, 1.2);
}

TEST(HarmonicField, Annulus)
{
  const double r0 = 30.0, r1 = 100.0;
  const auto surface = test::flat(test::Region({test::circle({0, 0}, r1), test::circle({0, 0}, r0)}));
  const Scan scan(test::sampleUniform(*surface, 20000, 4).points);
  ASSERT_EQ(scan.loops.size(), 2u);
  HarmonicField field;
  const Status status = field.compute(scan.graph, scan.loops[1], surface->outlines()[1], scan.loops[0]);
  ASSERT_TRUE(status.ok()) << status.message();
  double worst = 0.0;
  for (std::size_t i = 0; i < scan.graph.size(); ++i)
    worst = std::max(worst, std::abs(field.value(i) - std::log(scan.graph.position(i).norm() / r0) / std::log(r1 / r0)));
  EXPECT_LT(worst, 0.06);
  const auto f = [](Complex z) { return z; };
  const auto slope = [](Complex z) { return 1.0 / std::abs(z); };
  const double error = sidewaysError(field, resampled(surface->outlines()[0], 400, true), scan.graph.spacing(), f, slope);
  EXPECT_LT(error, 0.9);
}

TEST(HarmonicField, OffCentreAnnulusIsBipolar)
{
  const double r1 = 150.0, r0 = 45.0;
  const Complex c(40.0, 25.0);
  const auto surface = test::flat(test::Region({test::circle({0, 0}, r1), test::circle({c.real(), c.imag()}, r0)}));
  const Scan scan(test::sampleUniform(*surface, 20000, 6).points);
  ASSERT_EQ(scan.loops.size(), 2u);
  HarmonicField field;
  const Status status = field.compute(scan.graph, scan.loops[1], surface->outlines()[1], scan.loops[0]);
  ASSERT_TRUE(status.ok()) << status.message();
  // The limiting points of the two circles, inverse to each other in both circles.
  const double d = std::abs(c), sum = (r1 * r1 + d * d - r0 * r0) / d;
  const double root = std::sqrt(sum * sum / 4.0 - r1 * r1);
  const Complex p = c / d * (sum / 2.0 - root), q = c / d * (sum / 2.0 + root);
  const auto f = [&](Complex z) { return (z - p) / (z - q); };
  const auto slope = [&](Complex z) { return std::abs(1.0 / (z - p) - 1.0 / (z - q)); };
  const double low = std::log(std::abs(f(c + r0))), high = std::log(std::abs(f(Complex(r1)))), size = high - low;
  double worst = 0.0;
  for (std::size_t i = 0; i < scan.graph.size(); ++i)
    worst = std::max(worst, std::abs(field.value(i) - (std::log(std::abs(f(plane(scan.graph.position(i))))) - low) / size));
  EXPECT_LT(worst, 0.1);
  EXPECT_LT(sidewaysError(field, resampled(surface->outlines()[0], 400, true), scan.graph.spacing(), f, slope), 1.2);
}

/** A square with a gap of the scan. */
Scan
gappedSquare(const Eigen::Isometry3d& motion = Eigen::Isometry3d::Identity())
{
  const auto surface = test::flat(test::Region({test::rectangle(200.0, 200.0), test::circle({45, 10}, 25.0)}));
  auto points = test::sampleUniform(*surface, 15000, 7).points;
  for (Vector3d& p : points)
    p = motion * p;
  return Scan(points);
}

TEST(HarmonicField, LinesRideRoundAGap)
{
  const Scan scan = gappedSquare();
  const double spacing = scan.graph.spacing();
  HarmonicField field;
  ASSERT_TRUE(field.compute(scan.graph, Vector3d(-30, 0, 0), scan.loops[0]).ok());
  const Polyline outline = {{-100, -100, 0}, {100, -100, 0}, {100, 100, 0}, {-100, 100, 0}};
  const auto lines = field.trace(resampled(outline, 400, true));
  double deepest = 0.0, worst = 0.0;
  for (std::size_t l = 0; l < lines.size(); ++l) {
    for (const Vector3d& p : lines[l])
      deepest = std::max(deepest, 25.0 - (p - Vector3d(45, 10, 0)).norm());
    worst = std::max(worst, overlap(lines[(l + 1) % lines.size()], lines[l]));
  }
  EXPECT_LT(deepest, 0.5 * spacing);
  EXPECT_LT(worst, 0.1 * spacing);
  EXPECT_GT(overlap(lines[0], lines[1]), 0.5 * spacing); // neighbours in the wrong order are detected
}

TEST(HarmonicField, SameLinesWhereverTheSurfaceLiesAndForAnyThreads)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(0.7, Vector3d(0.2, 0.3, 1.0).normalized())).pretranslate(Vector3d(10, 200, -30));
  const Scan still = gappedSquare(), moved = gappedSquare(motion);
  const Vector3d centre(-30, 0, 0);
  const Polyline ends = {{-100, 7, 0}, {100, 10, 0}, {60, 100, 0}, {99, -98, 0}};
  Polyline moved_ends;
  for (const Vector3d& p : ends)
    moved_ends.push_back(motion * p);
  HarmonicField one, two, third;
  omp_set_num_threads(1);
  ASSERT_TRUE(one.compute(still.graph, centre, still.loops[0]).ok());
  const auto lines = one.trace(ends);
  omp_set_num_threads(2);
  ASSERT_TRUE(two.compute(still.graph, centre, still.loops[0]).ok());
  ASSERT_TRUE(third.compute(moved.graph, motion * centre, moved.loops[0]).ok());
  const auto same = two.trace(ends), elsewhere = third.trace(moved_ends);
  for (std::size_t l = 0; l < ends.size(); ++l) {
    EXPECT_EQ(lines[l], same[l]);
    ASSERT_EQ(lines[l].size(), elsewhere[l].size());
    double farthest = 0.0;
    for (std::size_t i = 0; i < lines[l].size(); ++i)
      farthest = std::max(farthest, (motion * lines[l][i] - elsewhere[l][i]).norm());
    EXPECT_LT(farthest, 1e-3);
  }
}

TEST(HarmonicField, RefusesWithAReason)
{
  const Scan scan = gappedSquare();
  HarmonicField field;
  EXPECT_TRUE(field.trace(Vector3d(100, 0, 0)).empty());
  const auto refused = [&](const Vector3d& centre, const std::vector<std::uint32_t>& rim) {
    return field.compute(scan.graph, centre, rim).code() == StatusCode::InvalidArgument;
  };
  EXPECT_TRUE(refused({45, 10, 0}, scan.loops[0]));  // in the gap
  EXPECT_TRUE(refused({0, 0, 50}, scan.loops[0]));   // off the surface
  EXPECT_TRUE(refused({99.5, 0, 0}, scan.loops[0])); // at the rim
  EXPECT_TRUE(refused({NAN, 0, 0}, scan.loops[0]));
  EXPECT_TRUE(refused({-30, 0, 0}, {}));
  EXPECT_TRUE(refused({-30, 0, 0}, {1, 2, 4000000}));
  EXPECT_FALSE(field.compute(scan.graph, scan.loops[0], {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, scan.loops[0]).ok());
  ASSERT_TRUE(field.compute(scan.graph, Vector3d(-30, 0, 0), scan.loops[0]).ok());
  EXPECT_TRUE(field.trace(Vector3d(150, 0, 0)).empty());
  EXPECT_TRUE(field.trace(Vector3d(NAN, 0, 0)).empty());
}

TEST(HarmonicField, OutlinesWithoutAFormula)
{
  const std::pair<test::SurfacePtr, Vector2d> cases[] = {{test::kidneyPatch(), {10.0, 0.0}}, {test::ellPatch(), {-55.0, -55.0}}};
  for (const auto& [surface, at] : cases) {
    const Scan scan(test::sampleUniform(*surface, 30000, 5).points);
    const Vector3d middle = surface->lift(at);
    HarmonicField field;
    const Status status = field.compute(scan.graph, middle, scan.loops[0]);
    ASSERT_TRUE(status.ok()) << status.message();
    const Polyline& outline = surface->outlines()[0];
    const Polyline rim = resampled(outline, length(outline, true) / scan.graph.spacing(), true);
    const std::vector<Polyline> lines = field.trace(rim);
    for (std::size_t l = 0; l < rim.size(); ++l) {
      ASSERT_GE(lines[l].size(), 3u);
      EXPECT_EQ(lines[l].front(), middle);
      EXPECT_EQ(lines[l].back(), rim[l]);
    }
    // In the arms the lines come together without limit: they may touch but not change places.
    double worst = 0.0;
    for (std::size_t l = 0; l < lines.size(); ++l)
      worst = std::max(worst, overlap(lines[(l + 1) % lines.size()], lines[l]));
    EXPECT_LT(worst / scan.graph.spacing(), 0.1);
  }
}

} // namespace

} // namespace harmonic_field_test
