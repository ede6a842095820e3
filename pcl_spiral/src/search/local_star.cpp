#include <pcl_spiral/search/local_star.h>

#include <pcl_spiral/core/lanes.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
void
LocalStar::Cell::resize(int room)
{
  x.resize(room);
  y.resize(room);
  edge.resize(room);
}

void
LocalStar::Cell::add(double corner_x, double corner_y, int next_edge)
{
  x[size] = corner_x;
  y[size] = corner_y;
  edge[size++] = next_edge;
}

void
LocalStar::Cell::fillUp()
{
  for (int t = size; t < padded(size); ++t)
    x[t] = y[t] = 0.0;
}

bool
LocalStar::clip(double u, double v, int neighbour)
{
  const int m = cell_.size;
  const double squared = u * u + v * v, half = 0.5 * squared;
  const double *x = cell_.x.data(), *y = cell_.y.data();
  double* side = side_.data();
  double farthest = 0.0; // beyond the bisector
  for (int t = 0; t < m; t += lane_count) {
    using Corners = Eigen::Array<double, lane_count, 1>;
    const Corners beyond = Eigen::Map<const Corners>(x + t) * u + Eigen::Map<const Corners>(y + t) * v - half;
    Eigen::Map<Corners>(side + t) = beyond;
    farthest = std::max(farthest, beyond.maxCoeff());
  }
  if (!(farthest > 1e-9 * squared))
    return false;
  // The corners beyond it follow each other, from first to last.
  const auto beyond = [&](int t) { return side[t] > 0.0; };
  const auto after = [m](int t) { return t + 1 == m ? 0 : t + 1; };
  int first = 0;
  while (first < m && beyond(first))
    ++first;
  if (first == m)
    return false;
  while (!beyond(first))
    first = after(first);
  int last = first;
  while (beyond(after(last)))
    last = after(last);
  const int before = first == 0 ? m - 1 : first - 1;
  const auto crossing = [&](int inside, int outside, int edge) {
    const double w = side[inside] / (side[inside] - side[outside]);
    clipped_.add(x[inside] + w * (x[outside] - x[inside]), y[inside] + w * (y[outside] - y[inside]), edge);
  };
  clipped_.size = 0;
  crossing(before, first, neighbour);
  crossing(after(last), last, cell_.edge[last]);
  for (int t = after(last); t != first; t = after(t))
    clipped_.add(x[t], y[t], cell_.edge[t]);
  clipped_.fillUp();
  std::swap(cell_, clipped_);
  return true;
}

void
LocalStar::compute(const double* u, const double* v, int count, double max_circumradius)
{
  const int room = padded(count + 4 + lane_count); // each cut adds one corner at most
  if (static_cast<int>(side_.size()) < room) {
    cell_.resize(room);
    clipped_.resize(room);
    side_.resize(room);
  }
  const double side = 2.0 * max_circumradius;
  cell_.size = 0;
  cell_.add(-side, -side, -1);
  cell_.add(side, -side, -1);
  cell_.add(side, side, -1);
  cell_.add(-side, side, -1);
  cell_.fillUp();
  double squared_reach = 2.0 * side * side;
  for (int j = 1; j < count; ++j) {
    if (u[j] * u[j] + v[j] * v[j] > 4.0 * squared_reach)
      continue; // its bisector passes outside the cell
    if (!clip(u[j], v[j], j))
      continue;
    squared_reach = 0.0;
    for (int t = 0; t < cell_.size; ++t)
      squared_reach = std::max(squared_reach, cell_.x[t] * cell_.x[t] + cell_.y[t] * cell_.y[t]);
  }
  reach_ = std::min(std::sqrt(squared_reach), side);
  spokes_.clear();
  for (int t = 0; t < cell_.size; ++t) {
    if (cell_.edge[t] < 0)
      continue;
    const int corner = t + 1 == cell_.size ? 0 : t + 1; // between this edge and the next
    const double squared = cell_.x[corner] * cell_.x[corner] + cell_.y[corner] * cell_.y[corner];
    spokes_.push_back({cell_.edge[t], squared <= max_circumradius * max_circumradius && cell_.edge[corner] >= 0});
  }
}

} // namespace pcl_spiral
