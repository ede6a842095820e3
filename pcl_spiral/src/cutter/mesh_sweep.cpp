// SPDX-License-Identifier: BSD-3-Clause
#include "mesh_sweep.h"

#include "drive/swept_strip.h"
#include "drive/way_cover.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr double coarse_share = 0.25; // share of the allowed error that the sag may use

/** Searches the place nearest to a strip, the nearer half of the boxes first. */
class NearestToStrip {
public:
  NearestToStrip(const PatchTree& patches, double sag, const SweptStrip& strip, double limit)
  : patches_(patches), sag_(sag), strip_(strip), nearest_(limit)
  {}

  /** The distance, or the limit if nothing is nearer. */
  double run()
  {
    if (patches_.size() > 0)
      open(patches_.boxes().root());
    return nearest_;
  }

private:
  double distanceTo(const BoxTree::Node& node) const { return strip_.toTurnedBox(patches_.boxes().box(node)); }

  bool isNearer(double squared, double off = 0.0) const { return squared < (nearest_ + off) * (nearest_ + off); }

  void open(const BoxTree::Node& node)
  {
    if (node.isItem()) {
      take(strip_.seen(patches_.cell(node.begin)));
      return;
    }
    BoxTree::Node first = node.lower(), second = node.upper();
    double near = distanceTo(first), far = distanceTo(second);
    if (far < near) {
      std::swap(first, second);
      std::swap(near, far);
    }
    if (isNearer(near))
      open(first);
    if (isNearer(far))
      open(second);
  }

  void take(const PatchCell& cell)
  {
    const double sag = cell.sag(), off = sag > sag_ ? sag : 0.0;
    if (!isNearer(strip_.toPlane(cell.corners, cell.bows)) ||
        !isNearer(strip_.toBox(cell.corners.rowwise().minCoeff(), cell.corners.rowwise().maxCoeff()), off))
      return;
    const double squared = strip_.toTriangle(cell.corners);
    if (!isNearer(squared, off))
      return;
    if (off == 0.0)
      nearest_ = std::sqrt(squared);
    else if (nearest_ > 0.0)
      for (int k = 0; k < 4; ++k)
        take(cell.quarter(k));
  }

  const PatchTree& patches_;
  double sag_;
  const SweptStrip& strip_;
  double nearest_;
};

/** Add the parts of \p cell within \p reach of the way; parts within \p sag of a flat triangle count as flat. */
void
cover(const PatchCell& cell, const SweptStrip& strip, double reach, double sag, WayCover& covered)
{
  const double off = std::isfinite(sag) ? cell.sag() : 0.0, wider = reach + off;
  if (strip.toPlane(cell.corners, cell.bows) > reach * reach ||
      strip.toBox(cell.corners.rowwise().minCoeff(), cell.corners.rowwise().maxCoeff()) > wider * wider)
    return;
  if (!(off > sag))
    covered.add(cell.corners, reach - off);
  else
    for (int k = 0; k < 4; ++k)
      cover(cell.quarter(k), strip, reach, sag, covered);
}

} // namespace

double
MeshSweep::depth(const Vector3d& from, const Vector3d& to, const Vector3d& axis, double allowed) const
{
  const SweptStrip strip(from, to, axis);
  const double limit = radius_ - allowed, nearest = limit > 0.0 ? NearestToStrip(patches_, sag_, strip, limit).run() : limit;
  return nearest < limit ? radius_ - nearest : allowed;
}

bool
MeshSweep::touches(const Vector3d& from, const Vector3d& to, const Vector3d& axis, double off) const
{
  const SweptStrip strip(from, to, axis);
  const double reach = radius_ + off, sag = std::isfinite(sag_) ? std::max(sag_, coarse_share * off) : sag_;
  WayCover covered(strip.way());
  patches_.boxes().forItems([&](const Box& box) { return strip.toTurnedBox(box) <= reach * reach; },
                            [&](std::uint32_t i) { cover(strip.seen(patches_.cell(i)), strip, reach, sag, covered); });
  return covered.isWhole();
}

} // namespace pcl_spiral
