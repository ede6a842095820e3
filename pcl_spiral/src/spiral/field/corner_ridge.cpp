// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/spiral/impl/turn_function.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

/** Largest distance from two turns whose tips lie 1 apart, at a corner with these angles between its radial line and its sides:
 *  the smaller root t of t^2 (1 - sin^2 a) - 2 t cos b + 1 = 0, times sin a. */
double
farthestFromTurns(double alpha1, double alpha2)
{
  const double sine = std::sin(0.5 * (alpha1 + alpha2)), cosine = std::cos(0.5 * (alpha1 - alpha2));
  const double root = std::sqrt(std::max(0.0, cosine * cosine - (1.0 - sine * sine)));
  return sine / (cosine + root);
}

} // namespace

CornerRidge
TurnFunction::highestCornerRidge() const
{
  CornerRidge highest;
  const double radius = settings_.tool_radius, turns = static_cast<double>(turns_);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto& feet = lines_[i].feet;
    if (!lines_[i].corner)
      continue;
    for (std::size_t k = 1; k + 1 < feet.size(); ++k) {
      if (turns * stations_[i][k].share < 1.0)
        continue;
      const Eigen::Vector3d chord = feet[k + 1].position - feet[k - 1].position, &normal = feet[k].normal;
      const Eigen::Vector3d along = (chord - chord.dot(normal) * normal).normalized();
      const auto angle = [&](int side) { // between the line and the turn
        const auto contour = contourDirection(i, k, side);
        return contour ? std::asin(std::min(1.0, std::abs(along.dot(normal.cross(*contour).normalized())))) : 0.0;
      };
      const double apart = lines_[i].length() / (turns * stations_[i][k].rate);
      const double step = 2.0 * apart * farthestFromTurns(angle(-1), angle(1)), curvature = feet[k].normalCurvature(along);
      const double allowed = stepOver(radius, curvature, settings_.scallop_height).value_or(step);
      if (!(step > highest.widening * allowed))
        continue;
      highest.widening = step / allowed;
      highest.height = scallopHeight(radius, curvature, step).value_or(radius);
      highest.remedy = scallopHeight(radius, curvature, allowed / highest.widening).value_or(0.0);
      highest.corner = feet.back().position;
    }
  }
  return highest;
}

} // namespace pcl_spiral
