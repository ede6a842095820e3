// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/mesh/impl/crease_lines.h>

#include <pcl_spiral/mesh/impl/mesh_rims.h>

#include <algorithm>

namespace pcl_spiral {

CreaseLines::CreaseLines(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& chosen)
{
  const auto counts = [&](std::uint32_t face) { return chosen.empty() || chosen[face]; };
  for (std::uint32_t h = 0; h < mesh.triangles().halfEdgeCount(); ++h) {
    const std::uint32_t other = mesh.triangles().opposite(h);
    if (!mesh.isCrease(h) || h > other || !counts(h / 3) || !counts(other / 3))
      continue;
    for (const double u : {0.0, 0.5, 1.0}) { // the parabola as two segments
      line_.push_back(edgePlace(mesh, h, u));
      is_joint_.push_back(u == 1.0);
    }
    length_ += (line_.back() - line_[line_.size() - 2]).norm() + (line_[line_.size() - 2] - line_[line_.size() - 3]).norm();
  }
  if (!line_.empty())
    index_ = std::make_unique<MoveIndex>(line_);
}

double
CreaseLines::distance(const Eigen::Vector3d& p, double limit) const
{
  if (index_)
    index_->search(
        p, [&] { return limit; },
        [&](std::size_t s) {
          if (is_joint_[s])
            return;
          const Eigen::Vector3d d = line_[s + 1] - line_[s], m = p - line_[s];
          const double whole = d.squaredNorm(), f = whole > 0.0 ? std::clamp(m.dot(d) / whole, 0.0, 1.0) : 0.0;
          limit = std::min(limit, (m - f * d).norm());
        });
  return limit;
}

} // namespace pcl_spiral
