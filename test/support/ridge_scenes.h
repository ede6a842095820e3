// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Ridges to draw, and places to check in their pictures.
 */
#pragma once

#include <pcl_spiral/visualization/ridge_picture.h>

#include "support/made_ridge.h"
#include "support/picture_pixels.h"
#include "support/ridges.h"

#include <cmath>
#include <functional>
#include <map>
#include <string>

namespace pcl_spiral::test {

constexpr double degree = M_PI / 180.0;
constexpr int part_end = 1180; ///< column of pixels; text is right of it

inline RidgeScene
sceneOf(const Polyline& rail, const Polyline& generator)
{
  return {"part", madeRidge(rail, generator), rail, generator, nullptr};
}

inline RidgeScene
dieScene()
{
  const ExactRidge exact = dieRidge();
  return sceneOf(moved(exact.railPoints(300), 0.02, 1), moved(exact.generatorPoints(0.37, 60), 0.02, 2));
}

/** Of radius 50, level; the chord rises by 20 degrees. */
inline RidgeScene
ringScene()
{
  const ExactRidge exact = ringRidge(
      50.0, [](double w) { return Eigen::Vector3d(0.0, 24.0 * w, 16.0 * w * (1.0 - w)); }, 20.0 * degree);
  Polyline rail = exact.railPoints(315);
  rail.pop_back();
  return sceneOf(rail, exact.generatorPoints(0.2, 60));
}

/** Of radius 100 and slope 20 degrees, a straight generator 20 mm long, inward or outward, that falls by 15 degrees. */
inline RidgeScene
helixScene(bool inward = true)
{
  ExactRidge exact = helixRidge(
      100.0, 20.0 * degree, [](double w) { return Eigen::Vector3d(0.0, 20.0 * w, 0.0); }, -15.0 * degree);
  if (!inward) {
    exact.reference = -Eigen::Vector3d::UnitZ();
    exact.theta = 15.0 * degree;
  }
  return sceneOf(exact.railPoints(600), exact.generatorPoints(0.37, 41));
}

using Matches = std::function<bool(const Pixel&)>;

inline std::size_t
countOf(const std::map<Pixel, std::size_t>& counts, const Matches& matches)
{
  std::size_t count = 0;
  for (const auto& [pixel, times] : counts)
    count += matches(pixel) ? times : 0;
  return count;
}

inline void
expectWordsInside(const std::string& file)
{
  const auto image = readPicture(file);
  for (int y = 0; y < 1200; ++y)
    for (const int x : {0, 1, 2, 1590, 1594, 1597, 1598, 1599})
      ASSERT_TRUE(isWhite(at(image, x, y))) << file << ' ' << x << ' ' << y;
}

} // namespace pcl_spiral::test
