#include <pcl_spiral/search/local_star.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {

void
LocalStar::compute(const double* u, const double* v, int count, double max_circumradius)
{
  const double side = 2.0 * max_circumradius;
  cell_.assign({{-side, -side, -1}, {side, -side, -1}, {side, side, -1}, {-side, side, -1}});
  double squared_reach = 2.0 * side * side;
  for (int j = 1; j < count; ++j) {
    const double squared = u[j] * u[j] + v[j] * v[j];
    if (squared > 4.0 * squared_reach)
      continue; // its bisector passes outside the cell
    const std::size_t m = cell_.size();
    side_.resize(m);
    bool cut = false;
    for (std::size_t t = 0; t < m; ++t) {
      side_[t] = cell_[t].x * u[j] + cell_[t].y * v[j] - 0.5 * squared;
      cut |= side_[t] > 1e-9 * squared;
    }
    if (!cut)
      continue;
    clipped_.clear();
    for (std::size_t t = 0; t < m; ++t) {
      const std::size_t next = t + 1 == m ? 0 : t + 1;
      const bool inside = side_[t] <= 0.0, next_inside = side_[next] <= 0.0;
      if (inside)
        clipped_.push_back(cell_[t]);
      if (inside == next_inside)
        continue;
      const double w = side_[t] / (side_[t] - side_[next]);
      clipped_.push_back({cell_[t].x + w * (cell_[next].x - cell_[t].x), cell_[t].y + w * (cell_[next].y - cell_[t].y),
                          inside ? j : cell_[t].edge});
    }
    cell_.swap(clipped_);
    squared_reach = 0.0;
    for (const Vertex& c : cell_)
      squared_reach = std::max(squared_reach, c.x * c.x + c.y * c.y);
  }
  reach_ = std::min(std::sqrt(squared_reach), side);
  spokes_.clear();
  for (std::size_t t = 0; t < cell_.size(); ++t) {
    if (cell_[t].edge < 0)
      continue;
    const Vertex& corner = cell_[(t + 1) % cell_.size()]; // between this edge and the next
    const bool near = corner.x * corner.x + corner.y * corner.y <= max_circumradius * max_circumradius;
    spokes_.push_back({cell_[t].edge, near && corner.edge >= 0});
  }
}

} // namespace pcl_spiral
