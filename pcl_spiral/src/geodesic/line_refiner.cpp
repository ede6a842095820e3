// SPDX-License-Identifier: BSD-3-Clause
#include "line_refiner.h"

#include "geodesic_steps.h"
#include "line_spline.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr double least_scale = 1.0 / 32.0; // of a step that is being shortened
constexpr double coarse_tolerance = 2e-4;  // of the segments' length: enough at the coarser levels
constexpr double longest_step = 1.5;       // in segments
constexpr double uneven = 1.8;             // a chord this many times the mean is a jump
constexpr double slow = 0.97;              // of the smallest move so far: above this an iteration brings no progress
constexpr int most_stalls = 3;             // such iterations in a row
constexpr double probe_distance = 0.5;     // in spacings, either side of the line

} // namespace

void
LineRefiner::begin(const SurfaceFoot& first, const SurfaceFoot& last)
{
  ends_[0] = first;
  ends_[1] = last;
  ends_[0].position = start_.front();
  ends_[1].position = start_.back();
}

void
LineRefiner::startLevel(int segments, bool finest)
{
  segments_ = static_cast<std::size_t>(segments);
  finest_ = finest;
  phase_ = Phase::Starting;
  iterations_ = stalls_ = 0;
  slopes_.clear();
  line_.left_surface = line_.converged = false;
  line_.largest_move = smallest_move_ = std::numeric_limits<double>::infinity();
  candidate_ = refined_ ? LineSpline(line_.points).resampled(segments_ + 1) : resampled(start_, segments_ + 1);
}

void
LineRefiner::appendQueries(Polyline& queries) const
{
  if (phase_ == Phase::Probing)
    for (std::size_t i = 1; i < segments_; ++i) {
      const Vector3d aside = probe_distance * spacing_ * conormal(i);
      queries.push_back(line_.points[i] + aside);
      queries.push_back(line_.points[i] - aside);
    }
  else
    queries.insert(queries.end(), candidate_.begin() + 1, candidate_.end() - 1);
}

void
LineRefiner::take(const SurfaceFoot* inner)
{
  if (phase_ == Phase::Probing) {
    takeProbes(inner);
    return;
  }
  feet_.assign(1, ends_[0]);
  feet_.insert(feet_.end(), inner, inner + segments_ - 1);
  feet_.push_back(ends_[1]);
  const std::size_t fault = firstFault();
  if (phase_ == Phase::Starting)
    takeStart(fault);
  else
    takeStep(fault);
}

Vector3d
LineRefiner::conormal(std::size_t i) const
{
  return line_.feet[i].normal.cross(line_.points[i + 1] - line_.points[i - 1]).normalized();
}

std::size_t
LineRefiner::firstFault() const
{
  const double mean = length(candidate_) / static_cast<double>(segments_);
  for (std::size_t i = 1; i <= segments_; ++i) {
    const bool inside = i < segments_;
    if (inside && (!feet_[i].valid || (feet_[i].position - candidate_[i]).norm() > std::max(0.5 * mean, spacing_)))
      return i;
    if ((feet_[i].position - feet_[i - 1].position).norm() > uneven * mean + 0.1 * spacing_)
      return i;
    if (feet_[i].valid && feet_[i - 1].valid && !(feet_[i].normal.dot(feet_[i - 1].normal) > 0.0))
      return i;
  }
  return 0;
}

void
LineRefiner::takeStart(std::size_t fault)
{
  if (fault == 0) {
    accept();
    return;
  }
  if (refined_) { // the coarser level has lost the surface: start again
    refined_ = false;
    candidate_ = resampled(start_, segments_ + 1);
    return;
  }
  if (finest_)
    keepCandidate();
  leave(fault);
}

void
LineRefiner::takeStep(std::size_t fault)
{
  const bool small = scale_ * line_.largest_move < 0.1 * spacing_;
  if (fault == 0 && (small || LineSpline(positions()).length() <= line_.length * (1.0 + 1e-9))) {
    accept();
    return;
  }
  scale_ *= 0.5;
  if (scale_ >= least_scale)
    propose();
  else if (fault != 0)
    leave(fault);
  else
    phase_ = Phase::Done;
}

void
LineRefiner::accept()
{
  keepCandidate();
  refined_ = true;
  chooseMoves();
}

void
LineRefiner::chooseMoves()
{
  const std::vector<SurfaceFoot> feet = straightened();
  moves_ = options_.method == RefinementMethod::TridiagonalNewton ? tridiagonalStep(line_.points, feet)
                                                                  : conjugateGradientStep(line_.points, feet);
  double largest = 0.0;
  for (std::size_t i = 1; i < segments_; ++i) {
    const Vector3d along = (line_.points[i + 1] - line_.points[i - 1]).normalized();
    largest = std::max(largest, (moves_[i] - along * along.dot(moves_[i])).norm());
  }
  stalls_ = largest > slow * smallest_move_ ? stalls_ + 1 : 0;
  smallest_move_ = std::min(smallest_move_, largest);
  line_.largest_move = largest;
  const double segment = line_.length / static_cast<double>(segments_);
  const double enough = finest_ ? options_.tolerance : std::max(options_.tolerance, coarse_tolerance * segment);
  line_.converged = largest <= enough;
  if (line_.converged || iterations_++ >= options_.max_iterations || stalls_ > most_stalls) {
    phase_ = finest_ && options_.probe_normals && slopes_.empty() ? Phase::Probing : Phase::Done;
    return;
  }
  phase_ = Phase::Stepping;
  scale_ = std::min(1.0, longest_step * segment / largest);
  propose();
}

void
LineRefiner::takeProbes(const SurfaceFoot* probes)
{
  slopes_.assign(segments_ + 1, 0.0);
  for (std::size_t i = 1; i < segments_; ++i) {
    const SurfaceFoot &left = probes[2 * i - 2], &right = probes[2 * i - 1];
    const Vector3d across = left.position - right.position;
    const double run = across.dot(conormal(i));
    if (left.valid && right.valid && run > probe_distance * spacing_)
      slopes_[i] = across.dot(line_.feet[i].normal) / run;
  }
  stalls_ = 0;
  smallest_move_ = std::numeric_limits<double>::infinity();
  chooseMoves();
}

std::vector<SurfaceFoot>
LineRefiner::straightened() const
{
  std::vector<SurfaceFoot> feet = line_.feet;
  for (std::size_t i = 1; !slopes_.empty() && i < segments_; ++i)
    feet[i].normal = (feet[i].normal - slopes_[i] * conormal(i)).normalized();
  return feet;
}

void
LineRefiner::propose()
{
  Polyline moved = line_.points;
  for (std::size_t i = 1; i < segments_; ++i)
    moved[i] += scale_ * moves_[i];
  candidate_ = LineSpline(moved).resampled(segments_ + 1);
}

Polyline
LineRefiner::positions() const
{
  Polyline points;
  for (const SurfaceFoot& foot : feet_)
    points.push_back(foot.position);
  return points;
}

void
LineRefiner::keepCandidate()
{
  line_.points = positions();
  line_.feet = feet_;
  line_.length = LineSpline(line_.points).length();
}

void
LineRefiner::leave(std::size_t fault)
{
  line_.left_surface = true;
  line_.left_at = candidate_[fault];
  phase_ = Phase::Done;
}

} // namespace pcl_spiral
