// SPDX-License-Identifier: BSD-3-Clause
// Scans over which no spiral is found, or only with a warning: each remedy that the message names helps.
#include "support/sampling.h"
#include "support/spiral_jobs.h"
#include "support/surfaces.h"
#include "support/tight_parts.h"

#include <gtest/gtest.h>

namespace scan_remedies_test {
namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

/** A plate on which a block 4 mm wide and \p height high stands at (5, 0), seen from above. */
ScanPtr
withBlock(double height)
{
  const ScanPtr scan =
      plateWithout([](double x, double y) { return std::hypot(x, y) > 15.0 || (std::abs(x - 5.0) < 2.0 && std::abs(y) < 2.0); });
  addSheet(
      2.0, 2.0, 0.8, [&](double u, double v) { return Vector3d(5.0 + u, v, height); }, *scan);
  return scan;
}

/** A plate with the arch of a tube on it. */
ScanPtr
arch()
{
  const ScanPtr scan = plateWithout([](double x, double y) { return std::abs(std::abs(x) - 6.0) < 2.0 && std::abs(y) < 2.0; }, 15.0, 0.5);
  const double turn = M_PI / 12.0; // of the tube, between points
  for (int i = 0; i <= 38; ++i)
    for (int k = 0; k < 24; ++k) {
      const double along = i / 38.0 * M_PI, round = turn * (k + 0.5 * (i % 2)), r = 6.0 + 2.0 * std::cos(round);
      scan->emplace_back(static_cast<float>(r * std::cos(along)), static_cast<float>(2.0 * std::sin(round)),
                         static_cast<float>(r * std::sin(along)));
    }
  return scan;
}

/** Two plates side by side. */
ScanPtr
twoPlates()
{
  const ScanPtr scan = plate(8.0);
  addSheet(
      8.0, 8.0, 0.8, [](double u, double v) { return Vector3d(u + 60.0, v, 0.0); }, *scan);
  return scan;
}

} // namespace

TEST(ScanRemedies, HolesAndGaps)
{
  const auto ring = [] { return withHole(5.0); };
  const auto gap = [] { return withHole(2.4); };
  const auto isHole = [](Spiral& s) { s.setHoleSize(6.0); };
  expectNoFaults({
      spiralOver(ring, "but holes are refused", [&](Spiral& s) { isHole(s), s.setHoleHandling(HoleHandling::Refuse); },
                 {{"setHoleHandling", [](Spiral& s) { s.setHoleHandling(HoleHandling::Over); }}}),
      spiralOver(gap, "has a gap at", [](Spiral& s) { s.setGapHandling(GapHandling::Refuse); },
                 {{"setGapHandling", [](Spiral& s) { s.setGapHandling(GapHandling::Bridge); }}}),
      spiralOver(ring, "a margin about holes is asked",
                 [&](Spiral& s) {
                   isHole(s);
                   s.setHoleMargin(1.0);
                   s.setMethod(SpiralMethod::Radial);
                 },
                 {{"setHoleMargin", [](Spiral& s) { s.setHoleMargin(0.0); }}, {"setMethod", method(SpiralMethod::ConstantScallop)}}),
      spiralOver(gap, "smallest width of a hole", {}, {{"setHoleSize", [](Spiral& s) { s.setHoleSize(2.0); }}}),
      spiralOver([] { return withHole(3.0, 0.0, 0.6); }, "nothing is left of the surface",
                 [](Spiral& s) { s.setHoleSize(4.0), s.setHoleMargin(13.0); },
                 {{"setHoleMargin", [](Spiral& s) { s.setHoleMargin(1.0); }}}),
      spiralOver([] { return plate(); }, "nothing is left of the surface", [](Spiral& s) { s.setRimOverhang(-16.0); },
                 {{"setRimOverhang", [](Spiral& s) { s.setRimOverhang(-0.5); }}}),
      spiralOver(
          [] { return withHole(3.0, 9.0, 0.6); }, "meets another outline at", [](Spiral& s) { s.setHoleSize(4.0), s.setRimOverhang(-3.5); },
          {{"setRimOverhang", [](Spiral& s) { s.setRimOverhang(-0.5); }}, {"setHoleMargin", [](Spiral& s) { s.setHoleMargin(0.5); }}}),
      spiralOver([] { return withHole(6.0, 7.5); }, "the surface between two outlines is only",
                 [](Spiral& s) { s.setHoleSize(5.0), s.setMethod(SpiralMethod::ConstantScallop); },
                 {{"addKeepOut", keepOutOf(1)}, {"setMethod", method(SpiralMethod::Radial)}}),
      spiralOver([] { return plateWithout([](double x, double y) { return std::hypot(x - 7.8, y) < 6.0; }); }, // a rim with corners
                 "the surface between two outlines is only", [](Spiral& s) { s.setHoleSize(5.0); },
                 {{"setMethod", method(SpiralMethod::Radial)}}),
      spiralOver(arch, "the surface has a handle", [](Spiral& s) { s.setToolRadius(1.5), s.setMethod(SpiralMethod::ConstantScallop); },
                 {{"addKeepOut", keepOut(box(-9.0, 9.0, -3.0, 3.0))}, {"setCrop", crop(box(-15.0, 15.0, 6.0, 15.0))}}),
  });
}

TEST(ScanRemedies, WhatStandsBesideThePart)
{
  expectNoFaults({
      spiralOver([] { return besideWall(3.5); }, ", beside what is cut. ",
                 [](Spiral& s) { s.setPartAt(Vector3d::Zero()), s.setToolRadius(5.0); },
                 {{"addKeepOut", keepOut(box(17.0, 20.0, -11.0, 11.0))}}),
      spiralOver([] { return besideWall(9.5); }, ", beside what is cut. ",
                 [](Spiral& s) { s.setPartAt(Vector3d::Zero()), s.setToolRadius(5.0); },
                 {{"addKeepOut", keepOut(box(23.0, 26.0, -11.0, 11.0))}, {"setTiltAngle", [](Spiral& s) { s.setTiltAngle(0.0); }}}),
      spiralOver(twoPlates, "; keep only the largest one", {},
                 {{"setLargestPart", [](Spiral& s) { s.setLargestPart(true); }},
                  {"setPartAt",
                   [](Spiral& s) {
                     s.setPartAt({60.0, 0.0, 0.0});
                   }}}),
      spiralOver(twoPlates, "if another one is to be machined", [](Spiral& s) { s.setLargestPart(true); },
                 {{"setPartAt",
                   [](Spiral& s) {
                     s.setPartAt({60.0, 0.0, 0.0});
                   }}}),
  });
}

TEST(ScanRemedies, WhatStandsOnThePart)
{
  const auto low = [] { return withBlock(1.2); };
  const auto on_another = [] {
    const ScanPtr scan = withBlock(1.2);
    addSheet(
        8.0, 8.0, 0.8, [](double u, double v) { return Vector3d(u + 60.0, v, 0.0); }, *scan);
    return scan;
  };
  const auto ride = [](Spiral& s) { s.setClusterHandling(ClusterHandling::Ride); };
  const auto leave = [](Spiral& s) { s.setClusterHandling(ClusterHandling::LeaveOut); };
  expectNoFaults({
      spiralOver(on_another, "a path would go through what is there",
                 [](Spiral& s) {
                   s.setPartAt({-5.0, 0.0, 0.0});
                 },
                 {{"addKeepOut", keepOut(box(2.0, 8.0, -3.0, 3.0))},
                  {"setClusterHandling(ClusterHandling::Ride)", ride},
                  {"setClusterHandling(ClusterHandling::LeaveOut)", leave},
                  {"setPartAt",
                   [](Spiral& s) {
                     s.setPartAt({60.0, 0.0, 0.0});
                   }}}),
      spiralOver([] { return withBlock(2.4); }, "hides the surface: only its top is seen", ride,
                 {{"addKeepOut", keepOut(box(2.0, 8.0, -3.0, 3.0))}, {"setClusterHandling(ClusterHandling::LeaveOut)", leave}}),
      spiralOver(low, "does not ride over the clusters", [&](Spiral& s) { ride(s), s.setMethod(SpiralMethod::Published); },
                 {{"setClusterHandling(ClusterHandling::Ride)", leave}, {"setMethod", method(SpiralMethod::Shortest)}}),
      spiralOver(low, "refuses to lift it", [&](Spiral& s) { ride(s), s.setTightHandling(TightHandling::Refuse); },
                 {{"setClusterHandling(ClusterHandling::Ride)", leave},
                  {"setTightHandling(TightHandling::Refuse)", [](Spiral& s) { s.setTightHandling(TightHandling::Ride); }}}),
  });
}

TEST(ScanRemedies, TightPlaces)
{
  const auto narrow = [] { return valley(0.7, 2.0, 9.0, 9.0).scan(0.4, 0.0, 11); };
  const auto fits = [](Spiral& s) { s.setToolRadius(1.8); };
  expectNoFaults({
      spiralOver(narrow, "the cutter would gouge", [](Spiral& s) { s.setTightHandling(TightHandling::Refuse); },
                 {{"setTightHandling", [](Spiral& s) { s.setTightHandling(TightHandling::Ride); }}, {"setToolRadius", fits}}),
      spiralOver(narrow, "reaches everything", {},
                 {{"setToolRadius", fits},
                  {"BallReach", fits}, // maps that radius
                  {"setTightHandling(TightHandling::Refuse)", [](Spiral& s) { s.setTightHandling(TightHandling::Refuse); },
                   "the cutter would gouge"}}),
      spiralOver(narrow, "reaches only", [](Spiral& s) { s.setToolRadius(20.0); }, {{"setToolRadius", fits}}),
  });
}

TEST(ScanRemedies, Sides)
{
  const auto leaning = [](double slope) {
    return [slope] {
      const ScanPtr scan(new pcl::PointCloud<pcl::PointXYZ>);
      addSheet(
          9.0, 9.0, 0.8, [&](double u, double v) { return Vector3d(u, 0.01 * u * u + slope * v, v); }, *scan);
      return scan;
    };
  };
  const SpiralChange mixed = [](Spiral& s) {
    const auto given = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
    for (std::size_t i = 0; i < plate()->size(); ++i)
      given->push_back(pcl::Normal(0.0f, 0.0f, i % 3 == 0 ? 1.0f : -1.0f));
    s.setInputNormals(given);
  };
  expectNoFaults({
      spiralOver(leaning(0.3), "the outer side was taken from +z, but this is not clear", {},
                 {{"setViewPoint",
                   [](Spiral& s) {
                     s.setViewPoint({0.0, -90.0, 20.0});
                   }},
                  {"setFlipNormals", [](Spiral& s) { s.setFlipNormals(true); }}}),
      spiralOver(leaning(0.0), "+z does not show the outer side", {},
                 {{"setViewPoint",
                   [](Spiral& s) {
                     s.setViewPoint({0.0, -90.0, 20.0});
                   }},
                  {"setFlipNormals", [](Spiral& s) { s.setFlipNormals(true); }}}),
      spiralOver(dome, "of the area faces away from the view point",
                 [](Spiral& s) {
                   s.setViewPoint({30.0, 0.0, 5.0});
                 },
                 {{"setViewPoint",
                   [](Spiral& s) {
                     s.setViewPoint({0.0, 0.0, 90.0});
                   }},
                  {"setFlipNormals", [](Spiral& s) { s.setFlipNormals(true); }}}),
      spiralOver([] { return plate(); }, "the input normals have no common side", mixed,
                 {{"setInputNormals", [](Spiral& s) { s.setInputNormals(nullptr); }}}),
      spiralOver([] { return plate(); }, "the given normals have no common side",
                 [mixed](Spiral& s) { mixed(s), s.setTrustNormals(false); },
                 {{"setViewPoint",
                   [](Spiral& s) {
                     s.setViewPoint({0.0, 0.0, 90.0});
                   }}}),
  });
}

} // namespace scan_remedies_test
