#include <pcl_spiral/core/tool_axis.h>

#include <algorithm>
#include <cmath>
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

/** A path of which every move is to stay under its limit. */
class RateLimiter {
public:
  RateLimiter(const Polyline& points, const Vectors& normals, const ToolAxisOptions& options)
      : normals_(normals), feeds_(feedDirections(points, normals)), options_(options),
        tilt_(std::acos(std::cos(options.side_tilt) * std::cos(options.lead))), arc_(arcLengths(points))
  {
    const std::size_t n = points.size();
    shares_.assign(n, 1.0);
    for (std::size_t i = 0; i < n; ++i)
      full_.push_back(tiltedAxis(normals_[i], feeds_[i], options.side_tilt, options.lead));
    for (std::size_t i = 0; i + 1 < n; ++i) {
      by_normals_.push_back(angleBetween(normals_[i], normals_[i + 1]));
      allowed_.push_back(std::max(options.max_rate * (arc_[i + 1] - arc_[i]), by_normals_.back()));
    }
  }

  Vector3d
  axis(std::size_t i, double share) const
  {
    return share == 1.0
               ? full_[i]
               : tiltedAxis(normals_[i], feeds_[i], share * options_.side_tilt, share * options_.lead);
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
    const double limit = std::max(spin_part * allowed_[i], by_normals_[i]);
    if (change(i, 1.0, 1.0) <= limit)
      return 1.0;
    double low = 0.0, high = 1.0;
    for (int k = 0; k < 30; ++k) {
      const double middle = 0.5 * (low + high);
      (change(i, middle, middle) <= limit ? low : high) = middle;
    }
    return low;
  }

  void
  limit()
  {
    const std::size_t moves = shares_.size() - 1;
    std::vector<double> caps(moves);
    for (std::size_t i = 0; i < moves; ++i)
      caps[i] = cap(i);
    for (int round = 0; round < 60; ++round) {
      passes(caps);
      bool kept = true;
      for (std::size_t i = 0; i < moves; ++i)
        if (std::min(shares_[i], shares_[i + 1]) < 1.0 &&
            change(i, shares_[i], shares_[i + 1]) > allowed_[i] * (1.0 + 1e-9) + 1e-12) {
          caps[i] = 0.8 * std::min(shares_[i], shares_[i + 1]);
          kept = false;
        }
      if (kept)
        return;
    }
  }

  ToolAxes
  result() const
  {
    ToolAxes r;
    r.tilt_share = shares_;
    for (std::size_t i = 0; i < shares_.size(); ++i) {
      r.axes.push_back(axis(i, shares_[i]));
      if (shares_[i] < 1.0) {
        ++r.limited_points;
        r.largest_reduction = std::max(r.largest_reduction, tilt_ - angleBetween(normals_[i], r.axes[i]));
      }
      if (i == 0)
        continue;
      const double turn = angleBetween(r.axes[i - 1], r.axes[i]), ds = arc_[i] - arc_[i - 1];
      r.largest_change = std::max(r.largest_change, turn);
      if (ds > 0.0)
        r.largest_rate = std::max(r.largest_rate, turn / ds);
      r.exceeded_moves += options_.max_rate > 0.0 && by_normals_[i - 1] > options_.max_rate * ds;
    }
    return r;
  }

private:
  /** The largest shares under the caps that change slowly enough: the same from either end. */
  void
  passes(const std::vector<double>& caps)
  {
    const std::size_t n = shares_.size();
    for (std::size_t i = 0; i < n; ++i)
      shares_[i] = std::min(i ? caps[i - 1] : 1.0, i + 1 < n ? caps[i] : 1.0);
    for (std::size_t i = 1; i < n; ++i)
      shares_[i] = std::min(shares_[i], shares_[i - 1] + tilt_part * allowed_[i - 1] / tilt_);
    for (std::size_t i = n - 1; i-- > 0;)
      shares_[i] = std::min(shares_[i], shares_[i + 1] + tilt_part * allowed_[i] / tilt_);
  }

  const Vectors& normals_;
  Vectors feeds_;
  ToolAxisOptions options_;
  double tilt_; ///< angle between axis and normal at full share
  std::vector<double> arc_;
  Vectors full_;                   ///< axes at full share
  std::vector<double> by_normals_; ///< turn of the normal on each move
  std::vector<double> allowed_;    ///< turn allowed on each move: never less than what the normals do
  std::vector<double> shares_;
};

} // namespace

std::vector<Vector3d>
feedDirections(const Polyline& points, const Vectors& normals)
{
  if (points.size() != normals.size())
    throw std::invalid_argument("feedDirections: needs one normal a point");
  const std::size_t n = points.size();
  Vectors feeds(n, Vector3d::Zero());
  for (std::size_t first = 0, end; first < n; first = end) { // a run of points at one place
    for (end = first + 1; end < n && points[end] == points[first];)
      ++end;
    const Vector3d back =
        first > 0 ? Vector3d(points[first] - points[first - 1]) : Vector3d(Vector3d::Zero());
    const Vector3d ahead = end < n ? Vector3d(points[end] - points[first]) : Vector3d(Vector3d::Zero());
    const double f = back.squaredNorm(), g = ahead.squaredNorm();
    const Vector3d chord = f > 0.0 && g > 0.0 ? Vector3d(back / f + ahead / g) : Vector3d(back + ahead);
    for (std::size_t i = first; i < end; ++i) {
      const Vector3d tangential = chord - normals[i] * normals[i].dot(chord);
      if (tangential.norm() > 1e-9 * chord.norm())
        feeds[i] = tangential.normalized();
    }
  }
  return feeds;
}

Vector3d
tiltedAxis(const Vector3d& normal, const Vector3d& feed, double side_tilt, double lead)
{
  if (feed.isZero(0.0))
    return normal;
  const Vector3d sideways = std::cos(side_tilt) * normal + std::sin(side_tilt) * feed.cross(normal);
  return (std::cos(lead) * sideways + std::sin(lead) * feed).normalized();
}

ToolAxes
toolAxes(const Polyline& points, const Vectors& normals, const ToolAxisOptions& options)
{
  const double right_angle = std::acos(0.0);
  if (!(std::abs(options.side_tilt) < right_angle) || !(std::abs(options.lead) < right_angle))
    throw std::invalid_argument("toolAxes: side tilt and lead must be under 90 degrees");
  if (!(options.max_rate >= 0.0))
    throw std::invalid_argument("toolAxes: the axis rate must not be negative");
  RateLimiter limiter(points, normals, options);
  if (points.size() > 1 && options.max_rate > 0.0 && (options.side_tilt != 0.0 || options.lead != 0.0))
    limiter.limit();
  return limiter.result();
}

} // namespace pcl_spiral
