// SPDX-License-Identifier: BSD-3-Clause
#include "cover_tests.h"

#include "common/stoppable_loop.h"
#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl_spiral {
namespace {

/** A node's distance above which the triangles about it get test points. Between nodes with less, a triangle of a quarter of a step-over
 *  may hide 0.56; on the ridges themselves, where uncovered places are, nodes are twice as near. Measured on the table of outlines, in
 *  place of a test of every triangle that could hide an uncovered place: highest scallops of 1.097 for 1.092 h in the mean, p99.9 1.0094
 *  for 1.0091 h, and the free form in 2.6 for 3.3 s of processor time, all with 4 edges a step-over. */
constexpr double suspect = 0.42;
constexpr double near_enough = 0.36; // a segment nearer than this to a test point is not followed further
constexpr std::uint32_t none = Covering::none;
constexpr std::size_t together = 128; // tests that look first where the one before found something; the same for any number of threads
constexpr std::size_t one_turn = 8;   // segments; decides only how soon a walk along the path ends

/** Parts of a side of a weak triangle, of a quarter of a step-over at most. */
std::uint32_t
partsOf(float edge)
{
  return static_cast<std::uint32_t>(std::max(1.0f, std::ceil(4.0f * edge)));
}

/** Weights of the corners of a triangle for the middle of part \p k of parts * parts. Parts lie in rows beside the side that faces the
 *  first corner; in a row those that point up and down take turns. */
std::array<double, 3>
partWeights(std::uint32_t parts, std::size_t k)
{
  std::uint32_t row = 0;
  while (k >= 2 * (parts - row) - 1)
    k -= 2 * (parts - row++) - 1;
  const double off = k % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
  const double a = row + off, b = static_cast<double>(k / 2) + off;
  return {a / parts, b / parts, 1.0 - (a + b) / parts};
}

/** Segments at which the walk along a path begins: those nearest to the places before, on two turns. */
class LastSegments {
public:
  const std::array<std::uint32_t, 2>& get() const { return last_; }
  void take(std::uint32_t segment)
  {
    if (segment == none || segment == last_[0])
      return;
    if (last_[0] == none || std::max(segment, last_[0]) - std::min(segment, last_[0]) > one_turn)
      last_[1] = last_[0];
    last_[0] = segment;
  }

private:
  std::array<std::uint32_t, 2> last_{none, none};
};

} // namespace

bool
CoverTests::run(const SegmentSet& line, const ProgressCallback& progress)
{
  chooseNodes();
  if (!measure(line, 0, suspect, partOf(progress, 0.0, 0.5, "coverage")))
    return false;
  chooseTriangles();
  if (!measure(line, nodes_.size(), covered, partOf(progress, 0.5, 1.0, "coverage")))
    return false;
  const auto count = static_cast<std::int64_t>(size());
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < count; ++i)
    if (std::uint32_t& segment = nearest_[i].segment; segment != none)
      segment = static_cast<std::uint32_t>(line.label(segment) + line.place(segment));
  return true;
}

void
CoverTests::chooseNodes()
{
  nodes_.reserve(static_cast<std::size_t>(std::count(field_.is_fine.begin(), field_.is_fine.end(), 1)));
  for (std::uint32_t v = 0; v < mesh_.size(); ++v)
    if (field_.is_fine[v])
      nodes_.push_back(v);
  nearest_.resize(nodes_.size());
}

/** Triangles that may hide an uncovered place though their corners are covered. */
void
CoverTests::chooseTriangles()
{
  std::vector<std::uint32_t> index(mesh_.size(), none);
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    index[nodes_[i]] = static_cast<std::uint32_t>(i);
  links_begin_ = nodes_.size();
  const auto test = [&](std::size_t triangle, std::uint32_t parts, const std::array<std::uint32_t, 3>& seeds) {
    tested_.push_back({static_cast<std::uint32_t>(triangle), parts, links_begin_, seeds});
    links_begin_ += parts * parts;
  };
  for (std::size_t t = 0; t < mesh_.triangles.triangleCount(); ++t) {
    const auto& c = mesh_.triangles.triangle(t);
    if (index[c[0]] == none || index[c[1]] == none || index[c[2]] == none) {
      if (field_.is_weak[t])
        test(t, partsOf(std::max({field_.edge[c[0]], field_.edge[c[1]], field_.edge[c[2]]})), {none, none, none});
    }
    else {
      const Covering &a = nearest_[index[c[0]]], &b = nearest_[index[c[1]]], &d = nearest_[index[c[2]]];
      if (std::max({a.distance, b.distance, d.distance}) > suspect)
        test(t, 2, {a.segment, b.segment, d.segment});
    }
  }
  nearest_.resize(size());
}

/** The middle of a part of \p tested; \p seed: a segment near the nearest corner. */
CoverPlace
CoverTests::partPlace(const TestedTriangle& tested, std::size_t part, std::uint32_t& seed) const
{
  const auto& c = mesh_.triangles.triangle(tested.triangle);
  const std::array<double, 3> w = partWeights(tested.parts, part);
  CoverPlace place{Eigen::Vector3d::Zero(), {}};
  for (int i = 0; i < 3; ++i) {
    place.point += w[i] * mesh_.positions[c[i]];
    place.metric += mesh_.metric[c[i]].times(w[i]);
  }
  seed = tested.seeds[std::max_element(w.begin(), w.end()) - w.begin()];
  return place;
}

/** The place of \p test, which is not before that of the first test of \p tested: the triangle from which on it is looked for, and in which
 *  it was found. */
CoverPlace
CoverTests::placeAt(std::size_t test, std::size_t& tested, std::uint32_t& seed) const
{
  seed = none;
  if (test < nodes_.size())
    return nodePlace(nodes_[test]);
  if (test >= links_begin_)
    return {path_.links[test - links_begin_], path_.link_metric[test - links_begin_]};
  while (tested + 1 < tested_.size() && tested_[tested + 1].first <= test)
    ++tested;
  return partPlace(tested_[tested], test - tested_[tested].first, seed);
}

/** The last triangle whose tests do not begin after \p test; 0 if none does. */
std::size_t
CoverTests::triangleOf(std::size_t test) const
{
  const auto next = std::upper_bound(tested_.begin(), tested_.end(), test, [](std::size_t i, const auto& t) { return i < t.first; });
  return next == tested_.begin() ? 0 : static_cast<std::size_t>(next - tested_.begin()) - 1;
}

CoverPlace
CoverTests::place(std::size_t test) const
{
  std::size_t tested = test < nodes_.size() ? 0 : triangleOf(test);
  std::uint32_t seed = none;
  return placeAt(test, tested, seed);
}

/** Measure from index \p first on: the distances that are more than \p exact, and upper limits of the others. Neighbours in the order of
 *  the tests are near each other: a walk along the path from where they are nearest is often enough. */
bool
CoverTests::measure(const SegmentSet& line, std::size_t first, double exact, const std::function<bool(double)>& progress)
{
  const auto blocks = static_cast<std::int64_t>((nearest_.size() - first + together - 1) / together);
  const auto measureBlock = [&](std::int64_t block) {
    const std::size_t begin = first + static_cast<std::size_t>(block) * together;
    std::size_t tested = triangleOf(begin);
    LastSegments last;
    for (std::size_t i = begin; i < std::min(nearest_.size(), begin + together); ++i) {
      std::uint32_t seed = none;
      const CoverPlace at = placeAt(i, tested, seed);
      NearestSegment best;
      best.distance = covering_within;
      for (const std::uint32_t from : {seed, last.get()[0], last.get()[1]}) {
        if (from == none || best.distance < near_enough)
          continue;
        const NearestSegment found = line.along(at.point, at.metric, from, best.distance);
        if (found.segment != NearestSegment::none)
          best = found;
      }
      if (best.distance > exact) {
        const NearestSegment found = line.nearest(at.point, at.metric, best.distance);
        if (found.segment != NearestSegment::none)
          best = found;
      }
      nearest_[i] = {best.distance, static_cast<std::uint32_t>(best.segment), static_cast<float>(best.share)};
      last.take(nearest_[i].segment);
    }
  };
  return stoppableLoop(0, blocks, progress, measureBlock, together);
}

SegmentSet
passLines(const LinkedPath& path)
{
  SegmentSet line;
  for (const PassRange& pass : passRanges(path.passes, path.points.size()))
    line.add(Polyline(path.points.begin() + static_cast<std::ptrdiff_t>(pass.begin),
                      path.points.begin() + static_cast<std::ptrdiff_t>(pass.end)),
             false, pass.begin);
  line.build();
  return line;
}

} // namespace pcl_spiral
