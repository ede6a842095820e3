#include <pcl_spiral/core/step_over.h>
#include <pcl_spiral/toolpath/turn_function.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

CornerRidge
TurnFunction::highestCornerRidge() const
{
  CornerRidge highest;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto& feet = lines_[i].feet;
    if (!lines_[i].corner)
      continue;
    for (std::size_t k = 1; k + 1 < feet.size(); ++k) {
      const Eigen::Vector3d chord = feet[k + 1].position - feet[k - 1].position, &normal = feet[k].normal;
      const Eigen::Vector3d along = (chord - chord.dot(normal) * normal).normalized();
      double sine = 0.0; // of alpha, on the side where it is larger
      for (const int side : {-1, 1})
        if (const auto contour = contourDirection(i, k, side))
          sine = std::max(sine, std::abs(along.dot(normal.cross(*contour).normalized())));
      const double apart = lines_[i].length() / (static_cast<double>(turns_) * stations_[i][k].rate);
      const double farthest = apart * sine / (1.0 + sine), radius = settings_.tool_radius;
      const double height = scallopHeight(radius, feet[k].normalCurvature(along), 2.0 * farthest).value_or(radius);
      if (height > highest.height)
        highest = {height, feet[k].position};
    }
  }
  return highest;
}

} // namespace pcl_spiral
