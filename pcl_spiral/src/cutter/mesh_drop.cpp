// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_drop.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pcl_spiral {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double slack = 1e-9; // so that rounding never leaves a face out
constexpr std::uint32_t nothing = 0xffffffffu;

/** An entry of the search queue: a node of boxes, a part of a face, or a contact. */
struct Waiting {
  enum Kind : std::uint8_t { Boxes, Part, Contact };
  double height; ///< upper bound of the heights in it; for a contact its height
  Kind kind;
  std::uint32_t face;  ///< the lowest in it
  std::uint32_t place; ///< index of parts and contacts in the list
  BoxTree::Node node;

  /** Whether \p other comes first: the higher one; at the same height contacts come last, ordered by their faces. */
  bool operator<(const Waiting& other) const
  {
    if (height != other.height)
      return height < other.height;
    if ((kind == Contact) != (other.kind == Contact))
      return kind == Contact;
    return face > other.face;
  }
};

class Search {
public:
  Search(const PatchTree& patches, const TriangleTouch& touch, double sag, double ceiling, const AxisFrame& frame, double floor)
  : patches_(patches), touch_(touch), sag_(sag), ceiling_(ceiling), frame_(frame), view_(frame), floor_(floor)
  {
    axes_ << frame.e1.transpose(), frame.e2.transpose(), frame.axis.transpose();
    waiting_.reserve(64);
  }

  MeshContact run()
  {
    if (patches_.size() > 0)
      addNode(patches_.boxes().root());
    while (!waiting_.empty()) {
      const Waiting top = waiting_.front();
      std::pop_heap(waiting_.begin(), waiting_.end());
      waiting_.pop_back();
      if (top.kind == Waiting::Contact)
        return contactOf(top);
      if (!isSurpassed(top))
        open(top);
    }
    return {};
  }

private:
  /** Whether all in it is at most as high as a contact found, up to the slack, and not on a lower face. */
  bool isSurpassed(const Waiting& waiting) const { return waiting.height <= best_.height + 2.0 * slack && waiting.face >= best_.face; }

  void open(const Waiting& top)
  {
    if (top.kind == Waiting::Part) {
      const PatchCell cell = parts_[top.place];
      for (int k = 0; k < 4; ++k)
        addPart(cell.quarter(k), top.face);
    }
    else if (top.node.isItem())
      addPart(seen(patches_.cell(top.node.begin)), patches_.index(top.node.begin));
    else {
      addNode(top.node.lower());
      addNode(top.node.upper());
    }
  }

  void push(const Waiting& waiting)
  {
    waiting_.push_back(waiting);
    std::push_heap(waiting_.begin(), waiting_.end());
  }

  void addNode(const BoxTree::Node& node)
  {
    const AxisBox box = view_.see(patches_.boxes().box(node));
    const double nearest = std::max(0.0, box.nearest - slack);
    const double high = std::min(box.high, ceiling_);
    if (high + slack < floor_ || box.low - slack > ceiling_ || nearest > touch_.profile().radius())
      return;
    const double height = high - touch_.profile().height(nearest) + slack;
    if (height >= floor_)
      push({height, Waiting::Boxes, patches_.boxes().lowestItem(node), 0, node});
  }

  PatchCell seen(const PatchCell& cell) const { return {axes_ * (cell.corners.colwise() - frame_.origin), axes_ * cell.bows}; }

  void addPart(const PatchCell& cell, std::uint32_t face)
  {
    const bool flat = !(cell.sag() > sag_);
    if (cell.corners.row(2).minCoeff() - (std::isfinite(sag_) ? cell.sag() : 0.0) > ceiling_)
      return;
    const double wider = flat ? 0.0 : std::sqrt(cell.bows.topRows<2>().colwise().squaredNorm().maxCoeff()) / 3.0;
    const double higher = flat ? 0.0 : std::max(0.0, -cell.bows.row(2).minCoeff()) / 3.0;
    const double floor = floor_ - higher - slack;
    const bool cut = flat && cell.corners.row(2).maxCoeff() > ceiling_;
    const TouchedTriangle touched = cut ? touchBelow(cell.corners, floor) : touch_.touch(cell.corners, wider, floor);
    const double height = touched.height + higher;
    if (!touched.found || !(flat ? height > floor_ : height + slack >= floor_))
      return;
    const auto place = static_cast<std::uint32_t>(parts_.size());
    parts_.push_back(cell);
    if (flat) {
      floor_ = std::max(floor_, height - slack);
      parts_.back().corners.col(0) = touched.weights; // the corners are not needed any more
      parts_.back().corners.col(1) = std::isfinite(sag_) ? cell.position(touched.weights) : cell.corners * touched.weights;
    }
    const Waiting waiting{flat ? height : height + slack, flat ? Waiting::Contact : Waiting::Part, face, place, {}};
    if (flat && (best_.place == nothing || best_ < waiting))
      best_ = waiting;
    push(waiting);
  }

  /** The touch of the part of a flat triangle that is not above the ceiling: a triangle, or two. */
  TouchedTriangle touchBelow(const Matrix3d& corners, double floor) const
  {
    std::vector<Vector3d> below; // barycentric, of the corners of that part
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const double a = corners(2, k) - ceiling_, b = corners(2, next) - ceiling_;
      if (a <= 0.0)
        below.push_back(Vector3d::Unit(k));
      if ((a <= 0.0) != (b <= 0.0))
        below.push_back((b * Vector3d::Unit(k) - a * Vector3d::Unit(next)) / (b - a));
    }
    TouchedTriangle best;
    for (std::size_t i = 2; i < below.size(); ++i) {
      Matrix3d part;
      part << below[0], below[i - 1], below[i];
      TouchedTriangle touched = touch_.touch(corners * part, 0.0, floor);
      touched.weights = part * touched.weights;
      if (touched.found && (!best.found || touched.height > best.height))
        best = touched;
    }
    return best;
  }

  MeshContact contactOf(const Waiting& top) const
  {
    MeshContact contact;
    contact.found = true;
    contact.height = top.height;
    contact.face = top.face;
    const PatchCell& part = parts_[top.place];
    contact.weights = part.weights * part.corners.col(0);
    contact.contact = frame_.place(part.corners.col(1).head<2>(), part.corners(2, 1));
    return contact;
  }

  const PatchTree& patches_;
  const TriangleTouch& touch_;
  double sag_, ceiling_;
  const AxisFrame& frame_;
  AxisView view_;
  double floor_;                                                                             ///< contacts below it do not count
  Waiting best_{-std::numeric_limits<double>::infinity(), Waiting::Contact, 0, nothing, {}}; ///< of the contacts found
  Matrix3d axes_;
  std::vector<Waiting> waiting_; ///< a heap
  std::vector<PatchCell> parts_;
};

} // namespace

MeshContact
MeshDrop::highest(const AxisFrame& frame, double floor) const
{
  return Search(patches_, touch_, sag_, ceiling_, frame, floor).run();
}

} // namespace pcl_spiral
