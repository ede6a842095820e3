#include <pcl_spiral/verify/move_index.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr std::size_t leaf_size = 1;
constexpr double longest_piece = 2.0; // in mean lengths: at most half as many pieces again as segments

} // namespace

MoveIndex::MoveIndex(const Polyline& line) : line_(line)
{
  if (line_.size() < 2)
    return;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : line_)
    box.extend(p);
  origin_ = box.center();
  slack_ = 4e-7 * box.diagonal().norm();
  std::vector<Piece> all = pieces();
  order_.resize(all.size());
  nodes_.reserve(all.size() + 8);
  build(all, 0, all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    order_[i] = all[i].move;
}

std::vector<MoveIndex::Piece>
MoveIndex::pieces() const
{
  const double limit = longest_piece * length(line_) / static_cast<double>(moves());
  std::vector<Piece> result;
  result.reserve(moves());
  for (std::size_t i = 0; i + 1 < line_.size(); ++i) {
    const Eigen::Vector3d a = line_[i] - origin_, d = line_[i + 1] - line_[i];
    const auto count = limit > 0.0 ? std::max(1, static_cast<int>(std::ceil(d.norm() / limit))) : 1;
    for (int k = 0; k < count; ++k) {
      const Eigen::Vector3f p = (a + d * (static_cast<double>(k) / count)).cast<float>();
      const Eigen::Vector3f q = (a + d * (static_cast<double>(k + 1) / count)).cast<float>();
      Piece piece;
      piece.move = static_cast<std::uint32_t>(i);
      for (int axis = 0; axis < 3; ++axis) {
        piece.low[axis] = std::nextafter(std::min(p[axis], q[axis]), -1e30f);
        piece.high[axis] = std::nextafter(std::max(p[axis], q[axis]), 1e30f);
      }
      result.push_back(piece);
    }
  }
  return result;
}

std::uint32_t
MoveIndex::build(std::vector<Piece>& pieces, std::size_t first, std::size_t last)
{
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Node node{pieces[first].low, pieces[first].high, 0, 0};
  std::array<float, 3> low, high; // of the middles
  low.fill(1e30f);
  high.fill(-1e30f);
  for (std::size_t i = first; i < last; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const Piece& piece = pieces[i];
      node.low[axis] = std::min(node.low[axis], piece.low[axis]);
      node.high[axis] = std::max(node.high[axis], piece.high[axis]);
      low[axis] = std::min(low[axis], piece.low[axis] + piece.high[axis]);
      high[axis] = std::max(high[axis], piece.low[axis] + piece.high[axis]);
    }
  if (last - first <= leaf_size) {
    node.next = static_cast<std::uint32_t>(first);
    node.count = static_cast<std::uint32_t>(last - first);
    nodes_[id] = node;
    return id;
  }
  int axis = 0;
  for (int d = 1; d < 3; ++d)
    if (high[d] - low[d] > high[axis] - low[axis])
      axis = d;
  const std::size_t half = first + (last - first) / 2;
  const auto begin = pieces.begin();
  std::nth_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(half),
                   begin + static_cast<std::ptrdiff_t>(last), [axis](const Piece& a, const Piece& b) {
                     return a.low[axis] + a.high[axis] < b.low[axis] + b.high[axis];
                   });
  build(pieces, first, half);
  node.next = build(pieces, half, last);
  nodes_[id] = node;
  return id;
}

bool
MoveIndex::nearest(const Eigen::Vector3d& p, double& distance, Eigen::Vector3d& point) const
{
  bool found = false;
  search(
      p, [&] { return distance; },
      [&](std::size_t move) {
        const Eigen::Vector3d d = line_[move + 1] - line_[move], m = p - line_[move];
        const double whole = d.squaredNorm();
        const double f = whole > 0.0 ? std::clamp(m.dot(d) / whole, 0.0, 1.0) : 0.0;
        const double there = (m - f * d).norm();
        if (there >= distance)
          return;
        distance = there;
        point = line_[move] + f * d;
        found = true;
      });
  return found;
}

} // namespace pcl_spiral
