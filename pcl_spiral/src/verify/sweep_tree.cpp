// SPDX-License-Identifier: BSD-3-Clause
#include "sweep_tree.h"

#include <pcl_spiral/core/impl/pass_ranges.h>
#include <pcl_spiral/machine/impl/tool_pose.h>

#include "core/angle_between.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr std::size_t leaf_size = 4;
constexpr double longest_piece = 2.0; // in mean lengths: at most half as many pieces again as moves

} // namespace

SweepTree::SweepTree(const Polyline& tips, const std::vector<Eigen::Vector3d>& axes, const std::vector<std::size_t>& passes)
{
  std::vector<Piece> pieces = piecesOf(tips, passes);
  if (pieces.empty())
    return;
  nodes_.emplace_back();
  build(pieces, 0, pieces.size(), axes, 0);
  nodes_.shrink_to_fit();
  for (const Piece& piece : pieces)
    moves_.push_back(piece.move);
}

std::vector<SweepTree::Piece>
SweepTree::piecesOf(const Polyline& tips, const std::vector<std::size_t>& passes) const
{
  std::vector<Piece> pieces;
  double sum = 0.0;
  std::size_t moves = 0;
  for (std::size_t i = 0; i + 1 < tips.size(); ++i)
    if (!beginsPass(passes, i + 1)) {
      sum += (tips[i + 1] - tips[i]).norm();
      ++moves;
    }
  const double limit = moves > 0 ? longest_piece * sum / static_cast<double>(moves) : 0.0;
  for (std::size_t i = 0; i + 1 < tips.size(); ++i) {
    if (beginsPass(passes, i + 1))
      continue;
    const Eigen::Vector3d d = tips[i + 1] - tips[i];
    const auto count = limit > 0.0 ? std::max(1, static_cast<int>(std::ceil(d.norm() / limit))) : 1;
    for (int k = 0; k < count; ++k)
      pieces.push_back({tips[i] + d * k / count, tips[i] + d * (k + 1) / count, static_cast<std::uint32_t>(i)});
  }
  return pieces;
}

/** The box is along the principal directions of the tips. */
SweptPlaces
SweepTree::placesOf(const std::vector<Piece>& pieces, std::size_t first, std::size_t last, const std::vector<Eigen::Vector3d>& axes) const
{
  SweptPlaces places;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), axis = Eigen::Vector3d::Zero();
  for (std::size_t i = first; i < last; ++i) {
    sum += pieces[i].from + pieces[i].to;
    axis += axes[pieces[i].move] + axes[pieces[i].move + 1];
  }
  const Eigen::Vector3d mean = sum / (2.0 * static_cast<double>(last - first));
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t i = first; i < last; ++i)
    for (const Eigen::Vector3d& tip : {pieces[i].from, pieces[i].to})
      spread += (tip - mean) * (tip - mean).transpose();
  const Eigen::Matrix3d directions = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
  places.sides.col(0) = directions.col(2);
  places.sides.col(1) = directions.col(1);
  places.sides.col(2) = directions.col(2).cross(directions.col(1));
  Eigen::AlignedBox3d box;
  for (std::size_t i = first; i < last; ++i)
    for (const Eigen::Vector3d& tip : {pieces[i].from, pieces[i].to})
      box.extend(Eigen::Vector3d(places.sides.transpose() * (tip - mean)));
  places.tip = mean + places.sides * box.center();
  places.half = 0.5 * box.sizes();
  places.axis = axis.norm() > 0.0 ? Eigen::Vector3d(axis.normalized()) : axes[pieces[first].move];
  for (std::size_t i = first; i < last; ++i)
    for (const Eigen::Vector3d& end : {axes[pieces[i].move], axes[pieces[i].move + 1]})
      places.turn = std::max(places.turn, angleBetween(places.axis, end));
  if (places.turn > M_PI_2)
    places.turn = M_PI; // the arc between two axes may leave the cone
  return places;
}

void
SweepTree::build(std::vector<Piece>& pieces, std::size_t first, std::size_t last, const std::vector<Eigen::Vector3d>& axes,
                 std::size_t node)
{
  SweptPlaces places = placesOf(pieces, first, last, axes);
  if (last - first <= leaf_size) {
    places.first = static_cast<std::uint32_t>(first);
    places.pieces = static_cast<std::uint32_t>(last - first);
    nodes_[node] = places;
    return;
  }
  places.first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node] = places;
  nodes_.resize(nodes_.size() + 2);
  const std::size_t half = first + (last - first) / 2;
  const auto begin = pieces.begin();
  const Eigen::Vector3d across = places.sides.col(0);
  std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(half),
                   begin + static_cast<std::ptrdiff_t>(last),
                   [&across](const Piece& a, const Piece& b) { return (a.from + a.to).dot(across) < (b.from + b.to).dot(across); });
  build(pieces, first, half, axes, places.first);
  build(pieces, half, last, axes, places.first + 1);
}

} // namespace pcl_spiral
