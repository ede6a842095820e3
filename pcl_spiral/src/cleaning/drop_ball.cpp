// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/cleaning/impl/drop_ball.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/** Points in a cell, about: enough that a cell is worth its look, few enough that most cells are passed over. */
constexpr double points_per_cell = 4.0;

} // namespace

DropBall::DropBall(std::vector<Eigen::Vector3d> points, double radius) : points_(std::move(points)), radius_(radius)
{
  if (points_.empty())
    return;
  low_ = high_ = points_.front().head<2>();
  for (const Eigen::Vector3d& p : points_) {
    low_ = low_.cwiseMin(p.head<2>());
    high_ = high_.cwiseMax(p.head<2>());
  }
  const Eigen::Vector2d size = high_ - low_;
  const double even =
      std::sqrt(points_per_cell * std::max(size.x(), radius) * std::max(size.y(), radius) / static_cast<double>(points_.size()));
  cell_ = std::min(even, radius);
  columns_ = static_cast<std::int64_t>(size.x() / cell_) + 1;
  rows_ = static_cast<std::int64_t>(size.y() / cell_) + 1;
  const auto cells = static_cast<std::size_t>(columns_ * rows_);
  begin_.assign(cells + 1, 0);
  top_.assign(cells, -infinity);
  for (const Eigen::Vector3d& p : points_) {
    const std::size_t c = cellOf(p);
    ++begin_[c + 1];
    top_[c] = std::max(top_[c], p.z());
  }
  for (std::size_t c = 0; c < cells; ++c)
    begin_[c + 1] += begin_[c];
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  std::vector<Eigen::Vector3d> sorted(points_.size());
  for (const Eigen::Vector3d& p : points_)
    sorted[next[cellOf(p)]++] = p;
  points_ = std::move(sorted);
}

std::size_t
DropBall::cellOf(const Eigen::Vector3d& point) const
{
  const Eigen::Vector2d at = (point.head<2>() - low_) / cell_;
  return static_cast<std::size_t>(static_cast<std::int64_t>(at.y()) * columns_ + static_cast<std::int64_t>(at.x()));
}

double
DropBall::height(double u, double v) const
{
  return height(u, v, 0.0);
}

double
DropBall::height(double u, double v, double depth) const
{
  const double radius = radius_ - depth, squared = radius * radius;
  double highest = -infinity;
  if (points_.empty() || !(radius > 0.0))
    return highest;
  const auto cellAt = [&](double offset, std::int64_t count) {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(offset / cell_)), 0, count - 1);
  };
  const auto look = [&](std::int64_t column, std::int64_t row) {
    const auto c = static_cast<std::size_t>(row * columns_ + column);
    if (!(top_[c] + radius > highest))
      return;
    const double left = low_.x() + static_cast<double>(column) * cell_, below = low_.y() + static_cast<double>(row) * cell_;
    const double du = std::max({left - u, u - left - cell_, 0.0}), dv = std::max({below - v, v - below - cell_, 0.0});
    const double nearest = du * du + dv * dv;
    if (nearest > squared || !(top_[c] + std::sqrt(squared - nearest) > highest))
      return;
    for (std::uint32_t i = begin_[c]; i < begin_[c + 1]; ++i) {
      const Eigen::Vector3d& p = points_[i];
      const double a = p.x() - u, b = p.y() - v, off = a * a + b * b;
      if (off <= squared)
        highest = std::max(highest, p.z() + std::sqrt(squared - off));
    }
  };
  if (u < low_.x() - radius || u > high_.x() + radius || v < low_.y() - radius || v > high_.y() + radius)
    return highest;
  const std::int64_t own_column = cellAt(u - low_.x(), columns_), own_row = cellAt(v - low_.y(), rows_);
  look(own_column, own_row); // the cell below is most often the highest there is: most others are passed over
  const std::int64_t last_column = cellAt(u + radius - low_.x(), columns_), last_row = cellAt(v + radius - low_.y(), rows_);
  for (std::int64_t row = cellAt(v - radius - low_.y(), rows_); row <= last_row; ++row)
    for (std::int64_t column = cellAt(u - radius - low_.x(), columns_); column <= last_column; ++column)
      look(column, row);
  return highest;
}

} // namespace pcl_spiral
