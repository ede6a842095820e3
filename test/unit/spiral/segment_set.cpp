// SPDX-License-Identifier: BSD-3-Clause
// Walks along runs of segments: limits of the distance that are never below it, ends of runs, single points.
#include "spiral/lines/segment_set.h"

#include "support/random_vectors.h"
#include "support/sampling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace segment_set_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;
using Eigen::Vector3d;

namespace {

/** Runs of 40 points along y, 1 apart, a single point, and a run with a repeated point. */
SegmentSet
someRuns()
{
  SegmentSet lines;
  for (int turn = 0; turn < 3; ++turn) {
    Polyline run;
    for (int i = 0; i < 40; ++i)
      run.emplace_back(turn + 0.2 * std::sin(0.3 * i), 0.5 * i, 0.0);
    lines.add(run, false, turn);
  }
  lines.add({Vector3d(5.0, 5.0, 0.0)}, false, 3);
  lines.add({Vector3d(6.0, 0.0, 0.0), Vector3d(6.0, 1.0, 0.0), Vector3d(6.0, 1.0, 0.0), Vector3d(6.0, 2.0, 0.0)}, false, 4);
  lines.build();
  return lines;
}

} // namespace

TEST(SegmentSet, AWalkNeverEndsNearerThanTheNearestSegment)
{
  const SegmentSet lines = someRuns();
  const StepOverMetric metric(Eigen::Matrix3d::Identity());
  constexpr std::size_t segments = 3 * 40 + 2 + 4; // the last of each run is none
  Random random(3);
  std::size_t walks = 0, beside = 0;
  for (int i = 0; i < 300; ++i) {
    const Vector3d p(random.uniform(-1.0, 7.0), random.uniform(-1.0, 21.0), random.uniform(-0.3, 0.3));
    const NearestSegment nearest = lines.nearest(p, metric, 1.5);
    for (std::size_t s = 0; s < segments; ++s) {
      const NearestSegment found = lines.along(p, metric, s, 1.5);
      ASSERT_GE(found.distance, nearest.distance);
      if (found.segment == NearestSegment::none) {
        ASSERT_EQ(found.distance, 1.5);
        continue;
      }
      double share = 0.0;
      ASSERT_EQ(found.distance, distanceFromSegment(p, metric, lines.point(found.segment), lines.point(found.segment + 1), share));
      ASSERT_EQ(found.share, share);
      ++walks;
      if (s + 1 >= nearest.segment && s <= nearest.segment + 1 && lines.label(s) == lines.label(nearest.segment)) {
        ++beside;
        ASSERT_EQ(found.distance, nearest.distance) << "a walk that begins beside the nearest segment finds it";
      }
    }
  }
  EXPECT_GT(walks, 1000U);
  EXPECT_GT(beside, 300U);
}

/** The segments of runs, closed ones and single points among them, and where each is: label and place. */
struct KnownSegment {
  Vector3d a, b;
  std::pair<std::size_t, std::size_t> where;
};

TEST(SegmentSet, NamesExactlyTheSegmentsWithinTheDistance)
{
  Random random(5);
  std::size_t within_all = 0;
  for (int trial = 0; trial < 40; ++trial) {
    SegmentSet lines;
    std::vector<KnownSegment> known;
    for (std::size_t r = 0; r < static_cast<std::size_t>(1 + trial % 7); ++r) {
      const std::size_t count = (trial + r) % 4 == 0 ? 1 : 30 + 4 * r;
      const bool closed = count > 2 && r % 2 == 0;
      Polyline run{10.0 * randomVector(random, 1.0)};
      while (run.size() < count)
        run.emplace_back(run.back() + randomVector(random, run.size() % 17 == 0 ? 6.0 : 0.5)); // a few are long, and lie in pieces
      lines.add(run, closed, 1000 * r);
      for (std::size_t i = 0; i + 1 < count; ++i)
        known.push_back({run[i], run[i + 1], {1000 * r, i}});
      if (closed || count == 1)
        known.push_back({run.back(), run.front(), {1000 * r, count - 1}});
    }
    lines.build();
    for (int k = 0; k < 60; ++k) {
      const Vector3d p = 10.0 * randomVector(random, 1.0), across = randomUnit(random);
      const StepOverMetric metric(Eigen::Matrix3d(Eigen::Matrix3d::Identity() + 8.0 * across * across.transpose()));
      const double within = random.uniform(0.1, 2.5);
      std::set<std::pair<std::size_t, std::size_t>> named, expected;
      lines.forSegmentsNear(p, metric, within, [&](std::size_t s) { named.emplace(lines.label(s), lines.place(s)); });
      double share = 0.0;
      for (const KnownSegment& segment : known)
        if (distanceFromSegment(p, metric, segment.a, segment.b, share) <= within)
          expected.insert(segment.where);
      ASSERT_EQ(named, expected);
      within_all += expected.size();
    }
  }
  EXPECT_GT(within_all, 200U);
}

} // namespace segment_set_test
