// SPDX-License-Identifier: BSD-3-Clause
#include "fitted_normal.h"

#include "core/cubic_terms.h"
#include <pcl_spiral/core/impl/frame.h>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

} // namespace

NormalFit::NormalFit(const Triangulation& mesh, const std::vector<Vector3d>& positions, const CornerSectors& sectors)
: mesh_(mesh), positions_(positions), sectors_(sectors), vertex_seen_(positions.size(), 0), sector_seen_(sectors.count(), 0)
{}

/** The corners of a fan's faces: vertices, and the fans about them. */
void
NormalFit::takeFan(std::uint32_t sector)
{
  for (std::uint32_t k = sectors_.begin[sector]; k < sectors_.begin[sector + 1]; ++k) {
    const std::uint32_t face = sectors_.corners[k] / 3;
    const auto& f = mesh_.triangle(face);
    mean_normal_ += (positions_[f[1]] - positions_[f[0]]).cross(positions_[f[2]] - positions_[f[0]]);
    for (std::uint32_t h = 3 * face; h < 3 * face + 3; ++h) {
      const std::uint32_t v = mesh_.origin(h), fan = sectors_.of_corner[h];
      if (vertex_seen_[v] != round_) {
        vertex_seen_[v] = round_;
        vertices_.push_back(v);
      }
      if (sector_seen_[fan] != round_) {
        sector_seen_[fan] = round_;
        next_fans_.push_back(fan);
      }
    }
  }
}

void
NormalFit::takeRing()
{
  fans_.swap(next_fans_);
  next_fans_.clear();
  for (const std::uint32_t fan : fans_)
    takeFan(fan);
}

bool
NormalFit::refine(std::uint32_t sector, Vector3d& normal, double* noise)
{
  constexpr int rings = 2, most_rings = 3;
  constexpr std::size_t enough = 16; // points: at the boundary, two rings have fewer
  ++round_;
  vertices_.assign(1, mesh_.origin(sectors_.corners[sectors_.begin[sector]]));
  vertex_seen_[vertices_[0]] = round_;
  next_fans_.assign(1, sector);
  sector_seen_[sector] = round_;
  mean_normal_.setZero();
  for (int ring = 0; ring < most_rings && (ring < rings || vertices_.size() < enough); ++ring)
    takeRing();
  return fit(normal, noise);
}

bool
NormalFit::fit(Vector3d& normal, double* noise) const
{
  constexpr double least_determined = 1e-3; // the least over the largest diagonal of the triangular factor
  constexpr double nearness = 0.1;          // of the reach: nearer points weigh no more than ten times as much as far ones
  constexpr double least_cosine = 0.7;      // of the angle between the fit's normal and the mean of the rings' faces
  if (vertices_.size() < cubic_term_count)
    return false;
  const Vector3d& centre = positions_[vertices_[0]];
  double reach = 0.0;
  for (const std::uint32_t v : vertices_)
    reach = std::max(reach, (positions_[v] - centre).norm());
  const Vector3d up = mean_normal_.normalized(); // that of one fan may come from narrow faces, and lean far
  Vector3d e1, e2;
  tangentFrame(up, e1, e2);
  Eigen::Matrix<double, Eigen::Dynamic, cubic_term_count> system(vertices_.size(), cubic_term_count);
  Eigen::VectorXd heights(vertices_.size()), weights(vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const Vector3d x = (positions_[vertices_[i]] - centre) / reach;
    weights[i] = 1.0 / (x.norm() + nearness);
    system.row(i) = weights[i] * cubicTerms(e1.dot(x), e2.dot(x));
    heights[i] = weights[i] * up.dot(x);
  }
  const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, Eigen::Dynamic, cubic_term_count>> qr(system);
  const auto diagonal = qr.matrixQR().diagonal().cwiseAbs();
  if (!(diagonal.minCoeff() > least_determined * diagonal.maxCoeff()))
    return false;
  const Eigen::Matrix<double, cubic_term_count, 1> cubic = qr.solve(heights);
  const Vector3d found = (up - cubic[1] * e1 - cubic[2] * e2).normalized();
  if (!(found.dot(up) > least_cosine))
    return false;
  normal = found;
  if (noise != nullptr) {
    const auto freedom = static_cast<double>(vertices_.size()) - cubic_term_count;
    *noise =
        freedom > 0.0 ? reach * std::sqrt(((system * cubic - heights).array().square() / weights.array().square()).sum() / freedom) : 0.0;
  }
  return true;
}

} // namespace pcl_spiral
