#include <pcl_spiral/geodesic/geodesic_refinement.h>

#include "geodesic_steps.h"
#include "line_spline.h"

#include <algorithm>
#include <cmath>

namespace pcl_spiral {
namespace {

using Eigen::Vector3d;

constexpr double least_scale = 1.0 / 32.0;    // of a step that is being shortened
constexpr double coarse_tolerance = 2e-4;     // of the segments' length: enough at the coarser levels
constexpr double longest_step = 1.5;          // in segments
constexpr double uneven = 1.8;                // a chord so many times the mean is a jump
constexpr int most_stalls = 3;                // iterations that bring next to nothing

/** One line on its way. */
class Refiner {
public:
  Refiner(GeodesicLine& line, const RefinementOptions& options, double spacing)
  : line_(line), options_(options), spacing_(spacing), start_(line.points)
  {}

  /** Ends and their feet; a line without length is done. */
  void
  begin(const SurfaceFoot& first, const SurfaceFoot& last)
  {
    ends_[0] = first;
    ends_[1] = last;
    ends_[0].position = start_.front();
    ends_[1].position = start_.back();
  }

  void
  startLevel(int segments, bool finest)
  {
    segments_ = static_cast<std::size_t>(segments);
    finest_ = finest;
    phase_ = Phase::Starting;
    iterations_ = stalls_ = 0;
    line_.left_surface = line_.converged = false;
    line_.largest_move = std::numeric_limits<double>::infinity();
    candidate_ = refined_ ? LineSpline(line_.points).resampled(segments_ + 1) : resampled(start_, segments_ + 1);
  }

  bool active() const { return phase_ != Phase::Done; }
  const Polyline& candidate() const { return candidate_; }

  /** Take the feet of the candidate's inner points, and make the next candidate or be done. */
  void
  take(const SurfaceFoot* inner)
  {
    feet_.assign(1, ends_[0]);
    feet_.insert(feet_.end(), inner, inner + segments_ - 1);
    feet_.push_back(ends_[1]);
    const std::size_t fault = firstFault();
    if (phase_ == Phase::Starting)
      takeStart(fault);
    else
      takeStep(fault);
  }

private:
  enum class Phase { Starting, Stepping, Done };

  /** First point off the surface, or on another sheet than its neighbours; 0 if there is none. */
  std::size_t
  firstFault() const
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
  takeStart(std::size_t fault)
  {
    if (fault == 0) {
      accept();
      return;
    }
    if (refined_) { // the coarser level has lost the surface: from the start again
      refined_ = false;
      candidate_ = resampled(start_, segments_ + 1);
      return;
    }
    if (finest_)
      keepCandidate();
    leave(fault);
  }

  void
  takeStep(std::size_t fault)
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
  accept()
  {
    keepCandidate();
    refined_ = true;
    moves_ = options_.method == RefinementMethod::TridiagonalNewton ? tridiagonalStep(line_.points, line_.feet)
                                                                     : conjugateGradientStep(line_.points, line_.feet);
    double largest = 0.0;
    for (std::size_t i = 1; i < segments_; ++i) {
      const Vector3d along = (line_.points[i + 1] - line_.points[i - 1]).normalized();
      largest = std::max(largest, (moves_[i] - along * along.dot(moves_[i])).norm());
    }
    stalls_ = largest > 0.9 * line_.largest_move ? stalls_ + 1 : 0;
    line_.largest_move = largest;
    const double segment = line_.length / static_cast<double>(segments_);
    const double enough = finest_ ? options_.tolerance : std::max(options_.tolerance, coarse_tolerance * segment);
    line_.converged = largest <= enough;
    if (line_.converged || iterations_++ >= options_.max_iterations || stalls_ > most_stalls) {
      phase_ = Phase::Done;
      return;
    }
    phase_ = Phase::Stepping;
    scale_ = std::min(1.0, longest_step * segment / largest);
    propose();
  }

  void
  propose()
  {
    Polyline moved = line_.points;
    for (std::size_t i = 1; i < segments_; ++i)
      moved[i] += scale_ * moves_[i];
    candidate_ = LineSpline(moved).resampled(segments_ + 1);
  }

  Polyline
  positions() const
  {
    Polyline points;
    for (const SurfaceFoot& foot : feet_)
      points.push_back(foot.position);
    return points;
  }

  void
  keepCandidate()
  {
    line_.points = positions();
    line_.feet = feet_;
    line_.length = LineSpline(line_.points).length();
  }

  void
  leave(std::size_t fault)
  {
    line_.left_surface = true;
    line_.left_at = candidate_[fault];
    phase_ = Phase::Done;
  }

  GeodesicLine& line_;
  const RefinementOptions& options_;
  double spacing_;
  Polyline start_, candidate_, moves_;
  SurfaceFoot ends_[2];
  std::vector<SurfaceFoot> feet_;
  std::size_t segments_ = 0;
  bool finest_ = false, refined_ = false;
  Phase phase_ = Phase::Done;
  int iterations_ = 0, stalls_ = 0;
  double scale_ = 1.0;
};

/** Project the candidates of all active lines together, until none is active. */
void
runLevel(const MlsSurface& surface, std::vector<Refiner>& refiners)
{
  std::vector<std::size_t> active, begin;
  std::vector<Vector3d> queries;
  std::vector<SurfaceFoot> feet;
  for (;;) {
    active.clear();
    begin.clear();
    queries.clear();
    for (std::size_t k = 0; k < refiners.size(); ++k)
      if (refiners[k].active()) {
        const Polyline& line = refiners[k].candidate();
        active.push_back(k);
        begin.push_back(queries.size());
        queries.insert(queries.end(), line.begin() + 1, line.end() - 1);
      }
    if (active.empty())
      return;
    surface.project(queries, feet);
    const auto count = static_cast<std::int64_t>(active.size());
#pragma omp parallel for schedule(dynamic, 4)
    for (std::int64_t a = 0; a < count; ++a)
      refiners[active[a]].take(feet.data() + begin[a]);
  }
}

bool
usable(const GeodesicLine& line)
{
  if (line.points.size() < 2)
    return false;
  for (const Vector3d& p : line.points)
    if (!p.allFinite())
      return false;
  return length(line.points) > 0.0;
}

} // namespace

void
refineGeodesics(const MlsSurface& surface, const RefinementOptions& options, std::vector<GeodesicLine>& lines)
{
  std::vector<Vector3d> ends;
  std::vector<Refiner> refiners;
  refiners.reserve(lines.size());
  for (GeodesicLine& line : lines) {
    Polyline start;
    start.swap(line.points);
    line = GeodesicLine();
    line.points.swap(start);
    if (!usable(line))
      continue;
    ends.push_back(line.points.front());
    ends.push_back(line.points.back());
    refiners.emplace_back(line, options, surface.graph().spacing());
  }
  std::vector<SurfaceFoot> feet;
  surface.project(ends, feet);
  for (std::size_t k = 0; k < refiners.size(); ++k)
    refiners[k].begin(feet[2 * k], feet[2 * k + 1]);
  for (std::size_t level = 0; level < options.levels.size(); ++level) {
    for (Refiner& refiner : refiners)
      refiner.startLevel(std::max(2, options.levels[level]), level + 1 == options.levels.size());
    runLevel(surface, refiners);
  }
}

} // namespace pcl_spiral
