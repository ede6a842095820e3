// SPDX-License-Identifier: BSD-3-Clause
#include "cover_tests.h"

#include "common/stoppable_loop.h"
#include <pcl_spiral/core/impl/pass_ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_spiral {
namespace {

constexpr double suspect = 0.42;       // a node's distance above which the triangles about it get test points
constexpr double least_watched = 0.36; // test points nearer than this to the path stay covered
constexpr double deep_place = 0.55;    // but not about a place this far from the path, which moves the path by more
constexpr double watch_reach = 1.6;    // test points this near to an uncovered place are watched
constexpr double search_within = 1.5;  // step-overs
constexpr std::uint32_t none = 0xffffffffu;
constexpr std::size_t none_near = NearestSegment::none;

/** Cut a triangle into \p parts * \p parts and add the middle of each. \p segments: near its corners. */
void
addTriangle(const StepOverMesh& mesh, std::size_t triangle, int parts, const std::array<std::size_t, 3>& segments, CoverTests& tests)
{
  const auto& c = mesh.triangles.triangle(triangle);
  const auto add = [&](double a, double b) {
    const double w[3] = {a / parts, b / parts, 1.0 - (a + b) / parts};
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    StepOverMetric m;
    for (int i = 0; i < 3; ++i) {
      p += w[i] * mesh.positions[c[i]];
      m += mesh.metric[c[i]].times(w[i]);
    }
    tests.add(p, m, segments[std::max_element(w, w + 3) - w]);
  };
  for (int i = 0; i < parts; ++i)
    for (int j = 0; i + j < parts; ++j) {
      add(i + 1.0 / 3.0, j + 1.0 / 3.0);
      if (i + j + 1 < parts)
        add(i + 2.0 / 3.0, j + 2.0 / 3.0);
    }
}

} // namespace

void
CoverTests::add(const Eigen::Vector3d& p, const StepOverMetric& m, std::size_t seed)
{
  points.push_back(p);
  metric.push_back(m);
  seeds.push_back(seed);
}

/** Neighbours in the order of the tests are near each other: a walk along the path from where they are nearest is often enough. */
bool
CoverTests::measure(const SegmentSet& lines, std::size_t first, double exact, const std::function<bool(double)>& progress)
{
  constexpr std::size_t together = 128; // tests that begin their walks where the last one ended; the same for any number of threads
  nearest.resize(points.size());
  const auto blocks = static_cast<std::int64_t>((points.size() - first + together - 1) / together);
  const auto measureBlock = [&](std::int64_t block) {
    const std::size_t begin = first + static_cast<std::size_t>(block) * together;
    std::array<std::size_t, 2> last{NearestSegment::none, NearestSegment::none}; // of two turns
    for (std::size_t i = begin; i < std::min(points.size(), begin + together); ++i) {
      NearestSegment best;
      best.distance = search_within;
      for (const std::size_t from : {seeds[i], last[0], last[1]}) {
        if (from == NearestSegment::none || best.distance < least_watched)
          continue;
        const NearestSegment found = lines.along(points[i], metric[i], from, best.distance);
        if (found.segment != NearestSegment::none)
          best = found;
      }
      if (best.distance > exact) {
        const NearestSegment found = lines.nearest(points[i], metric[i], best.distance);
        if (found.segment != NearestSegment::none)
          best = found;
      }
      nearest[i] = best;
      if (best.segment != NearestSegment::none && best.segment != last[0]) {
        constexpr std::size_t one_turn = 8; // segments; decides only how soon a walk ends
        if (last[0] == NearestSegment::none || std::max(best.segment, last[0]) - std::min(best.segment, last[0]) > one_turn)
          last[1] = last[0];
        last[0] = best.segment;
      }
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

bool
coverTests(const StepOverDistance& field, const LinkedPath& path, const SegmentSet& line, const ProgressCallback& progress,
           CoverTests& tests)
{
  const StepOverMesh& mesh = field.mesh;
  tests = CoverTests();
  std::vector<std::uint32_t> index(mesh.size(), none);
  for (std::uint32_t v = 0; v < mesh.size(); ++v)
    if (field.is_fine[v]) {
      index[v] = static_cast<std::uint32_t>(tests.size());
      tests.add(mesh.positions[v], mesh.metric[v]);
    }
  if (!tests.measure(line, 0, suspect, partOf(progress, 0.0, 0.5, "coverage")))
    return false;
  const std::size_t nodes = tests.size();
  const int coarse_parts = std::max(1, static_cast<int>(std::ceil(4.0 * field.usual_edge)));
  for (std::size_t t = 0; t < mesh.triangles.triangleCount(); ++t) {
    const auto& c = mesh.triangles.triangle(t);
    if (index[c[0]] == none || index[c[1]] == none || index[c[2]] == none) {
      if (field.is_weak[t])
        addTriangle(mesh, t, coarse_parts, {none_near, none_near, none_near}, tests);
    }
    else {
      const NearestSegment &a = tests.nearest[index[c[0]]], &b = tests.nearest[index[c[1]]], &d = tests.nearest[index[c[2]]];
      if (std::max({a.distance, b.distance, d.distance}) > suspect)
        addTriangle(mesh, t, 2, {a.segment, b.segment, d.segment}, tests);
    }
  }
  for (std::size_t i = 0; i < path.links.size(); ++i)
    tests.add(path.links[i], path.link_metric[i]);
  const bool whole = tests.measure(line, nodes, covered, partOf(progress, 0.5, 1.0, "coverage"));
  std::vector<std::size_t>().swap(tests.seeds);
  return whole;
}

bool
testsToWatch(const CoverTests& tests, const std::vector<std::size_t>& places, const SegmentSet& line,
             const std::vector<std::uint8_t>& moves, const ProgressCallback& progress, std::vector<std::size_t>& watched)
{
  SegmentSet all, deep;
  for (const std::size_t i : places) {
    all.add({tests.points[i]}, false);
    if (tests.nearest[i].distance > deep_place)
      deep.add({tests.points[i]}, false);
  }
  all.build();
  deep.build();
  const auto isNear = [&](const SegmentSet& set, std::size_t i) {
    return set.nearest(tests.points[i], tests.metric[i], watch_reach, NearestSegment::none, watch_reach).segment != NearestSegment::none;
  };
  const auto mayMove = [&](const NearestSegment& near) {
    const std::size_t s = line.label(near.segment) + line.place(near.segment);
    return moves[s] != 0 || moves[s + 1] != 0;
  };
  std::vector<std::uint8_t> chosen(tests.size(), 0);
  const bool whole = stoppableLoop(0, static_cast<std::int64_t>(tests.size()), partOf(progress, 0.0, 1.0, "coverage"), [&](std::int64_t i) {
    const NearestSegment& near = tests.nearest[i];
    chosen[i] = near.distance > covered ||
                (mayMove(near) && ((near.distance >= least_watched && isNear(all, i)) || (!deep.empty() && isNear(deep, i))));
  });
  watched.clear();
  for (std::size_t i = 0; i < tests.size(); ++i)
    if (chosen[i])
      watched.push_back(i);
  return whole;
}

} // namespace pcl_spiral
