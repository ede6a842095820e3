// SPDX-License-Identifier: BSD-3-Clause
// The picture of the normals of a ridge: angles by the formula, and their colours.
#include <pcl_spiral/visualization/pictures.h>
#include <pcl_spiral/visualization/ridge_picture.h>

#include "support/ridge_scenes.h"
#include "support/scratch_folder.h"
#include "visualization/canvas.h"
#include "visualization/normal_error.h"
#include "visualization/ridge_display.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>

#include <cmath>

namespace ridge_normals_picture_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

/** Error of the published normal on the helix, \p b mm along the chord, degrees. */
double
formula(double b, bool inward)
{
  const double slope = 20.0 * degree, radius = 100.0, psi = std::asin(std::sin(-15.0 * degree) / std::cos(slope));
  const double twist = std::sin(slope) * std::cos(slope) / radius;
  const double omega3 = (inward ? 1.0 : -1.0) * std::cos(slope) * std::cos(slope) / radius * std::cos(psi);
  return std::atan(twist * b / (1.0 - omega3 * b)) / degree;
}

} // namespace

TEST(RidgeNormalsPicture, AnglesOfNormalsAreThoseOfTheFormula)
{
  for (const bool inward : {true, false}) {
    const RidgeScene scene = helixScene(inward);
    const NormalErrors errors = normalErrors(*scene.ridge);
    ASSERT_EQ(errors.places.size(), errors.most.size());
    // the generator runs so that up is on the side of the reference: outward its chord leads back to the rail
    const Vector3d start = scene.ridge->generator().position(0.0), end = scene.ridge->generator().position(20.0);
    EXPECT_NEAR(inward ? start.norm() : end.norm(), 0.0, 1e-6);
    for (std::size_t k = 0; k < errors.places.size(); ++k) {
      const double b = inward ? errors.places[k] : 20.0 - errors.places[k];
      EXPECT_NEAR(errors.most[k], formula(b, inward), 1e-3) << b;
      EXPECT_NEAR(errors.least[k], formula(b, inward), 1e-3) << b;
    }
    EXPECT_NEAR(errors.largest, inward ? 4.43 : 3.15, 0.01);
  }
}

TEST(RidgeNormalsPicture, ColoursTellTheAngle)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  const RidgeScene scene = helixScene();
  writeRidgeNormals(folder.path("a.png"), scene);
  const auto image = readPicture(folder.path("a.png"));
  const DisplaySurface surface = ridgeDisplay(scene.ridge, [](double, double) { return 0.0; });
  const Canvas canvas(surface);
  const auto colors = colorScale(0.0, 4.5);
  for (double u = 250.0; u < 450.0; u += 10.0) // seen from above there
    for (const double v : {3.0, 8.0, 13.0, 17.0}) {
      const Vector2d place = canvas.onScreen(scene.ridge->position(u, v));
      const Pixel pixel = at(image, static_cast<int>(place.x()), static_cast<int>(place.y()));
      Vector3d wanted, is(pixel[0], pixel[1], pixel[2]);
      colors->GetColor(formula(v, true), wanted.data());
      EXPECT_LT((is.normalized() - wanted.normalized()).norm(), 0.06) << u << ' ' << v << ": " << is.transpose(); // light makes it darker
    }
  expectWordsInside(folder.path("a.png"));
}

TEST(RidgeNormalsPicture, WithoutTwistBothNormalsAreOne)
{
  if (!displayProblem().empty())
    GTEST_SKIP() << "no display here";
  const ScratchFolder folder;
  writeRidgeNormals(folder.path("a.png"), ringScene());
  const auto counts = colorsOf(folder.path("a.png"), 0, part_end);
  const auto is_low = [](const Pixel& p) { return p[2] > p[1] + 30 && p[0] > p[1]; };
  const auto is_more = [](const Pixel& p) { return p[1] > p[0] + 40 && p[1] > 80; };
  EXPECT_GT(countOf(counts, is_low), 100000u);
  EXPECT_EQ(countOf(counts, is_more), 0u);
  writeRidgeNormals(folder.path("b.png"), dieScene());
  EXPECT_GT(countOf(colorsOf(folder.path("b.png"), 0, part_end), is_more), 500u) << "twists";
  expectWordsInside(folder.path("a.png"));
  expectWordsInside(folder.path("b.png"));
}

} // namespace ridge_normals_picture_test
