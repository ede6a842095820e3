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
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double aim = 0.49;         // distance to which an uncovered place is brought
constexpr double moved_reach = 2.2;  // the path this near to it may move
constexpr double looked_at = 1.0;    // the nearest segment of a test point is one of those within this
constexpr double bell = 0.8;         // half the length of path that one place moves
constexpr double cover_grain = 0.05; // of the path where it moves
constexpr auto bell_points = static_cast<std::size_t>(bell / cover_grain);
constexpr double damping = 0.7;
constexpr int most_rounds = 24;

/** Points first to last of a pass. */
struct PathRun {
  std::size_t first = 0, last = 0;
};

/** The path near a test point whose limit was above covered at some time. */
struct NearPath {
  std::vector<PathRun> runs;
  double share = 0.0; ///< along the nearest segment
};

/** A test point that a moving path may uncover: an upper limit of its distance, and the segment of which it was taken. */
struct Watched {
  double distance = 0.0;     ///< includes how far the segment has moved since it was measured
  std::uint32_t segment = 0; ///< from its point of the path to the next
  std::uint32_t test = 0;    ///< the test point
  std::uint32_t near = none; ///< index of its NearPath, which is looked for when the limit is above covered
  std::uint32_t next = none; ///< the next of those that are covered by the same segment

  static constexpr std::uint32_t none = 0xffffffffu;
};

class Mover {
public:
  Mover(const StepOverDistance& field, LinkedPath& path) : field_(field), path_(path) {}

  bool run(double held, const ProgressCallback& progress, CoverFigures& figures)
  {
    if (!watch(held, partOf(progress, 0.0, 0.5), figures))
      return false;
    for (; !watched_.empty() && figures.rounds < most_rounds; ++figures.rounds) {
      if (!measureDoubtful(partOf(progress, 0.5 + 0.5 * figures.rounds / most_rounds, 0.5 + 0.5 * (figures.rounds + 1) / most_rounds)))
        return false;
      figures.left = doubtful_.size();
      figures.farthest = doubtful_.empty() ? covered : watched_[doubtful_.front()].distance;
      if (doubtful_.empty())
        break;
      figures.farthest_place = tests_.points[watched_[doubtful_.front()].test];
      pull();
      if (!move())
        break;
    }
    return true;
  }

private:
  bool watch(double held, const ProgressCallback& progress, CoverFigures& figures);
  void findNear(const SegmentSet& line, const std::vector<std::size_t>& places, std::vector<std::uint8_t>& near) const;
  NearPath nearPath(const Watched& at) const;
  SegmentSet movingLines() const;
  bool isStillCovered(Watched& at) const;
  void measure(Watched& at);
  bool measureDoubtful(const ProgressCallback& progress);
  void pull();
  bool isTaken(std::size_t centre) const;
  void watchTests(const std::vector<std::uint8_t>& near, const std::vector<std::size_t>& dense);
  void cover(std::uint32_t w);
  void raiseLimits(std::size_t segment);
  bool move();

  const StepOverDistance& field_;
  LinkedPath& path_;
  CoverTests tests_;
  std::vector<Watched> watched_;
  std::vector<std::uint32_t> doubtful_;   ///< watched whose limit is above covered
  std::vector<std::uint32_t> covered_by_; ///< one a segment of the path: the first of the watched that it covers
  std::vector<NearPath> near_paths_;
  SegmentSet lines_;                   ///< the parts of the path that may move, as they were at first
  std::vector<std::uint8_t> near_;     ///< one a point of the path: 1 within reach of an uncovered place
  std::vector<std::uint8_t> moves_;    ///< the same without the held points
  std::vector<Eigen::Vector3d> shift_; ///< one a point of the path, zero between rounds
  std::vector<double> moved_;          ///< its length, step-overs, and one more
  std::vector<std::uint8_t> taken_;    ///< the same: middles of this round's bells
  std::vector<std::size_t> pulled_;    ///< points with a shift, some twice
  std::vector<std::size_t> centres_;   ///< points taken
};

/** Find the uncovered places, the parts of the path that may move towards them, and the test points these may uncover. */
bool
Mover::watch(double held, const ProgressCallback& progress, CoverFigures& figures)
{
  auto line = std::make_unique<SegmentSet>(passLines(path_)); // not beside movingLines, which is as large
  if (!coverTests(field_, path_, *line, partOf(progress, 0.0, 0.4), tests_))
    return false;
  figures.farthest_before = covered;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < tests_.size(); ++i)
    if (tests_.nearest[i].distance > covered) {
      places.push_back(i);
      figures.farthest_before = std::max(figures.farthest_before, tests_.nearest[i].distance);
    }
  figures.farthest = figures.farthest_before;
  figures.places = places.size();
  if (places.empty())
    return true;
  std::vector<std::uint8_t> near(path_.points.size() + 1, 0); // the segment of a single point has a second end
  findNear(*line, places, near);
  const auto count = static_cast<std::int64_t>(tests_.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i) // from now on of the path
    if (std::size_t& segment = tests_.nearest[i].segment; segment != NearestSegment::none)
      segment = line->label(segment) + line->place(segment);
  line.reset();
  std::vector<std::size_t> dense;
  densify(near, held, cover_grain, path_, near_, moves_, dense);
  shift_.assign(path_.points.size(), Eigen::Vector3d::Zero());
  moved_.assign(path_.points.size() + 1, 0.0);
  taken_.assign(path_.points.size(), 0);
  watchTests(near, dense);
  lines_ = movingLines();
  return !progress || progress(1.0, "coverage");
}

/** Watch the tests that are uncovered, or covered by a segment that may move. \p near: the points of the path that may, as it
 *  was; \p dense: where these points are now. */
void
Mover::watchTests(const std::vector<std::uint8_t>& near, const std::vector<std::size_t>& dense)
{
  covered_by_.assign(path_.points.size() + 1, Watched::none);
  for (std::size_t i = 0; i < tests_.size(); ++i) {
    Watched at;
    at.distance = tests_.nearest[i].distance;
    at.test = static_cast<std::uint32_t>(i);
    if (const std::size_t p = tests_.nearest[i].segment; p != NearestSegment::none) {
      const std::size_t parts = dense[p + 1] - dense[p];
      if (!(at.distance > covered) && !near[p] && !near[p + 1])
        continue;
      const auto part = std::min(parts - 1, static_cast<std::size_t>(tests_.nearest[i].share * static_cast<double>(parts)));
      at.segment = static_cast<std::uint32_t>(dense[p] + part);
    }
    watched_.push_back(at);
    cover(static_cast<std::uint32_t>(watched_.size() - 1));
  }
  std::vector<NearestSegment>().swap(tests_.nearest);
}

/** Put a watched place to those of its segment, or to the doubtful ones. */
void
Mover::cover(std::uint32_t w)
{
  Watched& at = watched_[w];
  if (at.distance > covered)
    doubtful_.push_back(w);
  else
    at.next = std::exchange(covered_by_[at.segment], w);
}

NearPath
Mover::nearPath(const Watched& at) const
{
  std::vector<std::size_t> segments;
  lines_.forSegmentsNear(tests_.points[at.test], tests_.metric[at.test], looked_at,
                         [&](std::size_t s) { segments.push_back(lines_.label(s) + lines_.place(s)); });
  std::sort(segments.begin(), segments.end());
  NearPath near;
  for (const std::size_t s : segments) {
    if (near.runs.empty() || s > near.runs.back().last + 2 || passOf(path_.passes, s) != passOf(path_.passes, near.runs.back().first))
      near.runs.push_back({s, s + 1});
    near.runs.back().last = std::max(near.runs.back().last, s + 1);
  }
  return near;
}

/** Mark the points of the path within reach of \p places. */
void
Mover::findNear(const SegmentSet& line, const std::vector<std::size_t>& places, std::vector<std::uint8_t>& near) const
{
  const auto count = static_cast<std::int64_t>(places.size());
#pragma omp parallel
  {
    std::vector<std::size_t> found;
#pragma omp for schedule(dynamic, 256) nowait
    for (std::int64_t i = 0; i < count; ++i)
      line.forSegmentsNear(tests_.points[places[i]], tests_.metric[places[i]], moved_reach,
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

/** Whether a place is covered by the segment of which its limit was taken, which has moved since; the limit is then taken of it again. */
bool
Mover::isStillCovered(Watched& at) const
{
  const std::size_t s = at.segment;
  if (s + 1 >= path_.points.size())
    return false;
  double share = 0.0;
  const double d = distanceFromSegment(tests_.points[at.test], tests_.metric[at.test], path_.points[s], path_.points[s + 1], share);
  if (d > covered)
    return false;
  at.distance = d;
  return true;
}

/** Measure a place from the path near it. */
void
Mover::measure(Watched& at)
{
  NearPath& near = near_paths_[at.near];
  double least = near.runs.empty() ? 0.0 : 1e30;
  for (const PathRun& run : near.runs)
    for (std::size_t s = run.first; s < run.last; ++s) {
      double share = 0.0;
      const double d = distanceFromSegment(tests_.points[at.test], tests_.metric[at.test], path_.points[s], path_.points[s + 1], share);
      if (d < least) {
        least = d;
        at.segment = static_cast<std::uint32_t>(s);
        near.share = share;
      }
    }
  at.distance = least;
}

/** Measure the doubtful places; keep those that are uncovered, the farthest first. */
bool
Mover::measureDoubtful(const ProgressCallback& progress)
{
  std::vector<std::uint32_t> measured;
  measured.swap(doubtful_);
  const auto count = static_cast<std::int64_t>(measured.size());
  std::vector<std::uint8_t> still(measured.size(), 0);
#pragma omp parallel for schedule(static, 256)
  for (std::int64_t k = 0; k < count; ++k)
    still[k] = isStillCovered(watched_[measured[k]]);
  const auto known = static_cast<std::uint32_t>(near_paths_.size());
  for (std::size_t k = 0; k < measured.size(); ++k)
    if (Watched& at = watched_[measured[k]]; !still[k] && at.near == Watched::none) {
      at.near = static_cast<std::uint32_t>(near_paths_.size());
      near_paths_.emplace_back();
    }
  const auto measureOne = [&](std::int64_t k) {
    if (still[k])
      return;
    Watched& at = watched_[measured[k]];
    if (at.near >= known)
      near_paths_[at.near] = nearPath(at);
    measure(at);
  };
  if (!stoppableLoop(0, count, partOf(progress, 0.0, 1.0, "coverage"), measureOne))
    return false;
  for (const std::uint32_t w : measured)
    cover(w);
  std::sort(doubtful_.begin(), doubtful_.end(), [this](std::uint32_t a, std::uint32_t b) {
    return watched_[a].distance != watched_[b].distance ? watched_[a].distance > watched_[b].distance : a < b;
  });
  return true;
}

/** Whether the middle of another bell is near. */
bool
Mover::isTaken(std::size_t centre) const
{
  const std::size_t low = centre - std::min(centre, bell_points / 3), high = std::min(taken_.size() - 1, centre + bell_points / 3);
  return std::any_of(taken_.begin() + static_cast<std::ptrdiff_t>(low), taken_.begin() + static_cast<std::ptrdiff_t>(high) + 1,
                     [](std::uint8_t t) { return t != 0; });
}

/** Set the shifts towards the uncovered places, as bells along the path. */
void
Mover::pull()
{
  for (const std::uint32_t w : doubtful_) {
    const Watched& at = watched_[w];
    const double share = near_paths_[at.near].share;
    const std::size_t centre = at.segment + (share > 0.5 ? 1 : 0);
    if (isTaken(centre))
      continue;
    taken_[centre] = 1;
    centres_.push_back(centre);
    const Eigen::Vector3d foot = (1.0 - share) * path_.points[at.segment] + share * path_.points[at.segment + 1];
    const Eigen::Vector3d way = (tests_.points[at.test] - foot) * ((at.distance - aim) / at.distance);
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

/** Raise the limits of those that \p segment covers by its move; those above covered become doubtful. */
void
Mover::raiseLimits(std::size_t segment)
{
  const double moved = std::max(moved_[segment], moved_[segment + 1]);
  for (std::uint32_t w = std::exchange(covered_by_[segment], Watched::none); w != Watched::none;) {
    const std::uint32_t next = watched_[w].next;
    watched_[w].distance += moved;
    cover(w);
    w = next;
  }
}

/** Move the pulled points; false if there are none. */
bool
Mover::move()
{
  std::sort(pulled_.begin(), pulled_.end());
  pulled_.erase(std::unique(pulled_.begin(), pulled_.end()), pulled_.end());
  for (const std::size_t k : pulled_) {
    path_.points[k] += damping * shift_[k];
    moved_[k] = path_.metric[k].length(damping * shift_[k]);
  }
  std::size_t next = 0; // each segment once
  for (const std::size_t k : pulled_)
    for (next = std::max(next, k - std::min<std::size_t>(k, 1)); next <= k; ++next)
      raiseLimits(next);
  for (const std::size_t k : pulled_) {
    shift_[k].setZero();
    moved_[k] = 0.0;
  }
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
