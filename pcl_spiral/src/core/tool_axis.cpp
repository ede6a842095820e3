#include <pcl_spiral/core/tool_axis.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace pcl_spiral {

namespace {

using Eigen::Vector3d;
using Vectors = std::vector<Vector3d>;

constexpr double spin_part = 0.9; // of the limit, for the spin of the feed at constant share
constexpr double tilt_part = 0.4; // for the change of the share: across the spin, so that 0.9^2 + 0.4^2 < 1

double
angleBetween(const Vector3d& a, const Vector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/** Not less than the angle between two unit vectors: pi/2 times their chord, and a little. */
double
boundOfAngle(const Vector3d& a, const Vector3d& b)
{
  return 1.6 * (b - a).norm();
}

/** Feed direction of the points \p first to \p end, all at one place. */
Vector3d
chordAt(const Polyline& points, std::size_t first, std::size_t end)
{
  const Vector3d back = first > 0 ? Vector3d(points[first] - points[first - 1]) : Vector3d(Vector3d::Zero());
  const Vector3d ahead =
      end < points.size() ? Vector3d(points[end] - points[first]) : Vector3d(Vector3d::Zero());
  const double f = back.squaredNorm(), g = ahead.squaredNorm();
  return f > 0.0 && g > 0.0 ? Vector3d(back / f + ahead / g) : Vector3d(back + ahead);
}

Vector3d
tangentialPart(const Vector3d& chord, const Vector3d& normal)
{
  const Vector3d tangential = chord - normal * normal.dot(chord);
  return tangential.norm() > 1e-9 * chord.norm() ? tangential.normalized() : Vector3d(Vector3d::Zero());
}

/** Call \p visit(i, feed) for every point, in parallel. */
template <typename Visit>
void
forEachFeed(const Polyline& points, const Vectors& normals, Visit visit)
{
  const auto n = static_cast<std::int64_t>(points.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t first = 0; first < n; ++first) {
    if (first > 0 && points[first] == points[first - 1])
      continue; // served with the first of its run
    std::int64_t end = first + 1;
    while (end < n && points[end] == points[first])
      ++end;
    const Vector3d chord = chordAt(points, first, end);
    for (std::int64_t i = first; i < end; ++i)
      visit(i, tangentialPart(chord, normals[i]));
  }
}

/** Two angles, ready to be set at many points. */
struct Tilt {
  Tilt(double side_tilt, double lead)
      : side_cos(std::cos(side_tilt)), side_sin(std::sin(side_tilt)), lead_cos(std::cos(lead)), lead_sin(std::sin(lead))
  {
  }

  Vector3d
  axis(const Vector3d& normal, const Vector3d& feed) const
  {
    if (feed.isZero(0.0))
      return normal;
    const Vector3d sideways = side_cos * normal + side_sin * feed.cross(normal);
    return (lead_cos * sideways + lead_sin * feed).normalized();
  }

  double side_cos, side_sin, lead_cos, lead_sin;
};

/** A path of which every move is to stay under its limit. */
class RateLimiter {
public:
  RateLimiter(const Polyline& points, const Vectors& normals, const ToolAxisOptions& options)
      : points_(points), normals_(normals), options_(options),
        tilt_(std::acos(std::cos(options.side_tilt) * std::cos(options.lead))), full_(points.size()),
        shares_(points.size(), 1.0)
  {
    const Tilt tilt(options.side_tilt, options.lead);
    forEachFeed(points, normals,
                [&](std::size_t i, const Vector3d& feed) { full_[i] = tilt.axis(normals_[i], feed); });
  }

  void
  limit()
  {
    const auto moves = static_cast<std::int64_t>(shares_.size()) - 1;
    std::vector<double> caps(moves);
#pragma omp parallel for schedule(static)
    for (std::int64_t i = 0; i < moves; ++i)
      caps[i] = cap(i);
    for (int round = 0; round < 60; ++round) {
      passes(caps);
      bool kept = true;
      for (std::int64_t i = 0; i < moves; ++i) {
        const double least = std::min(shares_[i], shares_[i + 1]);
        if (least < 1.0 && change(i, shares_[i], shares_[i + 1]) > allowed(i) * (1.0 + 1e-9) + 1e-12) {
          caps[i] = 0.8 * least;
          kept = false;
        }
      }
      if (kept)
        return;
    }
  }

  ToolAxes
  result()
  {
    ToolAxes r;
    const auto n = static_cast<std::int64_t>(shares_.size());
    for (std::int64_t i = 0; i < n; ++i)
      if (shares_[i] < 1.0) {
        full_[i] = axis(i, shares_[i]);
        ++r.limited_points;
        r.largest_reduction = std::max(r.largest_reduction, tilt_ - angleBetween(normals_[i], full_[i]));
      }
    r.axes = std::move(full_);
    r.tilt_share = std::move(shares_);
    double largest_change = 0.0, largest_rate = 0.0;
    std::size_t exceeded = 0;
#pragma omp parallel for schedule(static) reduction(max : largest_change, largest_rate) reduction(+ : exceeded)
    for (std::int64_t i = 1; i < n; ++i) {
      const double ds = length(i - 1), bound = boundOfAngle(r.axes[i - 1], r.axes[i]);
      if (bound > largest_change || bound > largest_rate * ds) {
        const double turn = angleBetween(r.axes[i - 1], r.axes[i]);
        largest_change = std::max(largest_change, turn);
        if (ds > 0.0)
          largest_rate = std::max(largest_rate, turn / ds);
      }
      const double most = options_.max_rate * ds;
      exceeded += options_.max_rate > 0.0 && boundOfAngle(normals_[i - 1], normals_[i]) > most && byNormals(i - 1) > most;
    }
    r.largest_change = largest_change;
    r.largest_rate = largest_rate;
    r.exceeded_moves = exceeded;
    return r;
  }

private:
  double
  length(std::size_t move) const
  {
    return (points_[move + 1] - points_[move]).norm();
  }

  /** Turn of the normal on a move. */
  double
  byNormals(std::size_t move) const
  {
    return angleBetween(normals_[move], normals_[move + 1]);
  }

  /** Turn allowed on a move: never less than what the normals do. */
  double
  allowed(std::size_t move) const
  {
    return std::max(options_.max_rate * length(move), byNormals(move));
  }

  Vector3d
  axis(std::size_t i, double share) const
  {
    if (share == 1.0)
      return full_[i];
    std::size_t first = i, end = i + 1;
    while (first > 0 && points_[first - 1] == points_[i])
      --first;
    while (end < points_.size() && points_[end] == points_[i])
      ++end;
    return tiltedAxis(normals_[i], tangentialPart(chordAt(points_, first, end), normals_[i]),
                      share * options_.side_tilt, share * options_.lead);
  }

  double
  change(std::size_t i, double share, double next_share) const
  {
    return angleBetween(axis(i, share), axis(i + 1, next_share));
  }

  /** Largest equal share of both ends that leaves room for a change of share. */
  double
  cap(std::size_t i) const
  {
    if (boundOfAngle(full_[i], full_[i + 1]) <= spin_part * options_.max_rate * length(i))
      return 1.0; // nearly always
    const double limit = std::max(spin_part * allowed(i), byNormals(i));
    if (change(i, 1.0, 1.0) <= limit)
      return 1.0;
    double low = 0.0, high = 1.0;
    for (int k = 0; k < 30; ++k) {
      const double middle = 0.5 * (low + high);
      (change(i, middle, middle) <= limit ? low : high) = middle;
    }
    return low;
  }

  /** The largest shares under the caps that change slowly enough: the same from either end. Each depends on the one
   *  before, so this is serial; where nothing is limited it only looks. */
  void
  passes(const std::vector<double>& caps)
  {
    const std::size_t n = shares_.size();
    for (std::size_t i = 0; i < n; ++i)
      shares_[i] = std::min(i ? caps[i - 1] : 1.0, i + 1 < n ? caps[i] : 1.0);
    for (std::size_t i = 1; i < n; ++i)
      if (shares_[i - 1] < shares_[i])
        shares_[i] = std::min(shares_[i], shares_[i - 1] + tilt_part * allowed(i - 1) / tilt_);
    for (std::size_t i = n - 1; i-- > 0;)
      if (shares_[i + 1] < shares_[i])
        shares_[i] = std::min(shares_[i], shares_[i + 1] + tilt_part * allowed(i) / tilt_);
  }

  const Polyline& points_;
  const Vectors& normals_;
  ToolAxisOptions options_;
  double tilt_;  ///< angle between axis and normal at full share
  Vectors full_; ///< axes at full share
  std::vector<double> shares_;
};

void
checkSizes(const Polyline& points, const Vectors& normals)
{
  if (points.size() != normals.size())
    throw std::invalid_argument("feedDirections: needs one normal a point");
}

} // namespace

std::vector<Vector3d>
feedDirections(const Polyline& points, const Vectors& normals)
{
  checkSizes(points, normals);
  Vectors feeds(points.size());
  forEachFeed(points, normals, [&](std::size_t i, const Vector3d& feed) { feeds[i] = feed; });
  return feeds;
}

Vector3d
tiltedAxis(const Vector3d& normal, const Vector3d& feed, double side_tilt, double lead)
{
  return Tilt(side_tilt, lead).axis(normal, feed);
}

ToolAxes
toolAxes(const Polyline& points, const Vectors& normals, const ToolAxisOptions& options)
{
  const double right_angle = std::acos(0.0);
  if (!(std::abs(options.side_tilt) < right_angle) || !(std::abs(options.lead) < right_angle))
    throw std::invalid_argument("toolAxes: side tilt and lead must be under 90 degrees");
  if (!(options.max_rate >= 0.0))
    throw std::invalid_argument("toolAxes: the axis rate must not be negative");
  checkSizes(points, normals);
  RateLimiter limiter(points, normals, options);
  if (points.size() > 1 && options.max_rate > 0.0 && (options.side_tilt != 0.0 || options.lead != 0.0))
    limiter.limit();
  return limiter.result();
}

} // namespace pcl_spiral
