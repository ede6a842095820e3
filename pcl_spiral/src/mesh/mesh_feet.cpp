#include <pcl_spiral/mesh/mesh_feet.h>

#include <Eigen/Geometry>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using Eigen::Vector3d;
using Place = bg::model::point<double, 3, bg::cs::cartesian>;
using FaceBox = bg::model::box<Place>;

/** Barycentric coordinates of the point of the segment from corner \p i to \p j nearest to \p p. */
Vector3d
nearestOnSide(const Eigen::Matrix3d& corners, int i, int j, const Vector3d& p)
{
  const Vector3d d = corners.col(j) - corners.col(i);
  const double u = std::clamp(d.dot(p - corners.col(i)) / d.squaredNorm(), 0.0, 1.0);
  Vector3d b = Vector3d::Zero();
  b[i] = 1.0 - u;
  b[j] = u;
  return b;
}

/** Barycentric coordinates of the flat triangle's point nearest to \p p. */
Vector3d
nearestShare(const Eigen::Matrix3d& corners, const Vector3d& p)
{
  const Vector3d e = corners.col(1) - corners.col(0), f = corners.col(2) - corners.col(0), n = e.cross(f);
  const Vector3d q = p - corners.col(0);
  const double b1 = q.cross(f).dot(n) / n.squaredNorm(), b2 = e.cross(q).dot(n) / n.squaredNorm();
  if (b1 >= 0.0 && b2 >= 0.0 && b1 + b2 <= 1.0)
    return {1.0 - b1 - b2, b1, b2};
  Vector3d best = nearestOnSide(corners, 0, 1, p);
  for (const int k : {1, 2}) {
    const Vector3d other = nearestOnSide(corners, k, (k + 1) % 3, p);
    if ((corners * other - p).squaredNorm() < (corners * best - p).squaredNorm())
      best = other;
  }
  return best;
}

double
distanceTo(const FaceBox& box, const Vector3d& p)
{
  const auto& low = box.min_corner();
  const auto& high = box.max_corner();
  const Vector3d off(std::max({0.0, low.get<0>() - p.x(), p.x() - high.get<0>()}), std::max({0.0, low.get<1>() - p.y(), p.y() - high.get<1>()}),
                     std::max({0.0, low.get<2>() - p.z(), p.z() - high.get<2>()}));
  return off.norm();
}

} // namespace

struct MeshFeet::Tree {
  explicit Tree(const std::vector<std::pair<FaceBox, std::uint32_t>>& boxes) : faces(boxes) {}
  bgi::rtree<std::pair<FaceBox, std::uint32_t>, bgi::rstar<16>> faces;
};

MeshFeet::MeshFeet(const SurfaceMesh& mesh) : mesh_(mesh)
{
  std::vector<std::pair<FaceBox, std::uint32_t>> boxes;
  boxes.reserve(mesh.faceCount());
  for (std::uint32_t t = 0; t < mesh.faceCount(); ++t) {
    Eigen::AlignedBox3d box;
    for (const std::uint32_t v : mesh.triangles().triangle(t))
      box.extend(mesh.position(v));
    boxes.push_back({{{box.min().x(), box.min().y(), box.min().z()}, {box.max().x(), box.max().y(), box.max().z()}}, t});
  }
  tree_ = std::make_unique<const Tree>(boxes);
}

MeshFeet::~MeshFeet() = default;

MeshFoot
MeshFeet::of(const Vector3d& p) const
{
  constexpr double on_side = 1e-9; // a share
  MeshFoot foot;
  foot.distance = std::numeric_limits<double>::infinity();
  const auto count = static_cast<unsigned int>(mesh_.faceCount());
  for (auto it = tree_->faces.qbegin(bgi::nearest(Place(p.x(), p.y(), p.z()), count)); it != tree_->faces.qend(); ++it) {
    if (distanceTo(it->first, p) > foot.distance) // boxes come nearest first
      break;
    const Eigen::Matrix3d corners = mesh_.patch(it->second).corners;
    const Vector3d share = nearestShare(corners, p);
    const double distance = (corners * share - p).norm();
    if (distance < foot.distance || (distance == foot.distance && it->second < foot.face)) {
      foot.face = it->second;
      foot.share = share;
      foot.distance = distance;
    }
  }
  const MeshPatch patch = mesh_.patch(foot.face);
  foot.position = patch.position(foot.share);
  foot.normal = patch.normal(foot.share);
  for (int k = 0; k < 3; ++k)
    if (foot.share[(k + 2) % 3] < on_side && mesh_.triangles().opposite(3 * foot.face + static_cast<std::uint32_t>(k)) == Triangulation::none)
      foot.beyond = true;
  return foot;
}

} // namespace pcl_spiral
