#include "fitted_normal.h"

#include <pcl_spiral/core/frame.h>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr int terms = 10; // of a cubic surface

/** z = f(x, y): one row of the system, x and y of about 1. */
Eigen::Matrix<double, 1, terms>
cubicTerms(double x, double y)
{
  Eigen::Matrix<double, 1, terms> row;
  row << 1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
  return row;
}

} // namespace

NormalFit::NormalFit(const Triangulation& mesh, const std::vector<Vector3d>& positions, const CornerSectors& sectors)
: mesh_(mesh), positions_(positions), sectors_(sectors), seen_(positions.size(), 0)
{
}

void
NormalFit::takeVertex(std::uint32_t v)
{
  if (seen_[v] == round_)
    return;
  seen_[v] = round_;
  ring_.push_back(v);
}

void
NormalFit::takeRings(std::uint32_t sector)
{
  ++round_;
  ring_.clear();
  takeVertex(mesh_.origin(sectors_.corners[sectors_.begin[sector]]));
  for (std::uint32_t k = sectors_.begin[sector]; k < sectors_.begin[sector + 1]; ++k) {
    const std::uint32_t face = sectors_.corners[k] / 3;
    for (std::uint32_t h = 3 * face; h < 3 * face + 3; ++h) {
      const std::uint32_t about = sectors_.of_corner[h]; // the smooth fan about each corner of the first ring's faces
      for (std::uint32_t j = sectors_.begin[about]; j < sectors_.begin[about + 1]; ++j) {
        const std::uint32_t corner = sectors_.corners[j];
        takeVertex(mesh_.target(corner));
        takeVertex(mesh_.origin(Triangulation::previous(corner)));
      }
    }
  }
}

bool
NormalFit::refine(std::uint32_t sector, Vector3d& normal)
{
  constexpr double least_determined = 1e-3; // the least over the largest diagonal of the triangular factor
  constexpr double least_cosine = 0.9;      // of the angle between the fit's normal and the faces'
  takeRings(sector);
  if (ring_.size() < terms)
    return false;
  const Vector3d& centre = positions_[ring_[0]];
  double reach = 0.0;
  for (const std::uint32_t v : ring_)
    reach = std::max(reach, (positions_[v] - centre).norm());
  Vector3d e1, e2;
  tangentFrame(normal, e1, e2);
  Eigen::Matrix<double, Eigen::Dynamic, terms> system(ring_.size(), terms);
  Eigen::VectorXd heights(ring_.size());
  for (std::size_t i = 0; i < ring_.size(); ++i) {
    const Vector3d x = (positions_[ring_[i]] - centre) / reach;
    system.row(i) = cubicTerms(e1.dot(x), e2.dot(x));
    heights[i] = normal.dot(x);
  }
  const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, Eigen::Dynamic, terms>> qr(system);
  const auto diagonal = qr.matrixQR().diagonal().cwiseAbs();
  if (!(diagonal.minCoeff() > least_determined * diagonal.maxCoeff()))
    return false;
  const Eigen::Matrix<double, terms, 1> cubic = qr.solve(heights);
  const Vector3d found = (normal - cubic[1] * e1 - cubic[2] * e2).normalized();
  if (!(found.dot(normal) > least_cosine))
    return false;
  normal = found;
  return true;
}

} // namespace pcl_spiral
