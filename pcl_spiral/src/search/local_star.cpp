#include <pcl_spiral/search/local_star.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

bool
LocalStar::clip(double u, double v, int neighbour)
{
  const std::size_t m = size_;
  const double squared = u * u + v * v, least = 1e-9 * squared;
  const Vertex* cell = cell_.data();
  double* side = side_.data();
  bool cut = false;
  for (std::size_t t = 0; t < m; ++t) {
    side[t] = cell[t].x * u + cell[t].y * v - 0.5 * squared;
    cut |= side[t] > least;
  }
  if (!cut)
    return false;
  Vertex* clipped = clipped_.data();
  std::size_t count = 0;
  for (std::size_t t = 0; t < m; ++t) {
    const std::size_t next = t + 1 == m ? 0 : t + 1;
    const bool inside = side[t] <= 0.0, next_inside = side[next] <= 0.0;
    if (inside)
      clipped[count++] = cell[t];
    if (inside == next_inside)
      continue;
    const double w = side[t] / (side[t] - side[next]);
    clipped[count++] = {cell[t].x + w * (cell[next].x - cell[t].x), cell[t].y + w * (cell[next].y - cell[t].y),
                        inside ? neighbour : cell[t].edge};
  }
  size_ = count;
  cell_.swap(clipped_);
  return true;
}

void
LocalStar::compute(const double* u, const double* v, int count, double max_circumradius)
{
  const std::size_t room = static_cast<std::size_t>(count) + 8; // each cut adds one corner at most, rounding two
  if (cell_.size() < 2 * room) {
    cell_.resize(2 * room);
    clipped_.resize(2 * room);
    side_.resize(2 * room);
  }
  const double side = 2.0 * max_circumradius;
  cell_[0] = {-side, -side, -1};
  cell_[1] = {side, -side, -1};
  cell_[2] = {side, side, -1};
  cell_[3] = {-side, side, -1};
  size_ = 4;
  double squared_reach = 2.0 * side * side;
  for (int j = 1; j < count; ++j) {
    if (u[j] * u[j] + v[j] * v[j] > 4.0 * squared_reach)
      continue; // its bisector passes outside the cell
    if (!clip(u[j], v[j], j))
      continue;
    squared_reach = 0.0;
    for (std::size_t t = 0; t < size_; ++t)
      squared_reach = std::max(squared_reach, cell_[t].x * cell_[t].x + cell_[t].y * cell_[t].y);
  }
  reach_ = std::min(std::sqrt(squared_reach), side);
  spokes_.clear();
  for (std::size_t t = 0; t < size_; ++t) {
    if (cell_[t].edge < 0)
      continue;
    const Vertex& corner = cell_[t + 1 == size_ ? 0 : t + 1]; // between this edge and the next
    const bool near = corner.x * corner.x + corner.y * corner.y <= max_circumradius * max_circumradius;
    spokes_.push_back({cell_[t].edge, near && corner.edge >= 0});
  }
}

} // namespace pcl_spiral
