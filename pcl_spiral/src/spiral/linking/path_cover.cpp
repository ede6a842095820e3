// SPDX-License-Identifier: BSD-3-Clause
#include "path_cover.h"

#include "common/stoppable_loop.h"
#include "cover_tests.h"
#include "spiral/lines/segment_set.h"
#include "spiral/path/path_densify.h"

#include <pcl_spiral/core/impl/angles.h>
#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double aim = 0.49;         // distance to which an uncovered place is brought
constexpr double moved_reach = 2.63; // the path this near to it may move: the turn beyond the farthest, and a bell along it
constexpr double bell = 0.8;         // half the length of path that one place moves
constexpr double cover_grain = 0.05; // of the path where it moves
constexpr auto bell_points = static_cast<std::size_t>(bell / cover_grain);
constexpr double damping = 0.7;
constexpr int most_rounds = 24;

/** How much of the shift in its middle a bell has so many points beside it. */
const std::array<double, bell_points + 1> bell_shape = [] {
  std::array<double, bell_points + 1> shape{};
  for (std::size_t i = 0; i <= bell_points; ++i)
    shape[i] = 0.5 * (1.0 + std::cos(pi * static_cast<double>(i) / (static_cast<double>(bell_points) + 1.0)));
  return shape;
}();

/** Points first to last of a pass. */
struct PathRun {
  std::size_t first = 0, last = 0;
};

/** The path near a test point whose limit was above covered at some time. */
struct NearPath {
  std::vector<PathRun> runs;
  double share = 0.0; ///< along the nearest segment
};

/** How a point of the path moves. */
struct Shift {
  std::size_t point = 0;
  Eigen::Vector3d by = Eigen::Vector3d::Zero();
};

/** A test point that a moving path may uncover: an upper limit of its distance, and the segment of which it was taken. */
struct Watched {
  double distance = 0.0;     ///< includes how far the segment has moved since it was measured
  std::uint32_t segment = 0; ///< from its point of the path to the next
  std::uint32_t test = 0;    ///< the test point
  std::uint32_t near = none; ///< index of its NearPath, which is looked for when the limit is above covered

  static constexpr std::uint32_t none = 0xffffffffu;
};

class Mover {
public:
  Mover(const StepOverDistance& field, LinkedPath& path) : path_(path), tests_(field, path) {}

  bool run(double held, const ProgressCallback& progress, CoverReport& figures)
  {
    if (!watch(held, partOf(progress, 0.0, 0.5), figures))
      return false;
    for (; !watched_.empty() && figures.rounds < most_rounds; ++figures.rounds) {
      if (!measureOpen(partOf(progress, 0.5 + 0.5 * figures.rounds / most_rounds, 0.5 + 0.5 * (figures.rounds + 1) / most_rounds)))
        return false;
      figures.left = open_.size();
      figures.farthest = open_.empty() ? covered : watched_[open_.front()].distance;
      if (open_.empty())
        break;
      figures.farthest_place = tests_.place(watched_[open_.front()].test).point;
      pull();
      if (!move())
        break;
    }
    return true;
  }

private:
  bool watch(double held, const ProgressCallback& progress, CoverReport& figures);
  void findNear(const std::vector<std::size_t>& places, std::vector<std::uint8_t>& near) const;
  NearPath nearPath(const Watched& at) const;
  double distanceFrom(std::size_t segment, const CoverPlace& place, double& share) const;
  bool isStillCovered(Watched& at) const;
  void measure(Watched& at);
  bool measureOpen(const ProgressCallback& progress);
  void pull();
  bool isTaken(std::size_t centre) const;
  void watchTests(const std::vector<std::uint8_t>& near);
  void raiseLimits();
  bool move();

  LinkedPath& path_;
  CoverTests tests_;
  std::vector<Watched> watched_;
  std::vector<std::uint32_t> open_; ///< watched whose limit is above covered
  std::vector<NearPath> near_paths_;
  SegmentSet line_;                  ///< the path as it was at first
  std::vector<std::size_t> dense_;   ///< one a point of it: where it is now, and the end
  std::vector<std::uint8_t> moves_;  ///< one a point of the path: 1 within reach of an uncovered place, and not held
  std::vector<std::uint8_t> taken_;  ///< the same: middles of this round's bells
  std::vector<double> moved_;        ///< one a point of it, and one more: how far this round moved it, step-overs
  std::vector<Shift> shifts_;        ///< of this round, in the order of its bells; some points come twice
  std::vector<std::size_t> centres_; ///< points taken
};

/** Find the uncovered places, the parts of the path that may move towards them, and the test points these may uncover. */
bool
Mover::watch(double held, const ProgressCallback& progress, CoverReport& figures)
{
  line_ = passLines(path_);
  if (!tests_.run(line_, partOf(progress, 0.0, 0.4)))
    return false;
  figures.farthest_before = covered;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < tests_.size(); ++i)
    if (tests_.nearest(i).distance > covered) {
      places.push_back(i);
      figures.farthest_before = std::max(figures.farthest_before, tests_.nearest(i).distance);
    }
  figures.farthest = figures.farthest_before;
  figures.places = places.size();
  if (places.empty())
    return true;
  std::vector<std::uint8_t> near(path_.points.size() + 1, 0); // the segment of a single point has a second end
  findNear(places, near);
  densify(near, held, cover_grain, path_, moves_, dense_);
  taken_.assign(path_.points.size(), 0);
  moved_.assign(path_.points.size() + 1, 0.0);
  watchTests(near);
  return !progress || progress(1.0, "coverage");
}

/** Watch the tests that are uncovered, or covered by a segment that may move. \p near: the points of the path that may, as it
 *  was. */
void
Mover::watchTests(const std::vector<std::uint8_t>& near)
{
  for (std::size_t i = 0; i < tests_.size(); ++i) {
    const Covering& by = tests_.nearest(i);
    Watched at;
    at.distance = by.distance;
    at.test = static_cast<std::uint32_t>(i);
    if (const std::uint32_t p = by.segment; p != Covering::none) {
      const std::size_t parts = dense_[p + 1] - dense_[p];
      if (!(at.distance > covered) && !near[p] && !near[p + 1])
        continue;
      const auto part = std::min(parts - 1, static_cast<std::size_t>(by.share * static_cast<double>(parts)));
      at.segment = static_cast<std::uint32_t>(dense_[p] + part);
    }
    if (at.distance > covered)
      open_.push_back(static_cast<std::uint32_t>(watched_.size()));
    watched_.push_back(at);
  }
  tests_.forgetNearest();
}

NearPath
Mover::nearPath(const Watched& at) const
{
  std::vector<std::size_t> segments; // of the path as it was
  const CoverPlace place = tests_.place(at.test);
  line_.forSegmentsNear(place.point, place.metric, covering_within,
                        [&](std::size_t s) { segments.push_back(line_.label(s) + line_.place(s)); });
  std::sort(segments.begin(), segments.end());
  NearPath near;
  for (const std::size_t s : segments) {
    const std::size_t first = dense_[s], last = dense_[s + 1];
    if (near.runs.empty() || first > near.runs.back().last || beginsPass(path_.passes, first))
      near.runs.push_back({first, last});
    near.runs.back().last = std::max(near.runs.back().last, last);
  }
  return near;
}

/** Mark the points of the path within reach of \p places. */
void
Mover::findNear(const std::vector<std::size_t>& places, std::vector<std::uint8_t>& near) const
{
  const auto count = static_cast<std::int64_t>(places.size());
#pragma omp parallel
  {
    std::vector<std::size_t> found;
#pragma omp for schedule(dynamic, 256) nowait
    for (std::int64_t i = 0; i < count; ++i) {
      const CoverPlace place = tests_.place(places[i]);
      line_.forSegmentsNear(place.point, place.metric, moved_reach,
                            [&](std::size_t s) { found.push_back(line_.label(s) + line_.place(s)); });
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
#pragma omp critical
    for (const std::size_t s : found)
      near[s] = near[s + 1] = 1;
  }
}

/** Distance of a place from \p segment of the path, or from its point if a pass ends there; \p share: where along it. */
double
Mover::distanceFrom(std::size_t segment, const CoverPlace& place, double& share) const
{
  const bool ends = segment + 1 == path_.points.size() || beginsPass(path_.passes, segment + 1);
  return distanceFromSegment(place.point, place.metric, path_.points[segment], path_.points[ends ? segment : segment + 1], share);
}

/** Whether a place is covered by the segment of which its limit was taken, which has moved since; the limit is then taken of it again. */
bool
Mover::isStillCovered(Watched& at) const
{
  double share = 0.0;
  const double d = distanceFrom(at.segment, tests_.place(at.test), share);
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
  const CoverPlace place = tests_.place(at.test);
  if (near.runs.empty())
    return; // it stays as far as it was measured
  double least = 1e30;
  for (const PathRun& run : near.runs)
    for (std::size_t s = run.first; s < run.last; ++s) {
      double share = 0.0;
      const double d = distanceFrom(s, place, share);
      if (d < least) {
        least = d;
        at.segment = static_cast<std::uint32_t>(s);
        near.share = share;
      }
    }
  at.distance = least;
}

/** Measure the open places; keep those that are uncovered, the farthest first. */
bool
Mover::measureOpen(const ProgressCallback& progress)
{
  const std::vector<std::uint32_t> measured = std::move(open_);
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
  open_.clear();
  std::copy_if(measured.begin(), measured.end(), std::back_inserter(open_),
               [this](std::uint32_t w) { return watched_[w].distance > covered; });
  std::sort(open_.begin(), open_.end(), [this](std::uint32_t a, std::uint32_t b) {
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
  for (const std::uint32_t w : open_) {
    const Watched& at = watched_[w];
    if (near_paths_[at.near].runs.empty())
      continue; // nothing is near enough to be moved there
    const double share = near_paths_[at.near].share;
    const std::size_t centre = at.segment + (share > 0.5 ? 1 : 0);
    if (isTaken(centre))
      continue;
    taken_[centre] = 1;
    centres_.push_back(centre);
    const std::size_t next = std::min<std::size_t>(at.segment + 1, path_.points.size() - 1);
    const Eigen::Vector3d foot = (1.0 - share) * path_.points[at.segment] + share * path_.points[next];
    const Eigen::Vector3d way = (tests_.place(at.test).point - foot) * ((at.distance - aim) / at.distance);
    const PassRange pass = passRanges(path_.passes, path_.points.size())[passOf(path_.passes, centre)];
    const std::size_t low = std::max(pass.begin, centre - std::min(centre, bell_points)),
                      high = std::min(pass.end - 1, centre + bell_points);
    for (std::size_t k = low; k <= high; ++k)
      if (moves_[k])
        shifts_.push_back({k, way * bell_shape[k > centre ? k - centre : centre - k]});
  }
}

/** Raise the limits of those that moved segments cover. All whose limit is then above covered become open. */
void
Mover::raiseLimits()
{
  constexpr std::size_t block_size = 8192;
  const auto blocks = static_cast<std::int64_t>((watched_.size() + block_size - 1) / block_size);
  std::vector<std::vector<std::uint32_t>> found(blocks);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::int64_t block = 0; block < blocks; ++block)
    for (std::size_t w = block * block_size; w < std::min(watched_.size(), (block + 1) * block_size); ++w) {
      Watched& at = watched_[w];
      at.distance += std::max(moved_[at.segment], moved_[at.segment + 1]);
      if (at.distance > covered)
        found[block].push_back(static_cast<std::uint32_t>(w));
    }
  open_.clear();
  for (const std::vector<std::uint32_t>& some : found)
    open_.insert(open_.end(), some.begin(), some.end());
}

/** Move the pulled points; false if there are none. */
bool
Mover::move()
{
  std::stable_sort(shifts_.begin(), shifts_.end(), [](const Shift& a, const Shift& b) { return a.point < b.point; });
  std::vector<std::size_t> pulled;
  for (std::size_t i = 0; i < shifts_.size();) {
    const std::size_t k = shifts_[i].point;
    Eigen::Vector3d by = Eigen::Vector3d::Zero();
    for (; i < shifts_.size() && shifts_[i].point == k; ++i)
      by += shifts_[i].by;
    path_.points[k] += damping * by;
    moved_[k] = path_.metric[k].length(damping * by);
    pulled.push_back(k);
  }
  raiseLimits();
  for (const std::size_t k : pulled)
    moved_[k] = 0.0;
  for (const std::size_t c : centres_)
    taken_[c] = 0;
  shifts_.clear();
  centres_.clear();
  return !pulled.empty();
}

} // namespace

bool
coverPath(const StepOverDistance& field, double held, const ProgressCallback& progress, LinkedPath& path, CoverReport& figures)
{
  figures = CoverReport();
  return Mover(field, path).run(held, progress, figures);
}

} // namespace pcl_spiral
