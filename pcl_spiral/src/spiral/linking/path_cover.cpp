// SPDX-License-Identifier: BSD-3-Clause
#include "path_cover.h"

#include "common/stoppable_loop.h"
#include "cover_tests.h"
#include "spiral/lines/segment_set.h"
#include "spiral/path/path_densify.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double aim = 0.49;        // distance to which an uncovered place is brought
constexpr double moved_reach = 2.2; // the path this near to it may move
constexpr double looked_at = 1.0;   // the nearest segment of a test point is one of those within this
constexpr double bell = 0.8;        // half the length of path that one place moves
constexpr double grain = 0.05;      // of the path where it moves
constexpr auto bell_points = static_cast<std::size_t>(bell / grain);
constexpr double damping = 0.7;
constexpr int most_rounds = 24;

/** Points first to last of a pass. */
struct PathRun {
  std::size_t first = 0, last = 0;
};

/** A test point that a moving path may uncover. */
struct Watched {
  Eigen::Vector3d point;
  StepOverMetric metric;
  std::vector<PathRun> runs; ///< of the path near it
  std::size_t segment = 0;   ///< the nearest, from its point of the path to the next
  double share = 0.0;        ///< along it
  double distance = 0.0;     ///< an upper limit: it includes how far the nearest segment has moved since
};

class Mover {
public:
  Mover(const StepOverDistance& field, LinkedPath& path) : field_(field), path_(path) {}

  bool run(double held, const ProgressCallback& progress, CoverFigures& figures)
  {
    if (!watch(held, partOf(progress, 0.0, 0.5), figures))
      return false;
    for (; !watched_.empty() && figures.rounds < most_rounds; ++figures.rounds) {
      std::vector<std::size_t> open;
      if (!openPlaces(partOf(progress, 0.5 + 0.5 * figures.rounds / most_rounds, 0.5 + 0.5 * (figures.rounds + 1) / most_rounds), open))
        return false;
      figures.left = open.size();
      figures.farthest = open.empty() ? covered : watched_[open.front()].distance;
      if (open.empty())
        break;
      figures.farthest_place = watched_[open.front()].point;
      pull(open);
      if (!move())
        break;
    }
    return true;
  }

private:
  bool watch(double held, const ProgressCallback& progress, CoverFigures& figures);
  void findNear(const SegmentSet& line, const std::vector<std::size_t>& places, const CoverTests& tests,
                std::vector<std::uint8_t>& near) const;
  bool findRuns(const std::function<bool(double)>& progress);
  SegmentSet movingLines() const;
  void measure(Watched& at) const;
  bool openPlaces(const ProgressCallback& progress, std::vector<std::size_t>& open);
  void pull(const std::vector<std::size_t>& open);
  bool isTaken(std::size_t centre) const;
  bool move();

  const StepOverDistance& field_;
  LinkedPath& path_;
  std::vector<Watched> watched_;
  std::vector<std::uint8_t> near_;     ///< one a point of the path: 1 within reach of an uncovered place
  std::vector<std::uint8_t> moves_;    ///< the same without the held points
  std::vector<Eigen::Vector3d> shift_; ///< one a point of the path, zero between rounds
  std::vector<std::uint8_t> taken_;    ///< the same: middles of this round's bells
  std::vector<std::size_t> pulled_;    ///< points with a shift, some twice
  std::vector<std::size_t> centres_;   ///< points taken
};

/** Find the uncovered places, the parts of the path that may move towards them, and the test points these may uncover. */
bool
Mover::watch(double held, const ProgressCallback& progress, CoverFigures& figures)
{
  const SegmentSet line = passLines(path_);
  CoverTests tests;
  if (!coverTests(field_, path_, line, partOf(progress, 0.0, 0.4), tests))
    return false;
  figures.farthest_before = covered;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < tests.size(); ++i)
    if (tests.distances[i] > covered) {
      places.push_back(i);
      figures.farthest_before = std::max(figures.farthest_before, tests.distances[i]);
    }
  figures.farthest = figures.farthest_before;
  figures.places = places.size();
  if (places.empty())
    return true;
  std::vector<std::uint8_t> near(path_.points.size(), 0);
  findNear(line, places, tests, near);
  densify(near, held, grain, path_, near_, moves_);
  shift_.assign(path_.points.size(), Eigen::Vector3d::Zero());
  taken_.assign(path_.points.size(), 0);
  std::vector<std::size_t> watched;
  if (!testsToWatch(tests, places, partOf(progress, 0.4, 0.7), watched))
    return false;
  for (const std::size_t i : watched)
    watched_.push_back({tests.points[i], tests.metric[i], {}, 0, 0.0, tests.distances[i]});
  return findRuns(partOf(progress, 0.7, 1.0, "coverage"));
}

/** The runs of the path near each watched point, and its nearest segment. */
bool
Mover::findRuns(const std::function<bool(double)>& progress)
{
  const SegmentSet lines = movingLines();
  return stoppableLoop(0, static_cast<std::int64_t>(watched_.size()), progress, [&](std::int64_t i) {
    Watched& at = watched_[i];
    std::vector<std::size_t> segments;
    lines.forSegmentsNear(at.point, at.metric, looked_at, [&](std::size_t s) { segments.push_back(lines.label(s) + lines.place(s)); });
    std::sort(segments.begin(), segments.end());
    for (const std::size_t s : segments) {
      if (at.runs.empty() || s > at.runs.back().last + 2 || passOf(path_.passes, s) != passOf(path_.passes, at.runs.back().first))
        at.runs.push_back({s, s + 1});
      at.runs.back().last = std::max(at.runs.back().last, s + 1);
    }
    measure(at);
  });
}

/** Mark the points of the path within reach of \p places. */
void
Mover::findNear(const SegmentSet& line, const std::vector<std::size_t>& places, const CoverTests& tests,
                std::vector<std::uint8_t>& near) const
{
  const auto count = static_cast<std::int64_t>(places.size());
#pragma omp parallel
  {
    std::vector<std::size_t> found;
#pragma omp for schedule(dynamic, 256) nowait
    for (std::int64_t i = 0; i < count; ++i)
      line.forSegmentsNear(tests.points[places[i]], tests.metric[places[i]], moved_reach,
                           [&](std::size_t s) { found.push_back(line.label(s) + line.place(s)); });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
#pragma omp critical
    for (const std::size_t s : found)
      near[s] = near[s + 1] = 1;
  }
}

/** The runs of the path that may move, with the point on either side; a run's label is its first point. */
SegmentSet
Mover::movingLines() const
{
  SegmentSet lines;
  const std::size_t n = path_.points.size();
  const auto follows = [this, n](std::size_t i) { return i > 0 && i < n && !beginsPass(path_.passes, i); };
  const auto counts = [&](std::size_t i) { return near_[i] || (follows(i) && near_[i - 1]) || (follows(i + 1) && near_[i + 1]); };
  for (std::size_t i = 0; i < n;) {
    std::size_t end = i;
    while (end < n && counts(end) && (end == i || !beginsPass(path_.passes, end)))
      ++end;
    if (end > i)
      lines.add(Polyline(path_.points.begin() + static_cast<std::ptrdiff_t>(i), path_.points.begin() + static_cast<std::ptrdiff_t>(end)),
                false, i);
    i = std::max(end, i + 1);
  }
  lines.build();
  return lines;
}

void
Mover::measure(Watched& at) const
{
  double least = at.runs.empty() ? 0.0 : 1e30;
  for (const PathRun& run : at.runs)
    for (std::size_t s = run.first; s < run.last; ++s) {
      double share = 0.0;
      const double d = distanceFromSegment(at.point, at.metric, path_.points[s], path_.points[s + 1], share);
      if (d < least) {
        least = d;
        at.segment = s;
        at.share = share;
      }
    }
  at.distance = least;
}

/** The uncovered watched points, the farthest first. */
bool
Mover::openPlaces(const ProgressCallback& progress, std::vector<std::size_t>& open)
{
  const bool whole =
      stoppableLoop(0, static_cast<std::int64_t>(watched_.size()), partOf(progress, 0.0, 1.0, "coverage"), [this](std::int64_t i) {
        if (watched_[i].distance > covered)
          measure(watched_[i]);
      });
  open.clear();
  for (std::size_t i = 0; i < watched_.size(); ++i)
    if (watched_[i].distance > covered)
      open.push_back(i);
  std::sort(open.begin(), open.end(), [this](std::size_t a, std::size_t b) {
    return watched_[a].distance != watched_[b].distance ? watched_[a].distance > watched_[b].distance : a < b;
  });
  return whole;
}

/** Whether the middle of another bell is near. */
bool
Mover::isTaken(std::size_t centre) const
{
  const std::size_t low = centre - std::min(centre, bell_points / 3), high = std::min(taken_.size() - 1, centre + bell_points / 3);
  return std::any_of(taken_.begin() + static_cast<std::ptrdiff_t>(low), taken_.begin() + static_cast<std::ptrdiff_t>(high) + 1,
                     [](std::uint8_t t) { return t != 0; });
}

/** Set the shifts towards \p open places, as bells along the path. */
void
Mover::pull(const std::vector<std::size_t>& open)
{
  for (const std::size_t i : open) {
    const Watched& at = watched_[i];
    const std::size_t centre = at.segment + (at.share > 0.5 ? 1 : 0);
    if (isTaken(centre))
      continue;
    taken_[centre] = 1;
    centres_.push_back(centre);
    const Eigen::Vector3d foot = (1.0 - at.share) * path_.points[at.segment] + at.share * path_.points[at.segment + 1];
    const Eigen::Vector3d way = (at.point - foot) * ((at.distance - aim) / at.distance);
    const PassRange pass = passRanges(path_.passes, path_.points.size())[passOf(path_.passes, centre)];
    const std::size_t low = std::max(pass.begin, centre - std::min(centre, bell_points)),
                      high = std::min(pass.end - 1, centre + bell_points);
    for (std::size_t k = low; k <= high; ++k)
      if (moves_[k]) {
        const double off = static_cast<double>(k > centre ? k - centre : centre - k) / (static_cast<double>(bell_points) + 1.0);
        shift_[k] += way * (0.5 * (1.0 + std::cos(pi * off)));
        pulled_.push_back(k);
      }
  }
}

/** Move the pulled points; false if there are none. */
bool
Mover::move()
{
  std::sort(pulled_.begin(), pulled_.end());
  pulled_.erase(std::unique(pulled_.begin(), pulled_.end()), pulled_.end());
  for (const std::size_t k : pulled_)
    path_.points[k] += damping * shift_[k];
  const auto moved = [this](std::size_t k) { return shift_[k].isZero() ? 0.0 : path_.metric[k].length(damping * shift_[k]); };
  for (Watched& at : watched_)
    at.distance += std::max(moved(at.segment), moved(std::min(at.segment + 1, shift_.size() - 1)));
  for (const std::size_t k : pulled_)
    shift_[k].setZero();
  for (const std::size_t c : centres_)
    taken_[c] = 0;
  const bool any = !pulled_.empty();
  pulled_.clear();
  centres_.clear();
  return any;
}

} // namespace

bool
coverPath(const StepOverDistance& field, double held, const ProgressCallback& progress, LinkedPath& path, CoverFigures& figures)
{
  figures = CoverFigures();
  return Mover(field, path).run(held, progress, figures);
}

} // namespace pcl_spiral
