// SPDX-License-Identifier: BSD-3-Clause
#include "local_star.h"

#include "core/simd_clones.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl_spiral {
namespace {

using Sites = double __attribute__((vector_size(32))); // four at a time
using SiteCounts = long long __attribute__((vector_size(32)));
constexpr int lane_sites = 4;

constexpr int frame_sites = 4;     // sides of the square, before the neighbours
constexpr int usually_enough = 16; // neighbours
constexpr double touching = 2e-9;  // of a site's half square: a bisector that comes so near a corner cuts nothing off

struct Cell {
  const double *u, *v, *half_square; ///< filled up with zeros to whole lanes
  int count;                         ///< of them, a multiple of four
  double* cut;                       ///< as many
};

/** Among the sites that cut at nearly the least place of the edge of site \p own: the first one along the
 * turn, if it does cut off the corner of the next one. If \p start is among them, it ends the walk. */
int
chosen(const Cell& cell, int own, int start, double perhaps)
{
  const double *u = cell.u, *v = cell.v, *cut = cell.cut;
  int next = -1;
  for (int j = 0; j < cell.count; ++j) {
    if (cut[j] > perhaps)
      continue;
    if (j == start)
      return start;
    if (next < 0) {
      next = j;
      continue;
    }
    const bool in_turn = u[next] * v[j] - v[next] * u[j] > 0.0;
    const int first = in_turn ? next : j, second = in_turn ? j : next;
    const double ahead = u[own] * v[first] - v[own] * u[first];
    next = (cut[second] - cut[first]) * ahead > touching * cell.half_square[first] ? first : second;
  }
  return next;
}

/** Walk round the cell from site \p start: writes the sites of its edges and where each edge ends, in
 * multiples of
 *  (-v, u) from the midpoint to its site. Returns their number. */
PCL_SPIRAL_SIMD_CLONES int
walkRound(const Cell& cell, int start, int* edges, double* ends)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr Sites nowhere = {infinity, infinity, infinity, infinity};
  constexpr SiteCounts lane = {0, 1, 2, 3};
  const double *const all_u = cell.u, *const all_v = cell.v, *const half_squares = cell.half_square;
  double* const cuts = cell.cut;
  const int count = cell.count;
  int own = start, edge_count = 0;
  do {
    const double own_u = all_u[own], own_v = all_v[own];
    Sites least_of = nowhere;
    for (int j = 0; j < count; j += lane_sites) {
      Sites u, v, half_square;
      std::memcpy(&u, all_u + j, sizeof u);
      std::memcpy(&v, all_v + j, sizeof v);
      std::memcpy(&half_square, half_squares + j, sizeof half_square);
      const Sites ahead = own_u * v - own_v * u, room = half_square - 0.5 * (own_u * u + own_v * v);
      const Sites cut = ahead > 0.0 ? room / ahead : nowhere;
      std::memcpy(cuts + j, &cut, sizeof cut);
      least_of = cut < least_of ? cut : least_of;
    }
    const double least = std::min(std::min(least_of[0], least_of[1]), std::min(least_of[2], least_of[3]));
    const double perhaps = least + 1e-6 * (1.0 + std::abs(least));
    SiteCounts hits = {0, 0, 0, 0}, places = hits;
    for (int j = 0; j < count; j += lane_sites) {
      Sites cut;
      std::memcpy(&cut, cuts + j, sizeof cut);
      const SiteCounts hit = cut <= perhaps; // -1 where true
      hits -= hit;
      places += hit & (lane + j);
    }
    edges[edge_count] = own;
    ends[edge_count++] = least;
    own = hits[0] + hits[1] + hits[2] + hits[3] == 1 ? static_cast<int>(places[0] + places[1] + places[2] + places[3])
                                                     : chosen(cell, own, start, perhaps);
  } while (own != start && edge_count < count);
  return edge_count;
}

} // namespace

void
LocalStar::setSites(const double* u, const double* v, int count, double half_width)
{
  const int sites = frame_sites + count - 1, room = sites + lane_sites;
  if (static_cast<int>(u_.size()) < room) {
    for (auto* array : {&u_, &v_, &half_square_, &cut_, &ends_})
      array->resize(room);
    edges_.resize(room);
  }
  const double frame_u[frame_sites] = {1.0, 0.0, -1.0, 0.0}, frame_v[frame_sites] = {0.0, 1.0, 0.0, -1.0};
  for (int side = 0; side < frame_sites; ++side) {
    u_[side] = 2.0 * half_width * frame_u[side];
    v_[side] = 2.0 * half_width * frame_v[side];
  }
  std::copy(u + 1, u + count, u_.begin() + frame_sites);
  std::copy(v + 1, v + count, v_.begin() + frame_sites);
  for (auto* array : {&u_, &v_})
    std::fill_n(array->begin() + sites, lane_sites, 0.0);
  for (int j = 0; j < room; ++j) {
    const double half_square = 0.5 * (u_[j] * u_[j] + v_[j] * v_[j]);
    half_square_[j] = half_square > 0.0 ? half_square : std::numeric_limits<double>::infinity(); // at the point itself
  }
}

void
LocalStar::walk(int sites, double max_circumradius)
{
  const auto start =
      static_cast<int>(std::min_element(half_square_.begin(), half_square_.begin() + sites) - half_square_.begin()); // it has an edge
  const Cell cell{u_.data(), v_.data(), half_square_.data(), (sites + lane_sites - 1) / lane_sites * lane_sites, cut_.data()};
  const int edges = walkRound(cell, start, edges_.data(), ends_.data());
  spokes_.clear();
  corners_.clear();
  double farthest = 0.0; // squared
  for (int k = 0; k < edges; ++k) {
    const int own = edges_[k], next = edges_[k + 1 == edges ? 0 : k + 1];
    const double end = ends_[k], squared = 2.0 * half_square_[own] * (0.25 + end * end);
    corners_.push_back({0.5 * u_[own] - end * v_[own], 0.5 * v_[own] + end * u_[own]});
    farthest = std::max(farthest, squared);
    if (own >= frame_sites)
      spokes_.push_back({own - frame_sites + 1, squared <= max_circumradius * max_circumradius && next >= frame_sites});
  }
  reach_ = std::min(std::sqrt(farthest), 2.0 * max_circumradius);
}

bool
LocalStar::cutsCorner(int first, int end) const
{
  for (int j = first; j < end; ++j)
    if (half_square_[j] <= 2.0 * reach_ * reach_)
      for (const Corner& corner : corners_)
        if (u_[j] * corner.u + v_[j] * corner.v > (1.0 + touching) * half_square_[j])
          return true;
  return false;
}

void
LocalStar::compute(const double* u, const double* v, int count, double max_circumradius)
{
  setSites(u, v, count, 2.0 * max_circumradius);
  const int sites = frame_sites + count - 1, few = std::min(sites, frame_sites + usually_enough);
  walk(few, max_circumradius);
  if (cutsCorner(few, sites))
    walk(sites, max_circumradius);
}

} // namespace pcl_spiral
