// SPDX-License-Identifier: BSD-3-Clause
// Flat faces beside fillets stay flat, and the fillets round: judged by the exact part.
#include "support/filleted_parts.h"
#include "support/random_vectors.h"
#include "support/solids.h"

#include <pcl_spiral/mesh/surface_mesh.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace flat_faces_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/** Largest distances, mm. */
struct Errors {
  double flat = 0.0;        ///< of curved faces that are flat in the part from the faces of the mesh
  double round = 0.0;       ///< of the other curved faces from the exact part
  double plain_round = 0.0; ///< of these as they are in the mesh from the exact part
};

Errors
errorsOf(const FilletedPart& part)
{
  SurfaceMesh::ConstPtr surface;
  const Status status = SurfaceMesh::make(*part.mesh.polygons(), {}, surface);
  EXPECT_TRUE(status.ok()) << status.message();
  EXPECT_EQ(surface->faceCount(), part.mesh.faces.size());
  Errors e;
  constexpr int steps = 8;
  for (std::size_t t = 0; t < surface->faceCount(); ++t) {
    const MeshPatch patch = surface->patch(t);
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const Vector3d share(double(i) / steps, double(j) / steps, double(steps - i - j) / steps);
        const double curved = part.distance(patch.position(share));
        if (part.is_flat[t])
          e.flat = std::max(e.flat, (patch.position(share) - patch.corners * share).norm());
        else {
          e.round = std::max(e.round, curved);
          e.plain_round = std::max(e.plain_round, part.distance(patch.corners * share));
        }
      }
  }
  return e;
}

RoundedProfile
trough(double radius, double facet, double up = 1.0)
{
  return RoundedProfile({{Vector2d(-40, 20 * up)},
                         {Vector2d(-20 - radius, 20 * up), radius},
                         {Vector2d(-20 - radius, 0), radius},
                         {Vector2d(20 + radius, 0), radius},
                         {Vector2d(20 + radius, 20 * up), radius},
                         {Vector2d(40, 20 * up)}},
                        facet);
}

/** From the middle outwards: a floor, a wall with a fillet at its foot and another above, and a rim. */
RoundedProfile
pocket(double foot, double top, double facet, double up = 1.0)
{
  return RoundedProfile({{Vector2d(2, 0)}, {Vector2d(12, 0), foot}, {Vector2d(12, 20 * up), top}, {Vector2d(30, 20 * up)}}, facet);
}

RoundedProfile
ringGroove(double radius, double facet)
{
  return RoundedProfile({{Vector2d(3, 0)},
                         {Vector2d(20, 0), radius},
                         {Vector2d(20, -15), radius},
                         {Vector2d(40, -15), radius},
                         {Vector2d(40, 0), radius},
                         {Vector2d(55, 0)}},
                        facet);
}

struct Case {
  std::string name;
  FilletedPart part;
};

std::vector<Case>
cases()
{
  std::vector<Case> all;
  SweepGuide line, split_line, round, plan;
  line.half = {0, 30};
  split_line = line;
  split_line.parts = 6;
  round.form = plan.form = SweepGuide::Form::Rectangle;
  plan.half = {15, 10};
  for (const double facet : {2.0, 5.0, 10.0, 15.0}) {
    round.facet = plan.facet = facet;
    const std::string degrees = std::to_string(static_cast<int>(facet));
    for (const double radius : {3.0, 8.0})
      for (const double up : {1.0, -1.0}) {
        const std::string which = (up > 0 ? "hollow " : "high ") + std::to_string(static_cast<int>(radius)) + " " + degrees;
        all.push_back({"along a line " + which, sweptPart(trough(radius, facet, up), line)});
        all.push_back({"cut in parts " + which, sweptPart(trough(radius, facet, up), split_line)});
        for (const bool split : {false, true}) {
          plan.split_floor = round.split_floor = split;
          all.push_back({"rectangle " + which + (split ? " split" : ""), sweptPart(pocket(radius, radius, facet, up), plan)});
          all.push_back({"circle " + which + (split ? " split" : ""), sweptPart(pocket(radius, radius, facet, up), round)});
        }
      }
    all.push_back({"3 and 8 " + degrees, sweptPart(pocket(3, 8, facet), plan)});
    all.push_back({"8 and 3 " + degrees, sweptPart(pocket(8, 3, facet, -1), plan)});
    all.push_back({"groove " + degrees, sweptPart(ringGroove(3, facet), round)});
  }
  return all;
}

} // namespace

TEST(FlatFaces, StayFlatBesideFilletsThatAreRound)
{
  for (const Case& c : cases()) {
    const Errors e = errorsOf(c.part);
    EXPECT_LT(e.flat, 1e-4) << c.name;
    EXPECT_LT(e.round, 0.2 * e.plain_round) << c.name << ": plain " << e.plain_round;
  }
}

TEST(FlatFaces, StayFlatHoweverThePartIsTurned)
{
  SweepGuide plan;
  plan.form = SweepGuide::Form::Rectangle;
  plan.half = {15, 10};
  Random random(7);
  for (int i = 0; i < 3; ++i) {
    Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
    turned.translate(randomVector(random, 50.0));
    turned.rotate(Eigen::AngleAxisd(random.uniform(0.3, 3.0), randomUnit(random)));
    for (const double facet : {5.0, 10.0}) {
      plan.facet = facet;
      const Errors e = errorsOf(placedPart(sweptPart(pocket(3, 3, facet), plan), turned));
      EXPECT_LT(e.flat, 1e-4);
      EXPECT_LT(e.round, 0.2 * e.plain_round);
    }
  }
}

/** Files in text have few digits: a floor of many faces, turned, is then not exactly flat. */
TEST(FlatFaces, StayFlatInFilesWithFewDigits)
{
  SweepGuide split;
  split.half = {0, 30};
  split.parts = 7;
  Eigen::Isometry3d turned = Eigen::Isometry3d::Identity();
  turned.translate(Vector3d(2.0, 12.0, -1.0));
  turned.rotate(Eigen::AngleAxisd(0.35, Vector3d(0.8, 0.5, 0.2).normalized()));
  const auto digits = [](const char* format, double x) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), format, x);
    return std::strtod(text.data(), nullptr);
  };
  for (const double facet : {2.0, 10.0})
    for (const char* format : {"%.6g", "%.5e", "%.4f", "%.3f"}) {
      FilletedPart part = placedPart(sweptPart(trough(8.0, facet), split), turned);
      for (Vector3d& v : part.mesh.vertices)
        v = Vector3d(digits(format, v.x()), digits(format, v.y()), digits(format, v.z()));
      const Errors e = errorsOf(part);
      EXPECT_LT(e.flat, 1e-4) << format << " " << facet;
      EXPECT_LT(e.round, 0.2 * e.plain_round + (std::string(format) == "%.3f" ? 0.002 : 0.0)) << format << " " << facet;
    }
}

} // namespace flat_faces_test
