// SPDX-License-Identifier: BSD-3-Clause
#include "closing_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {

ClosingGrid::ClosingGrid(const DropBall& ball, double cell)
: cell_(cell), radius_(ball.radius()), reach_(static_cast<std::int64_t>(ball.radius() / cell))
{
  // Beyond the points by the ball, which touches the outermost from there, and one node more, over which there is nothing.
  const double beyond = static_cast<double>(reach_ + 2) * cell_;
  low_ = (ball.low() / cell_).array().floor() * cell_ - beyond;
  const Eigen::Vector2d size = ball.high() - low_;
  columns_ = static_cast<std::int64_t>((size.x() + beyond) / cell_) + 3;
  rows_ = static_cast<std::int64_t>((size.y() + beyond) / cell_) + 3;
  dilate(ball);
  limitSlope();
  erode();
}

void
ClosingGrid::dilate(const DropBall& ball)
{
  centres_.resize(static_cast<std::size_t>(columns_ * rows_));
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t row = 0; row < rows_; ++row)
    for (std::int64_t column = 0; column < columns_; ++column)
      centres_[node(column, row)] = ball.height(u(column), v(row));
}

template <typename Visit>
void
ClosingGrid::overBall(std::int64_t row, double radius, Visit visit) const
{
  const auto reach = static_cast<std::int64_t>(radius / cell_);
  for (std::int64_t dr = std::max(-reach, -row); dr <= std::min(reach, rows_ - 1 - row); ++dr) {
    const double squared = radius * radius - static_cast<double>(dr * dr) * cell_ * cell_;
    const auto widest = static_cast<std::int64_t>(std::sqrt(std::max(squared, 0.0)) / cell_);
    for (std::int64_t dc = -widest; dc <= widest; ++dc) {
      const double rise = std::sqrt(std::max(squared - static_cast<double>(dc * dc) * cell_ * cell_, 0.0));
      const std::int64_t first = std::max<std::int64_t>(0, -dc), last = std::min(columns_, columns_ - dc);
      if (last > first)
        visit(node(first, row), node(first + dc, row + dr), static_cast<std::size_t>(last - first), rise);
    }
  }
}

void
ClosingGrid::erode()
{
  heights_.assign(centres_.size(), infinite);
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t row = 0; row < rows_; ++row)
    overBall(row, radius_, [&](std::size_t to, std::size_t from, std::size_t count, double below) {
      for (std::size_t i = 0; i < count; ++i)
        heights_[to + i] = std::min(heights_[to + i], centres_[from + i] - below);
    });
  for (double& height : heights_) // no ball was there
    if (!(height < infinite))
      height = -std::numeric_limits<double>::infinity();
}

void
ClosingGrid::offset(double radius)
{
  const std::vector<double> below = heights_;
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t row = 0; row < rows_; ++row)
    overBall(row, radius, [&](std::size_t to, std::size_t from, std::size_t count, double rise) {
      for (std::size_t i = 0; i < count; ++i)
        heights_[to + i] = std::max(heights_[to + i], below[from + i] + rise);
    });
  for (std::size_t i = 0; i < below.size(); ++i) // beyond the rim there is none
    if (!(below[i] > -infinite))
      heights_[i] = below[i];
}

void
ClosingGrid::leaveOut(const ClosingGrid& all)
{
  const std::int64_t columns = std::llround((low_.x() - all.low_.x()) / cell_), rows = std::llround((low_.y() - all.low_.y()) / cell_);
  const double rounding = 1e-6 * cell_;
  for (std::int64_t row = 0; row < rows_; ++row)
    for (std::int64_t column = 0; column < columns_; ++column)
      if (double& height = heights_[node(column, row)]; has(node(column, row)))
        if (all.height(all.node(column + columns, row + rows)) > height + rounding)
          height = -std::numeric_limits<double>::infinity();
}

/** The lowest surface over the centres that is nowhere steeper, by sweeps over chamfer distances (Borgefors 1986): two of them where there
 *  are no gaps between the nodes, more round gaps. What is eroded from it is no steeper either, and its hollows are as wide as the ball. */
void
ClosingGrid::limitSlope()
{
  const double straight = steepest_tangent * cell_, diagonal = std::sqrt(2.0) * straight;
  bool changed = true;
  const auto raise = [&](std::size_t node, std::int64_t offset, double drop) {
    const double least = centres_[node + static_cast<std::size_t>(offset)] - drop;
    changed = changed || least > centres_[node];
    centres_[node] = std::max(centres_[node], least);
  };
  const std::size_t inner = node(columns_ - 1, rows_ - 2); // over the outermost nodes there is no ball
  for (int sweep = 0; sweep < 2 || changed; ++sweep) {
    changed = false;
    for (std::size_t k = node(1, 1); k < inner; ++k) {
      const std::size_t at = sweep % 2 == 0 ? k : node(1, 1) + inner - 1 - k;
      const std::int64_t back = sweep % 2 == 0 ? -1 : 1;
      if (!(centres_[at] > -infinite))
        continue;
      raise(at, back, straight);
      raise(at, back * columns_, straight);
      raise(at, back * (columns_ + 1), diagonal);
      raise(at, back * (columns_ - 1), diagonal);
    }
  }
}

double
ClosingGrid::lowestAbout(double u, double v) const
{
  const auto column = static_cast<std::int64_t>((u - low_.x()) / cell_), row = static_cast<std::int64_t>((v - low_.y()) / cell_);
  const std::size_t first = node(column, row), next = first + static_cast<std::size_t>(columns_);
  return std::min({heights_[first], heights_[first + 1], heights_[next], heights_[next + 1]});
}

} // namespace pcl_spiral
