// SPDX-License-Identifier: BSD-3-Clause
#include "flat_regions.h"

#include "straight_ends.h"

#include "core/angle_between.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;
constexpr std::uint32_t none = Triangulation::none;

/** Twice the area of a face, along its normal. */
Vector3d
crossOf(const Triangulation& mesh, const std::vector<Vector3d>& positions, std::uint32_t t)
{
  const auto& f = mesh.triangle(t);
  return (positions[f[1]] - positions[f[0]]).cross(positions[f[2]] - positions[f[0]]);
}

double
lengthOf(const Triangulation& mesh, const std::vector<Vector3d>& positions, std::uint32_t h)
{
  return (positions[mesh.target(h)] - positions[mesh.origin(h)]).norm();
}

/** Whether all coordinates are decimals of a few digits: \p unit is the last digit's, by the power of ten of the coordinate. They come as
 *  floats, each rounded by up to 2^-24 of itself. */
template <typename Unit>
bool
areDecimals(const std::vector<Vector3d>& positions, const Unit& unit)
{
  const double rounding = std::ldexp(1.01, -24);
  return std::all_of(positions.begin(), positions.end(), [&](const Vector3d& p) {
    return std::all_of(p.data(), p.data() + 3, [&](double x) {
      const double last = x != 0.0 ? unit(static_cast<int>(std::floor(std::log10(std::abs(x))))) : 1.0;
      return std::abs(x - last * std::round(x / last)) <= rounding * std::abs(x);
    });
  });
}

/** By how much each coordinate may be rounded: files in text have a number of decimals, or of digits. More of them than floats hold tell
 *  nothing. */
double
roundingOf(const std::vector<Vector3d>& positions, double largest)
{
  constexpr int most = 7; // digits: floats hold no more
  const double of_floats = std::ldexp(largest, -24);
  const auto power = [](int n) { return std::pow(10.0, n); };
  const int magnitude = static_cast<int>(std::floor(std::log10(largest)));
  const auto least = [&](const auto& last) { // half of the largest last digit that all coordinates have
    for (int n = 0; n <= most; ++n)
      if (0.5 * last(n, magnitude) > 2.0 * of_floats && areDecimals(positions, [&](int m) { return last(n, m); }))
        return 0.5 * last(n, magnitude);
    return of_floats;
  };
  const auto fixed = [&](int n, int) { return power(-n); };
  const auto digits = [&](int n, int m) { return power(m - n + 1); };
  const double by_decimals = least(fixed), by_digits = least(digits);
  return by_decimals > of_floats && by_digits > of_floats ? std::min(by_decimals, by_digits) : std::max(by_decimals, by_digits);
}

/** Grows regions of faces in one plane. */
class RegionGrowth {
public:
  RegionGrowth(const Triangulation& mesh, const std::vector<Vector3d>& positions, const std::vector<std::uint8_t>& creases)
  : mesh_(mesh), positions_(positions), creases_(creases), crosses_(mesh.triangleCount())
  {
    double largest = 0.0;
    for (const Vector3d& p : positions)
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    exact_ = 8.0 * std::ldexp(largest, -24);
    same_ = 8.0 * roundingOf(positions, largest);
#pragma omp parallel for schedule(static)
    for (std::int64_t t = 0; t < static_cast<std::int64_t>(crosses_.size()); ++t)
      crosses_[t] = crossOf(mesh, positions, static_cast<std::uint32_t>(t));
  }

  /** Each region begins at the largest face that is in none. */
  FlatRegions grow()
  {
    FlatRegions r;
    r.of_face.assign(mesh_.triangleCount(), none);
    std::vector<std::uint32_t> order(mesh_.triangleCount());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<double> sizes(order.size());
    std::transform(crosses_.begin(), crosses_.end(), sizes.begin(), [](const Vector3d& c) { return c.squaredNorm(); });
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return sizes[a] > sizes[b]; });
    for (const std::uint32_t seed : order)
      if (r.of_face[seed] == none)
        r.normals.push_back(growFrom(seed, static_cast<std::uint32_t>(r.normals.size()), r.of_face));
    return r;
  }

private:
  /** The plane of one small face is not sure far away: it is taken anew from the faces found, and the search goes on at the rim. */
  Vector3d growFrom(std::uint32_t seed, std::uint32_t region, std::vector<std::uint32_t>& of_face)
  {
    constexpr int planes = 16;
    of_face[seed] = region;
    faces_.assign(1, seed);
    Vector3d normal;
    for (int i = 0; i < planes; ++i) {
      const std::size_t before = faces_.size();
      normal = planeOfFaces();
      for (std::size_t k = 0; k < faces_.size(); ++k)
        for (std::uint32_t h = 3 * faces_[k]; h < 3 * faces_[k] + 3; ++h)
          if (const std::uint32_t other = mesh_.opposite(h);
              other != none && !creases_[h] && of_face[other / 3] == none && liesInPlane(other / 3, normal)) {
            of_face[other / 3] = region;
            faces_.push_back(other / 3);
          }
      if (faces_.size() == before)
        break;
    }
    return normal;
  }

  Vector3d planeOfFaces()
  {
    Vector3d cross = Vector3d::Zero(), moment = Vector3d::Zero();
    double weight = 0.0;
    for (const std::uint32_t t : faces_) {
      const auto& f = mesh_.triangle(t);
      const double w = crosses_[t].norm();
      cross += crosses_[t];
      moment += w / 3.0 * (positions_[f[0]] + positions_[f[1]] + positions_[f[2]]);
      weight += w;
    }
    middle_ = moment / weight;
    return cross.normalized();
  }

  /** Off the plane by no more than the rounding of floats, or by that of the file where the face does not lean from it as facets do. */
  bool liesInPlane(std::uint32_t t, const Vector3d& normal) const
  {
    constexpr double least_lean = 0.5 / 57.3; // radians: half the bend at the seam of a round with facets of two degrees
    const auto& f = mesh_.triangle(t);
    double off = 0.0;
    for (const std::uint32_t v : f)
      off = std::max(off, std::abs(normal.dot(positions_[v] - middle_)));
    const double along = crosses_[t].dot(normal), lean = std::atan2(crosses_[t].cross(normal).norm(), along);
    return along > 0.0 && (off <= exact_ || (off <= same_ && lean < least_lean));
  }

  const Triangulation& mesh_;
  const std::vector<Vector3d>& positions_;
  const std::vector<std::uint8_t>& creases_;
  std::vector<Vector3d> crosses_;
  double exact_ = 0.0, same_ = 0.0; ///< mm: how far off a plane a corner in it may be, by floats, and by the digits of the file
  std::vector<std::uint32_t> faces_;
  Vector3d middle_;
};

/** Twice the area over the length of the rim: of a long strip about its width. */
std::vector<double>
widthsOf(const Triangulation& mesh, const std::vector<Vector3d>& positions, const FlatRegions& regions)
{
  std::vector<double> widths(regions.normals.size(), 0.0), rims(widths);
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h) {
    if (h % 3 == 0)
      widths[regions.of_face[h / 3]] += crossOf(mesh, positions, h / 3).norm();
    if (!regions.isInside(mesh, h))
      rims[regions.of_face[h / 3]] += lengthOf(mesh, positions, h);
  }
  for (std::size_t g = 0; g < widths.size(); ++g)
    widths[g] = rims[g] > 0.0 ? widths[g] / rims[g] : 0.0;
  return widths;
}

/** Half-edges on the rim of each region, region after region. */
struct Rims {
  std::vector<std::uint32_t> begin, edges;
};

Rims
rimsOf(const Triangulation& mesh, const FlatRegions& regions)
{
  Rims rims;
  rims.begin.assign(regions.normals.size() + 1, 0);
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    rims.begin[regions.of_face[h / 3] + 1] += !regions.isInside(mesh, h);
  std::partial_sum(rims.begin.begin(), rims.begin.end(), rims.begin.begin());
  rims.edges.resize(rims.begin.back());
  std::vector<std::uint32_t> next(rims.begin.begin(), rims.begin.end() - 1);
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    if (!regions.isInside(mesh, h))
      rims.edges[next[regions.of_face[h / 3]]++] = h;
  return rims;
}

/** Judges the rims of regions. */
class RimJudge {
public:
  RimJudge(const Triangulation& mesh, const std::vector<Vector3d>& positions, const std::vector<std::uint8_t>& creases,
           const FlatRegions& regions)
  : mesh_(mesh), positions_(positions), creases_(creases), regions_(regions), widths_(widthsOf(mesh, positions, regions)),
    rims_(rimsOf(mesh, regions))
  {}

  /** Whether the surface ends to bend at the rim edge \p h of a region, whose other side is \p other. */
  bool isSeam(std::uint32_t h, std::uint32_t other) const
  {
    const double ratio = widths_[regions_.of_face[h / 3]] / widths_[regions_.of_face[other / 3]];
    return ratio >= longer && endsStraight(ratio, bendShare(h, other));
  }

private:
  /** See endsStraight(). */
  double bendShare(std::uint32_t h, std::uint32_t other) const
  {
    const std::uint32_t far = farSide(other);
    if (far == none)
      return std::nan("");
    const std::uint32_t own = regions_.of_face[h / 3], strip = regions_.of_face[other / 3],
                        next = regions_.of_face[mesh_.opposite(far) / 3];
    const Vector3d along = (positions_[mesh_.target(h)] - positions_[mesh_.origin(h)]).normalized();
    const auto bend = [&](std::uint32_t a, std::uint32_t b) { return regions_.normals[a].cross(regions_.normals[b]).dot(along); };
    return bend(own, strip) / bend(strip, next) * (widths_[strip] + widths_[next]) / widths_[strip];
  }

  /** The nearest edge of the region at half-edge \p near that runs beside it, with another face beyond and no crease; or none. */
  std::uint32_t farSide(std::uint32_t near) const
  {
    constexpr double beside = 0.95;          // cosine: 18 degrees
    constexpr std::uint32_t most_edges = 64; // of a strip; more have large faces beside them
    const std::uint32_t strip = regions_.of_face[near / 3], before = regions_.of_face[mesh_.opposite(near) / 3];
    if (rims_.begin[strip + 1] - rims_.begin[strip] > most_edges)
      return none;
    const auto vectorOf = [&](std::uint32_t h) -> Vector3d { return positions_[mesh_.target(h)] - positions_[mesh_.origin(h)]; };
    const auto middleOf = [&](std::uint32_t h) -> Vector3d { return 0.5 * (positions_[mesh_.target(h)] + positions_[mesh_.origin(h)]); };
    const Vector3d along = vectorOf(near).normalized();
    std::uint32_t best = none;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t k = rims_.begin[strip]; k < rims_.begin[strip + 1]; ++k) {
      const std::uint32_t h = rims_.edges[k], other = mesh_.opposite(h);
      const double length = vectorOf(h).norm(), away = (middleOf(h) - middleOf(near)).norm();
      if (other != none && !creases_[h] && regions_.of_face[other / 3] != before && -vectorOf(h).dot(along) > beside * length &&
          away < least) {
        least = away;
        best = h;
      }
    }
    return best;
  }

  const Triangulation& mesh_;
  const std::vector<Vector3d>& positions_;
  const std::vector<std::uint8_t>& creases_;
  const FlatRegions& regions_;
  std::vector<double> widths_;
  Rims rims_;
};

/** Whether no direction has less than zero, but for rounding. */
bool
isPositive(const Eigen::Matrix3d& symmetric)
{
  constexpr double rounding = 1e-6;
  const Vector3d values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
  return values.minCoeff() >= -rounding * values.cwiseAbs().maxCoeff();
}

/** The flat region with the largest angle at the vertex of sector \p s, or none. */
std::uint32_t
flatAbout(const Triangulation& mesh, const std::vector<Vector3d>& positions, const CornerSectors& sectors, const FlatRegions& regions,
          std::uint32_t s)
{
  const auto angleIn = [&](std::uint32_t region) {
    double angle = 0.0;
    for (std::uint32_t k = sectors.begin[s]; k < sectors.begin[s + 1]; ++k)
      if (const std::uint32_t h = sectors.corners[k]; regions.of_face[h / 3] == region) {
        const Vector3d& at = positions[mesh.origin(h)];
        const Vector3d a = positions[mesh.target(h)] - at, b = positions[mesh.origin(Triangulation::previous(h))] - at;
        angle += angleBetween(a, b);
      }
    return angle;
  };
  std::uint32_t best = none;
  double most = 0.0;
  for (std::uint32_t k = sectors.begin[s]; k < sectors.begin[s + 1]; ++k)
    if (const std::uint32_t region = regions.flatAt(sectors.corners[k] / 3); region != none && region != best)
      if (const double angle = angleIn(region); angle > most) {
        most = angle;
        best = region;
      }
  return best;
}

} // namespace

FlatRegions
flatRegions(const Triangulation& mesh, const std::vector<Vector3d>& positions, const std::vector<std::uint8_t>& creases)
{
  FlatRegions r = RegionGrowth(mesh, positions, creases).grow();
  const RimJudge judge(mesh, positions, creases, r);
  // Of the rim, in each direction: more of seams than of what may bend.
  std::vector<Eigen::Matrix3d> seams(r.normals.size(), Eigen::Matrix3d::Zero());
  std::vector<std::uint32_t> faces(seams.size(), 0);
  std::vector<std::uint8_t> ends(seams.size(), 0);
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h) {
    const std::uint32_t g = r.of_face[h / 3], other = mesh.opposite(h);
    faces[g] += h % 3 == 0;
    if (other == none || creases[h] || r.isInside(mesh, h))
      continue;
    const Vector3d edge = positions[mesh.target(h)] - positions[mesh.origin(h)], across = edge.cross(r.normals[g]);
    const bool seam = judge.isSeam(h, other);
    ends[g] = ends[g] || seam;
    seams[g] += (seam ? 1.0 : -1.0) / edge.norm() * across * across.transpose();
  }
  r.flat.resize(seams.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t g = 0; g < static_cast<std::int64_t>(seams.size()); ++g)
    r.flat[g] = faces[g] >= 2 && ends[g] && isPositive(seams[g]);
  return r;
}

void
addFlatCreases(const Triangulation& mesh, const FlatRegions& regions, std::vector<std::uint8_t>& creases)
{
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    if (const std::uint32_t other = mesh.opposite(h);
        other != none && !regions.isInside(mesh, h) && regions.flatAt(h / 3) != none && regions.flatAt(other / 3) != none)
      creases[h] = 1;
}

std::vector<std::uint8_t>
fitLimits(const Triangulation& mesh, const FlatRegions& regions, const std::vector<std::uint8_t>& creases)
{
  std::vector<std::uint8_t> limits = creases;
  for (std::uint32_t h = 0; h < mesh.halfEdgeCount(); ++h)
    if (const std::uint32_t other = mesh.opposite(h);
        other != none && !regions.isInside(mesh, h) && (regions.flatAt(h / 3) != none || regions.flatAt(other / 3) != none))
      limits[h] = 1;
  return limits;
}

void
takeFlatNormals(const Triangulation& mesh, const std::vector<Vector3d>& positions, const CornerSectors& sectors, const FlatRegions& regions,
                std::vector<Vector3d>& normals)
{
#pragma omp parallel for schedule(dynamic, 256)
  for (std::int64_t s = 0; s < static_cast<std::int64_t>(sectors.count()); ++s)
    if (const std::uint32_t region = flatAbout(mesh, positions, sectors, regions, static_cast<std::uint32_t>(s)); region != none)
      normals[s] = regions.normals[region];
}

} // namespace pcl_spiral
