#include <pcl_spiral/core/enclosing_circle.h>

#include <cmath>

namespace pcl_spiral {
namespace {

bool
holds(const Circle& circle, const Eigen::Vector2d& p)
{
  return (p - circle.centre).norm() <= circle.radius * (1.0 + 1e-12);
}

Circle
throughTwo(const Eigen::Vector2d& a, const Eigen::Vector2d& b)
{
  return {0.5 * (a + b), 0.5 * (a - b).norm()};
}

Circle
throughThree(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c)
{
  const Eigen::Vector2d u = b - a, v = c - a;
  const double twice_area = 2.0 * (u.x() * v.y() - u.y() * v.x());
  if (std::abs(twice_area) <= 1e-14 * (u.squaredNorm() + v.squaredNorm())) { // on a line: the two farthest
    Circle best = throughTwo(a, b);
    for (const Circle& other : {throughTwo(a, c), throughTwo(b, c)})
      if (other.radius > best.radius)
        best = other;
    return best;
  }
  const Eigen::Vector2d offset((v.y() * u.squaredNorm() - u.y() * v.squaredNorm()) / twice_area,
                               (u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) / twice_area);
  return {a + offset, offset.norm()};
}

} // namespace

Circle
smallestEnclosingCircle(const std::vector<Eigen::Vector2d>& points)
{
  Circle circle;
  if (points.empty())
    return circle;
  circle.centre = points[0];
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (holds(circle, points[i]))
      continue;
    circle = {points[i], 0.0};
    for (std::size_t j = 0; j < i; ++j) {
      if (holds(circle, points[j]))
        continue;
      circle = throughTwo(points[i], points[j]);
      for (std::size_t k = 0; k < j; ++k)
        if (!holds(circle, points[k]))
          circle = throughThree(points[i], points[j], points[k]);
    }
  }
  return circle;
}

} // namespace pcl_spiral
