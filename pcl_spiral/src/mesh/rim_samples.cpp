// SPDX-License-Identifier: BSD-3-Clause
#include "rim_samples.h"

#include "dart_throwing.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/mesh/impl/mesh_rims.h>

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr double corner = 20.0; // degrees: a rim has a point where it turns by more
constexpr int pieces = 8;       // of a curved edge, to measure it

bool
isBefore(const Vector3d& a, const Vector3d& b)
{
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

/** Puts points along one rim after the other. */
class RimWalk {
public:
  RimWalk(const SurfaceMesh& mesh, double step) : mesh_(mesh), step_(step) {}

  /** Puts points at the corners of a rim, and evenly between them. */
  void add(const MeshRim& rim)
  {
    const std::vector<std::size_t> corners = cornersOf(rim);
    for (std::size_t c = 0; c < corners.size(); ++c)
      addRun(rim, corners[c], c + 1 < corners.size() ? corners[c + 1] : corners[0] + rim.half_edges.size());
  }

  const std::vector<RimSample>& samples() const { return samples_; }
  const std::vector<Dart>& darts() const { return darts_; } ///< corners go before the others

private:
  /** Edges at whose start the rim turns; without any, the edge that starts at the least coordinates, for any order of the faces. */
  std::vector<std::size_t> cornersOf(const MeshRim& rim) const
  {
    const std::size_t n = rim.half_edges.size();
    const double least = std::cos(corner * pi / 180.0);
    const auto direction = [&](std::size_t k) {
      const std::uint32_t h = rim.half_edges[k % n];
      return (edgePlace(mesh_, h, 1.0) - edgePlace(mesh_, h, 0.0)).normalized().eval();
    };
    std::vector<std::size_t> corners;
    std::size_t first = 0;
    for (std::size_t k = 0; k < n; ++k) {
      if (direction(k).dot(direction(k + n - 1)) < least)
        corners.push_back(k);
      if (isBefore(edgePlace(mesh_, rim.half_edges[k], 0.0), edgePlace(mesh_, rim.half_edges[first], 0.0)))
        first = k;
    }
    return corners.empty() ? std::vector<std::size_t>{first} : corners;
  }

  /** From the start of edge \p from to that of \p to, which belongs to the next run. */
  void addRun(const MeshRim& rim, std::size_t from, std::size_t to)
  {
    const std::size_t n = rim.half_edges.size();
    std::vector<double> reached{0.0};
    for (std::size_t k = from; k < to; ++k)
      for (int i = 0; i < pieces; ++i) {
        const std::uint32_t h = rim.half_edges[k % n];
        reached.push_back(reached.back() + (edgePlace(mesh_, h, (i + 1.0) / pieces) - edgePlace(mesh_, h, i / double(pieces))).norm());
      }
    const auto parts = static_cast<std::size_t>(std::max(1.0, std::ceil(reached.back() / step_)));
    std::size_t piece = 0;
    for (std::size_t p = 0; p < parts; ++p) {
      const double s = reached.back() * static_cast<double>(p) / static_cast<double>(parts);
      while (piece + 2 < reached.size() && reached[piece + 1] <= s)
        ++piece;
      const double whole = reached[piece + 1] - reached[piece];
      const double u = (static_cast<double>(piece % pieces) + (whole > 0.0 ? (s - reached[piece]) / whole : 0.0)) / pieces;
      addSample(rim.half_edges[(from + piece / pieces) % n], u, p == 0);
    }
  }

  void addSample(std::uint32_t h, double u, bool is_corner)
  {
    const Vector3d normal = (1.0 - u) * mesh_.normal(h) + u * mesh_.normal(Triangulation::next(h));
    samples_.push_back({edgePlace(mesh_, h, u).cast<float>(), normal.normalized().cast<float>(), h / 3});
    darts_.push_back({samples_.back().position, is_corner ? 1u : 2u});
  }

  const SurfaceMesh& mesh_;
  double step_;
  std::vector<RimSample> samples_;
  std::vector<Dart> darts_;
};

} // namespace

std::vector<RimSample>
rimSamples(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& chosen, double step, double apart)
{
  RimWalk walk(mesh, step);
  for (const MeshRim& rim : meshRims(mesh, chosen))
    walk.add(rim);
  std::vector<RimSample> samples;
  for (const std::uint32_t i : throwDarts(walk.darts(), apart))
    samples.push_back(walk.samples()[i]);
  return samples;
}

} // namespace pcl_spiral
