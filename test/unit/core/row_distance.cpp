// SPDX-License-Identifier: BSD-3-Clause
// The distance of rows at which a ball leaves the scallop height: on exact surfaces, by brute force.
#include "support/left_heights.h"
#include "support/sampling.h"
#include "support/surfaces.h"

#include "core/row_distance.h"
#include "core/row_levels.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace row_distance_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

SurfaceBend
bendAt(const AnalyticSurface& surface, const Vector3d& x)
{
  SurfaceBend bend;
  bend.normal = surface.normal(x);
  const Vector3d e = bend.normal.unitOrthogonal(), f = bend.normal.cross(e);
  const Eigen::Matrix3d h = surface.hessian(x) / surface.gradient(x).norm();
  Eigen::Matrix2d shape;
  shape << e.dot(h * e), e.dot(h * f), f.dot(h * e), f.dot(h * f);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(shape);
  bend.curvature1 = axes.eigenvalues()[1];
  bend.curvature2 = axes.eigenvalues()[0];
  bend.direction1 = axes.eigenvectors()(0, 1) * e + axes.eigenvectors()(1, 1) * f;
  return bend;
}

/** A ball in rows along a direction of the plane, over a rectangle about the origin or elsewhere. */
struct RowCut {
  SurfacePtr surface;
  Vector2d low, high;     ///< of the charts x and y
  double direction = 0.0; ///< of the rows, degrees from x
  double radius = 5.0, height = 0.01;
  RowsThrough through = RowsThrough::Centres;

  Vector3d along() const { return {std::cos(direction * M_PI / 180.0), std::sin(direction * M_PI / 180.0), 0.0}; }
  Vector3d across() const { return Vector3d::UnitZ().cross(along()); }
  /** The point that must be on a plane: the contact, or the centre. */
  Vector3d led(const Vector3d& x) const { return through == RowsThrough::Contacts ? x : Vector3d(x + radius * surface->normal(x)); }
  double nominal() const { return 2.0 * std::sqrt((2.0 * radius - height) * height); }
};

/** Patches of a fine grid, and the extent of the planes over them. */
std::vector<RowPatch>
patchesOf(const RowCut& cut, int cells, double& low, double& high)
{
  std::vector<double> at, most;
  for (int i = 0; i <= cells; ++i)
    for (int k = 0; k <= cells; ++k) {
      const Vector2d share(static_cast<double>(i) / cells, static_cast<double>(k) / cells);
      const Vector3d x = cut.surface->lift(cut.low + share.cwiseProduct(cut.high - cut.low));
      at.push_back(cut.across().dot(cut.led(x)));
      most.push_back(rowDistance(bendAt(*cut.surface, x), cut.across(), cut.radius, cut.height, cut.through));
    }
  std::vector<RowPatch> patches;
  for (int i = 0; i < cells; ++i)
    for (int k = 0; k < cells; ++k) {
      const std::size_t a = static_cast<std::size_t>(i) * (cells + 1) + k, c = a + cells + 1;
      const auto [least, largest] = std::minmax({at[a], at[a + 1], at[c], at[c + 1]});
      patches.push_back({least, largest, std::min({most[a], most[a + 1], most[c], most[c + 1]}), 1.0});
    }
  low = *std::min_element(at.begin(), at.end());
  high = *std::max_element(at.begin(), at.end());
  return patches;
}

/** Contacts \p spacing apart along the rows, over the rectangle and 3 mm beyond it. */
CheckedPath
ballPath(const RowCut& cut, const std::vector<double>& levels, double spacing = 0.1)
{
  CheckedPath path;
  const Vector3d along = cut.along(), across = cut.across();
  const Vector2d middle = 0.5 * (cut.low + cut.high);
  const double reach = 0.5 * (cut.high - cut.low).norm() + 3.0;
  const double begin = along.head<2>().dot(middle) - reach;
  for (const double level : levels) {
    const std::size_t first = path.size();
    for (int i = 0; i <= static_cast<int>(2.0 * reach / spacing); ++i) {
      const double u = begin + spacing * i;
      double v = level;
      for (int turn = 0; turn < 25; ++turn)
        v += level - across.dot(cut.led(cut.surface->lift((u * along + v * across).head<2>())));
      const Vector2d chart = (u * along + v * across).head<2>();
      if ((chart - middle).cwiseAbs().x() > 0.5 * (cut.high - cut.low).x() + 3.0 ||
          (chart - middle).cwiseAbs().y() > 0.5 * (cut.high - cut.low).y() + 3.0)
        continue;
      path.contacts.push_back(cut.surface->lift(chart));
      path.normals.push_back(cut.surface->normal(path.contacts.back()));
    }
    if (first > 0 && path.size() > first)
      path.lifted_to.push_back(first);
  }
  return path;
}

/** Heights left inside the rectangle, in h: at 99 %, 99.9 %, and the largest. */
std::array<double, 3>
heightsInside(const RowCut& cut, const std::vector<double>& levels, std::size_t samples)
{
  const CheckedPath path = ballPath(cut, levels);
  SweptBall ball{cut.radius, cut.height, 5.0, 2};
  std::vector<double> heights;
  for (const StockSample& s : heightsLeft(*cut.surface, path, ball, samples, 3)) {
    const Vector2d u = cut.surface->chart(s.x);
    if ((u - cut.low).minCoeff() > 0.2 && (cut.high - u).minCoeff() > 0.2)
      heights.push_back(s.stock / cut.height);
  }
  EXPECT_GT(heights.size(), samples / 2);
  return {quantile(heights, 0.99), quantile(heights, 0.999), quantile(heights, 1.0)};
}

/** Rows kept, with their ridges by brute force; returns the ratio of the number of rows to that of even steps. */
double
keptRowsLeave(const RowCut& cut, int cells, std::size_t samples, double least)
{
  double low = 0.0, high = 0.0;
  const std::vector<RowPatch> patches = patchesOf(cut, cells, low, high);
  const RowLevels rows = rowLevels(patches, low, high, 0.25 * cut.nominal());
  EXPECT_EQ(rows.held_share, 0.0);
  const double even = std::ceil((high - low) / cut.nominal());
  const auto [p99, p999, largest] = heightsInside(cut, rows.levels, samples);
  const double more = static_cast<double>(rows.levels.size()) / even;
  std::printf("  %zu rows for %.0f even ones, steps %.4f to %.4f mm: p99 %.4f h, p99.9 %.4f h, largest %.4f h\n", rows.levels.size(), even,
              rows.smallest_step, rows.largest_step, p99, p999, largest);
  EXPECT_LE(largest, 1.02);
  EXPECT_GE(largest, least);
  return more;
}

SurfacePtr
tilted(double slope_x, double slope_y)
{ // a wave so long that it is a plane to 1e-6 mm
  constexpr double k = 1e-6;
  const double slope = std::hypot(slope_x, slope_y);
  return waves({{slope / k, slope_x / slope * k, slope_y / slope * k, 0.0}}, Region({rectangle(20.0, 20.0)}));
}

} // namespace

TEST(RowDistance, OfAPlaneIsTheStepByItsSlopeAcross)
{
  const double step = 2.0 * std::sqrt(9.99 * 0.01);
  for (const double slope : {0.0, 0.3, 1.0, 4.0})
    for (const RowsThrough through : {RowsThrough::Contacts, RowsThrough::Centres}) {
      SurfaceBend plane;
      plane.normal = Vector3d(0.0, -slope, 1.0).normalized();
      EXPECT_NEAR(rowDistance(plane, Vector3d::UnitY(), 5.0, 0.01, through), step / std::hypot(1.0, slope), 1e-12);
      EXPECT_NEAR(rowDistance(plane, Vector3d::UnitX(), 5.0, 0.01, through), step, 1e-12);
    }
  EXPECT_EQ(rowDistance({}, Vector3d::UnitZ(), 5.0, 0.01, RowsThrough::Contacts), 0.0);
  SurfaceBend groove{Vector3d::UnitZ(), Vector3d::UnitX(), 0.0, -0.25};
  EXPECT_EQ(rowDistance(groove, Vector3d::UnitY(), 5.0, 0.01, RowsThrough::Centres), infinity);
}

/** Two circles of ball centres round the axis of a cylinder, or contacts: the ridge between them by the triangle.
 */
TEST(RowDistance, OfACylinderIsExactForLongSteps)
{
  constexpr double radius = 5.0, height = 0.5;
  for (const double rho : {-30.0, -8.0, 2.0, 12.0}) {
    const double a = rho + radius, b = rho + height;
    const double half = 0.5 * std::acos((a * a + b * b - radius * radius) / (2.0 * a * b)) * 2.0;
    const SurfaceBend top{Vector3d::UnitZ(), Vector3d::UnitY(), 1.0 / rho, 0.0};
    EXPECT_NEAR(rowDistance(top, Vector3d::UnitY(), radius, height, RowsThrough::Contacts), 2.0 * std::abs(rho) * std::sin(half), 1e-9);
    EXPECT_NEAR(rowDistance(top, Vector3d::UnitY(), radius, height, RowsThrough::Centres), 2.0 * std::abs(rho + radius) * std::sin(half),
                1e-9);
  }
}

TEST(RowDistance, LeavesTheRidgeOnPlanesSpheresAndTwistedSurfaces)
{
  const Vector2d half(10.0, 10.0);
  for (const RowsThrough through : {RowsThrough::Contacts, RowsThrough::Centres}) {
    keptRowsLeave({tilted(0.4, 0.8), -half, half, 0.0, 5.0, 0.01, through}, 60, 4000, 0.95);
    keptRowsLeave({ball(40.0, Region({rectangle(20.0, 20.0)})), -half, half, 20.0, 5.0, 0.01, through}, 60, 4000, 0.95);
    keptRowsLeave({quadric(12.0, -12.0, Region({rectangle(8.0, 8.0)})), -0.4 * half, 0.4 * half, 45.0, 5.0, 0.02, through}, 100, 8000,
                  0.85);
    keptRowsLeave({waves({{1.0, 0.35, 0.2, 0.3}}, Region({rectangle(20.0, 20.0)})), -half, half, 70.0, 3.0, 0.01, through}, 100, 8000,
                  0.95);
  }
}

/** The height over a place in the middle between two rows at the allowed distance. */
TEST(RowDistance, LeavesTheHeightMidway)
{
  const Region square({rectangle(20.0, 20.0)});
  for (const SurfacePtr& surface :
       {quadric(12.0, -12.0, square), quadric(-9.0, 30.0, square), tilted(0.9, 0.7), waves({{1.0, 0.35, 0.2, 1.9}}, square)})
    for (const RowsThrough through : {RowsThrough::Contacts, RowsThrough::Centres})
      for (const double direction : {0.0, 30.0, 45.0, 80.0}) {
        const RowCut cut{surface, {-3.0, -3.0}, {3.0, 3.0}, direction, 4.0, 0.01, through};
        const Vector3d x = surface->lift({0.0, 0.0});
        const double apart = rowDistance(bendAt(*surface, x), cut.across(), cut.radius, cut.height, through);
        const double middle = cut.across().dot(cut.led(x));
        double height = 0.0; // the mean of the heights that the two leave; they differ because the curvature changes
        for (const double side : {-0.5, 0.5}) {
          const CheckedPath path = ballPath(cut, {middle + side * apart}, 0.02);
          std::vector<Vector3d> centres;
          for (std::size_t i = 0; i < path.size(); ++i)
            centres.push_back(path.contacts[i] + cut.radius * path.normals[i]);
          const MoveTree moves(std::move(centres));
          height += 0.5 * StockField(*surface, moves, cut.radius, cut.height, 0.0).at(x).stock;
        }
        EXPECT_NEAR(height, cut.height, 0.02 * cut.height) << direction;
      }
}

TEST(RowDistance, KeepsTheScallopOfTheLandformWithFewRowsMore)
{
  for (const RowsThrough through : {RowsThrough::Contacts, RowsThrough::Centres})
    for (const double direction : {0.0, 90.0})
      EXPECT_LE(keptRowsLeave({landform(), {0.0, 0.0}, {100.0, 100.0}, direction, 5.0, 0.01, through}, 300, 25000, 0.97), 1.12);
}

} // namespace row_distance_test
