// SPDX-License-Identifier: BSD-3-Clause
// Spirals that are refused or warned of for the sake of the path: each remedy that the message names helps.
#include "support/sampling.h"
#include "support/spiral_jobs.h"
#include "support/surfaces.h"

#include <gtest/gtest.h>

namespace path_remedies_test {
namespace {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

/** Rings of a hundred points, each larger than the one before: the spacing grows with the radius. */
ScanPtr
graded()
{
  Random random(12);
  std::vector<Vector3d> points;
  for (double r = 1e-2; r < 200.0; r *= 1.1)
    for (int i = 0; i < 100; ++i) {
      const double angle = 2.0 * M_PI * (i + 0.4 * random.uniform(-1.0, 1.0)) / 100.0;
      points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
    }
  return toCloud(points);
}

/** A plate, noisy in depth where x > 0. */
ScanPtr
halfNoisy()
{
  const ScanPtr scan = plate();
  std::mt19937 random(5);
  std::uniform_real_distribution<float> height(-4.0f, 4.0f);
  for (auto& p : *scan)
    p.z += p.x > 0.0f ? height(random) : 0.0f;
  return scan;
}

} // namespace

TEST(PathRemedies, ThePath)
{
  const auto large = [] { // in another unit
    const ScanPtr scan = plate();
    for (auto& p : *scan)
      p.getVector3fMap() *= 30.0f;
    return scan;
  };
  const auto tiny = [](Spiral& s) { s.setToolRadius(0.01), s.setScallopHeight(0.005); };
  const auto far = [] {
    const ScanPtr scan = plate();
    for (auto& p : *scan)
      p.x += 2e5f;
    return scan;
  };
  const auto wavy = [] {
    return toCloud(sampleUniform(*waves({{1.0, 0.25, 0.0, 0.0}}, Region({rectangle(60.0, 45.0)})), 15000, 7).points);
  };
  expectNoFaults({
      spiralOver(large, "this path would be too large", tiny,
                 {{"ReadOptions::unit",
                   [](Spiral& s) {
                     s.setInputCloud(plate(0.4, 0.03)); // in the unit of the tool
                   }},
                  {"setToolRadius", [](Spiral& s) { s.setToolRadius(1000.0); }}}),
      spiralOver(disc, "this path would be too large", [](Spiral& s) { s.setScallopHeight(1e-14); },
                 {{"setScallopHeight", [](Spiral& s) { s.setScallopHeight(0.05); }}}),
      spiralOver(disc, "this path would be too large", [](Spiral& s) { s.setMaxStep(1e-7); },
                 {{"setMaxStep", [](Spiral& s) { s.setMaxStep(3.0); }}}),
      spiralOver(far, "are so large that single precision rounds", {}, {{"setChordError", [](Spiral& s) { s.setChordError(0.1); }}}),
      spiralOver(wavy, "and the surface then lies", [](Spiral& s) { s.setThinning(6.0), s.setToolRadius(5.0); },
                 {{"setThinning", [](Spiral& s, const Diagnostic& said) { s.setThinning(said.numbers().at(3)); }},
                  {"setScallopHeight", [](Spiral& s, const Diagnostic& said) { s.setScallopHeight(1.05 * said.numbers().back()); }}}),
      spiralOver([] { return plate(); }, "from the given start point",
                 [](Spiral& s) {
                   s.setStartPoint({60.0, 0.0, 0.0});
                 },
                 {{"setStartPoint", [](Spiral& s) { s.clearStartPoint(); }}}),
      spiralOver(halfNoisy, "the {scan} is disconnected", {}, {{"setCrop", crop(box(-15.0, -7.0, -15.0, 15.0))}}),
      spiralOver(graded, "the {scan} is disconnected", [](Spiral& s) { s.setToolRadius(100.0), s.setScallopHeight(3.0); },
                 {{"setThinning", [](Spiral& s) { s.setThinning(12.0); }}}),
  });
}

TEST(PathRemedies, WhichMethod)
{
  const auto arc = [] {
    PlaneLoop loop; // about the middle of its circle, radial turns cross
    for (const double side : {1.0, -1.0})
      for (int i = 0; i <= 400; ++i) {
        const double t = side * 1.2 * (-1.0 + i / 200.0);
        loop.emplace_back((30.0 + 8.0 * side) * std::cos(t), (30.0 + 8.0 * side) * std::sin(t));
      }
    return toCloud(sampleUniform(*flat(Region({loop})), 5000, 3).points);
  };
  const auto harmonic = [](Spiral& s) { s.setLineMethod(LineMethod::Harmonic); };
  const auto without = [](Spiral& s) {
    s.setLineMethod(LineMethod::Automatic), s.clearCenter(), s.setMethod(SpiralMethod::ConstantScallop);
  };
  const auto holes = [] { // few points about them
    const Region part({rectangle(40.0, 24.0), circle({-10.0, 1.0}, 3.0), circle({3.0, -5.0}, 2.5), circle({11.0, 4.0}, 3.0)});
    return toCloud(sampleUniform(*flat(part), 900, 10).points);
  };
  const auto scallop = [](Spiral& s) {
    s.setToolRadius(5.0), s.setHoleSize(3.5), s.setScallopHeight(0.1), s.setMethod(SpiralMethod::ConstantScallop);
  };
  const auto joined = [] { return besideWall(2.0); };
  expectNoFaults({
      spiralOver(arc, "the radial lines there are not in order", method(SpiralMethod::Radial), {{"setMethod", without}}),
      spiralOver([] { return plate(); }, "the path turns back by ", harmonic, {{"setMethod", without}, {"setLineMethod", without}}),
      spiralOver(disc, "usually makes a shorter path",
                 [](Spiral& s) {
                   s.setCenter({14.0, 0.0, 0.0});
                 },
                 {{"setMethod", without}}),
      spiralOver(holes, "else choose another scallop height", scallop,
                 {{"setScallopHeight", [](Spiral& s) { s.setScallopHeight(0.05); }},
                  {"setSense", [](Spiral& s) { s.setSense(SpiralSense::Clockwise); }}}),
      spiralOver([] { return besideWall(2.0, true); }, "else choose another scallop height",
                 [](Spiral& s) { s.setPartAt(Vector3d::Zero()); }, {{"setCrop", crop(box(-16.0, 8.0, -16.0, 16.0))}}),
      spiralOver(joined, "both methods fail here", [](Spiral& s) { s.setPartAt(Vector3d::Zero()); },
                 {{"PartRegion", crop(box(-16.0, 8.0, -16.0, 16.0))},
                  {"setMethod", method(SpiralMethod::Radial), "the {scan} is no single sheet"}}),
  });
}

TEST(PathRemedies, ToolAxes)
{
  expectNoFaults({
      spiralOver([] { return plate(); }, "and the shank would touch the part", [](Spiral& s) { s.setFixedAxis(Vector3d::UnitX()); },
                 {{"setFixedAxis", [](Spiral& s) { s.setFixedAxis(Vector3d::UnitZ()); }}}),
      spiralOver(dome, "per {mm}: raise the axis rate", [](Spiral& s) { s.setMaxAxisRate(0.1); },
                 {{"setMaxAxisRate", [](Spiral& s) { s.setMaxAxisRate(20.0); }}}),
  });
}

TEST(PathRemedies, TheHolder)
{
  const auto chuck = [](double width, double flank) {
    return [=](Spiral& s) {
      s.setHolder({ToolSegment::cylinder(width, 30.0, "chuck")});
      s.setFlankLength(flank);
    };
  };
  const auto tilted = [&](Spiral& s) { chuck(8.0, 10.0)(s), s.setTiltAngle(-70.0); };
  const auto led = [&](Spiral& s) { chuck(8.0, 10.0)(s), s.setTiltAngle(0.0), s.setLeadAngle(70.0); };
  const auto fixed = [&](Spiral& s) { chuck(8.0, 10.0)(s), s.setFixedAxis({0.0, 0.94, 0.34}); };
  const auto accept = [](Spiral& s) { s.setAcceptCollisions(true); };
  expectNoFaults({
      spiralOver(disc, "lean the tool another way ({setTiltAngle}", tilted,
                 {{"setTiltAngle", [](Spiral& s) { s.setTiltAngle(10.0); }},
                  {"setFlankLength", chuck(8.0, 40.0)},
                  {"setHolder", chuck(3.0, 10.0)},
                  {"setAcceptCollisions", accept}}),
      spiralOver(disc, "lean the tool another way ({setTiltAngle}", led, {{"setLeadAngle", [](Spiral& s) { s.setLeadAngle(0.0); }}}),
      spiralOver(disc, "lean the tool another way ({setFixedAxis}", fixed,
                 {{"setFixedAxis", [](Spiral& s) { s.setFixedAxis(Vector3d::UnitZ()); }},
                  {"setFlankLength", chuck(8.0, 40.0)},
                  {"setHolder", chuck(3.0, 10.0)},
                  {"setAcceptCollisions", accept}}),
  });
}

} // namespace path_remedies_test
