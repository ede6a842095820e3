#include "mesh_sweep.h"

#include "swept_strip.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/** Looks for the place nearest to a strip, the nearer half of the boxes first. */
class NearestToStrip {
public:
  NearestToStrip(const PatchTree& patches, double sag, const SweptStrip& strip, double limit)
  : patches_(patches), sag_(sag), strip_(strip), turned_(strip.axes().cwiseAbs()), nearest_(limit)
  {
  }

  /** The distance, or the limit where nothing is nearer. */
  double
  run()
  {
    if (patches_.size() > 0)
      open(patches_.boxes().root());
    return nearest_;
  }

private:
  double
  distanceTo(const BoxTree::Node& node) const
  {
    const Box& box = patches_.boxes().box(node);
    const Vector3d low(box.low[0], box.low[1], box.low[2]), high(box.high[0], box.high[1], box.high[2]);
    const Vector3d middle = strip_.axes() * (0.5 * (low + high) - strip_.origin()), half = turned_ * (0.5 * (high - low));
    return strip_.toBox(middle - half, middle + half);
  }

  bool isNearer(double squared, double off = 0.0) const { return squared < (nearest_ + off) * (nearest_ + off); }

  void
  open(const BoxTree::Node& node)
  {
    if (node.isItem()) {
      const PatchCell cell = patches_.cell(node.begin);
      take({strip_.axes() * (cell.corners.colwise() - strip_.origin()), strip_.axes() * cell.bows});
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

  void
  take(const PatchCell& cell)
  {
    const double sag = cell.sag(), off = sag > sag_ ? sag : 0.0;
    if (!isNearer(strip_.toBox(cell.corners.rowwise().minCoeff(), cell.corners.rowwise().maxCoeff()), off) ||
        !isNearer(strip_.toPlane(cell.corners, cell.bows)))
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
  Matrix3d turned_;
  double nearest_;
};

} // namespace

double
MeshSweep::depth(const Vector3d& from, const Vector3d& to, const Vector3d& axis, double allowed) const
{
  const SweptStrip strip(from, to, axis);
  const double limit = radius_ - allowed, nearest = limit > 0.0 ? NearestToStrip(patches_, sag_, strip, limit).run() : limit;
  return nearest < limit ? radius_ - nearest : allowed;
}

} // namespace pcl_spiral
