// SPDX-License-Identifier: BSD-3-Clause
#include "outline_corners.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/polyline.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_spiral {
namespace {

constexpr double longest_piece = 40.0; // spacings
constexpr double shortest_piece = 8.0; // spacings; a shorter piece shows no direction
constexpr double noise = 0.3;          // standard deviation of the ring about the edge, spacings
constexpr double break_cost = 16.0;    // in squared noise: what one more piece must save
constexpr double least_turn = 15.0 * pi / 180.0;

/** A parabola through a run of points, in the frame of its chord. */
struct Piece {
  double cost = std::numeric_limits<double>::infinity();
  double first_heading = 0.0, last_heading = 0.0; ///< of the tangent at its ends
};

Piece
fitPiece(const std::vector<Eigen::Vector2d>& line, std::size_t from, std::size_t to, double spacing)
{
  Piece piece;
  const Eigen::Vector2d chord = line[to] - line[from];
  const double length = chord.norm();
  if (!(length > 0.0))
    return piece;
  const Eigen::Vector2d e = chord / length, f(-e.y(), e.x());
  const Eigen::Vector2d middle = 0.5 * (line[from] + line[to]);
  double s1 = 0, s2 = 0, s3 = 0, s4 = 0, y0 = 0, y1 = 0, y2 = 0, yy = 0;
  for (std::size_t i = from; i <= to; ++i) {
    const Eigen::Vector2d d = (line[i] - middle) / spacing;
    const double x = d.dot(e), y = d.dot(f), xx = x * x;
    s1 += x, s2 += xx, s3 += xx * x, s4 += xx * xx;
    y0 += y, y1 += x * y, y2 += xx * y, yy += y * y;
  }
  const auto n = static_cast<double>(to - from + 1);
  const double l2 = 0.25 * length * length / (spacing * spacing);
  // A very small weight on the bend, so that three points do not give any parabola.
  Eigen::Matrix3d a;
  a << n, s1, s2, s1, s2, s3, s2, s3, s4 + 0.1 * l2 * l2;
  const Eigen::Vector3d right(y0, y1, y2);
  const Eigen::Vector3d c = a.ldlt().solve(right);
  piece.cost = std::max(0.0, yy - c.dot(right)) / (noise * noise);
  const double heading = std::atan2(e.y(), e.x()), half = 0.5 * length / spacing;
  piece.first_heading = heading + std::atan(c[1] - 2.0 * c[2] * half);
  piece.last_heading = heading + std::atan(c[1] + 2.0 * c[2] * half);
  return piece;
}

/** Places where the cheapest chain of pieces over [begin, end] of the line breaks, including both ends. */
std::vector<std::size_t>
cheapestBreaks(const std::vector<Eigen::Vector2d>& line, const std::vector<double>& at, std::size_t begin, std::size_t end, double spacing)
{
  std::vector<double> best(end - begin + 1, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(end - begin + 1, begin);
  best[0] = 0.0;
  for (std::size_t to = begin + 1; to <= end; ++to)
    for (std::size_t from = to; from-- > begin;) {
      if (at[to] - at[from] > longest_piece * spacing && to - from > 3)
        break;
      const double cost = best[from - begin] + fitPiece(line, from, to, spacing).cost + break_cost;
      if (cost < best[to - begin]) {
        best[to - begin] = cost;
        before[to - begin] = from;
      }
    }
  std::vector<std::size_t> breaks{end};
  while (breaks.back() != begin)
    breaks.push_back(before[breaks.back() - begin]);
  std::reverse(breaks.begin(), breaks.end());
  return breaks;
}

double
headingOf(const std::vector<Eigen::Vector2d>& line, std::size_t i)
{
  return std::atan2(line[i + 1].y() - line[i].y(), line[i + 1].x() - line[i].x());
}

double
turn(double from, double to)
{
  return std::remainder(to - from, 2.0 * pi);
}

/** Move sharp corners to the point nearby that sticks out most: breaks between pieces are often beside a tip. */
void
moveToTips(const std::vector<Eigen::Vector3d>& points, double spacing, std::vector<CornerCandidate>& corners)
{
  constexpr double least_turn_of_tip = 60.0 * pi / 180.0, arm = 8.0; // spacings
  const std::size_t n = points.size(), count = corners.size();
  // Entry of the ring up to an arm's length from a corner, at most half-way to the next corner in that direction.
  const auto armsEnd = [&](std::size_t c, bool forward) {
    const std::size_t from = corners[c].point, other = corners[forward ? (c + 1) % count : (c + count - 1) % count].point;
    const std::size_t apart = forward ? (other + n - from) % n : (from + n - other) % n;
    const std::size_t most = (apart == 0 ? n : apart) / 2;
    std::size_t i = from;
    double run = 0.0;
    for (std::size_t k = 0; k < most && run < arm * spacing; ++k) {
      const std::size_t next = forward ? (i + 1) % n : (i + n - 1) % n;
      run += (points[next] - points[i]).norm();
      i = next;
    }
    return i;
  };
  std::vector<CornerCandidate> moved = corners;
  for (std::size_t c = 0; c < count; ++c) {
    if (std::abs(corners[c].turn) < least_turn_of_tip)
      continue;
    const std::size_t begin = armsEnd(c, false), end = armsEnd(c, true);
    const Eigen::Vector3d& a = points[begin];
    const Eigen::Vector3d along = (points[end] - a).normalized();
    double farthest = 0.0;
    for (std::size_t i = begin; i != end; i = (i + 1) % n) {
      const Eigen::Vector3d d = points[i] - a;
      if (const double distance = (d - d.dot(along) * along).norm(); distance > farthest) {
        farthest = distance;
        moved[c].point = i;
      }
    }
  }
  corners = std::move(moved);
}

} // namespace

std::vector<Eigen::Vector2d>
rolledOut(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& normals, std::size_t rounds)
{
  const std::size_t n = points.size();
  std::vector<Eigen::Vector2d> line{Eigen::Vector2d::Zero()};
  double heading = 0.0;
  for (std::size_t i = 0; i < rounds * n; ++i) {
    const Eigen::Vector3d edge = points[(i + 1) % n] - points[i % n];
    if (i > 0) {
      const Eigen::Vector3d& up = normals[i % n];
      const Eigen::Vector3d last = points[i % n] - points[(i - 1) % n];
      const Eigen::Vector3d from = last - last.dot(up) * up, to = edge - edge.dot(up) * up;
      heading += std::atan2(from.cross(to).dot(up), from.dot(to));
    }
    line.push_back(line.back() + edge.norm() * Eigen::Vector2d(std::cos(heading), std::sin(heading)));
  }
  return line;
}

namespace {

/** The entry from \p from to \p to that lies farthest off the chord between the entries beside them. */
std::size_t
farthestOut(const std::vector<Eigen::Vector2d>& line, std::size_t from, std::size_t to)
{
  const Eigen::Vector2d& a = line[from - 1];
  const Eigen::Vector2d chord = line[to + 1] - a, across(-chord.y(), chord.x());
  std::size_t farthest = from;
  for (std::size_t i = from; i <= to; ++i)
    if (std::abs((line[i] - a).dot(across)) > std::abs((line[farthest] - a).dot(across)))
      farthest = i;
  return farthest;
}

/** Corners, found among all of the points given. */
std::vector<CornerCandidate>
cornersAmong(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& normals, double spacing)
{
  const std::size_t n = points.size();
  const std::vector<Eigen::Vector2d> line = rolledOut(points, normals, 3);
  std::vector<double> at(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i)
    at[i] = at[i - 1] + (line[i] - line[i - 1]).norm();
  // A first chain begins at an arbitrary point. A second one begins at a break of the first, as far from its ends as possible.
  const std::vector<std::size_t> first = cheapestBreaks(line, at, 0, 2 * n, spacing);
  const auto nearer = [&](std::size_t a, std::size_t b) { return std::abs(at[a] - at[n]) < std::abs(at[b] - at[n]); };
  const std::size_t begin = first.size() > 2 ? *std::min_element(first.begin() + 1, first.end() - 1, nearer) : n;
  const std::vector<std::size_t> breaks = cheapestBreaks(line, at, begin, begin + n, spacing);
  // Pieces too short to have a direction are skipped: what counts is how their neighbours meet.
  struct Run {
    std::size_t from, to;
    Piece piece;
  };
  std::vector<Run> runs;
  for (std::size_t b = 0; b + 1 < breaks.size(); ++b)
    if (at[breaks[b + 1]] - at[breaks[b]] >= shortest_piece * spacing)
      runs.push_back({breaks[b], breaks[b + 1], fitPiece(line, breaks[b], breaks[b + 1], spacing)});
  const double round = headingOf(line, begin) - headingOf(line, begin + n); // heading before one round less that after it
  std::vector<CornerCandidate> corners;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Run &before = runs[r == 0 ? runs.size() - 1 : r - 1], &after = runs[r];
    const double angle = turn(before.piece.last_heading + (r == 0 ? round : 0.0), after.piece.first_heading);
    const std::size_t short_pieces = (after.from + n - before.to % n) % n; // their points
    const std::size_t from = n + before.to % n;
    if (std::abs(angle) > least_turn)
      corners.push_back({farthestOut(line, from, from + short_pieces) % n, angle});
  }
  const auto byPoint = [](const auto& a, const auto& b) { return a.point < b.point; };
  std::sort(corners.begin(), corners.end(), byPoint);
  moveToTips(points, spacing, corners);
  std::sort(corners.begin(), corners.end(), byPoint);
  return corners;
}

/** Points of a closed line among which corners are searched: all of them. Of a line far denser than the cloud, such as a scan
 *  line along the rim, only points a quarter of a spacing apart, because the time grows with the square of their number in
 *  a piece. \p at: places along the line. */
std::vector<std::size_t>
pointsToSeekAmong(const std::vector<double>& at, double spacing)
{
  constexpr double densest = 4.0; // points per spacing
  const std::size_t count = at.size() - 1;
  const bool dense = static_cast<double>(count) > densest * at.back() / spacing;
  // In both directions from the first point to half of the way round, so that a mirrored line is searched alike.
  std::vector<std::size_t> sought{0};
  double last = 0.0;
  const auto seek = [&](std::size_t i) {
    if (dense && std::abs(at[i] - last) < spacing / densest)
      return;
    sought.push_back(i);
    last = at[i];
  };
  std::size_t half = 1;
  for (; half < count && at[half] <= 0.5 * at.back(); ++half)
    seek(half);
  last = at.back();
  for (std::size_t i = count; i-- > half;)
    seek(i);
  std::sort(sought.begin(), sought.end());
  return sought;
}

} // namespace

std::vector<CornerCandidate>
cornerCandidates(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3d>& normals, double spacing)
{
  const std::vector<std::size_t> sought = pointsToSeekAmong(arcLengths(points, true), spacing);
  if (sought.size() == points.size())
    return cornersAmong(points, normals, spacing);
  std::vector<Eigen::Vector3d> some_points, some_normals;
  for (const std::size_t i : sought) {
    some_points.push_back(points[i]);
    some_normals.push_back(normals[i]);
  }
  std::vector<CornerCandidate> corners = cornersAmong(some_points, some_normals, spacing);
  for (CornerCandidate& corner : corners)
    corner.point = sought[corner.point];
  return corners;
}

} // namespace pcl_spiral
