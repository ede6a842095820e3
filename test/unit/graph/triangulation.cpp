// SPDX-License-Identifier: BSD-3-Clause
// Neighbours of triangles joined in parallel, against those joined one after the other.
#include <pcl_spiral/graph/impl/triangulation.h>

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>

namespace triangulation_test {

namespace {

using namespace pcl_spiral;
using Triangle = Triangulation::Triangle;

/** A lattice of triangles over count x count points, in random order; with \p odd > 0, so many more at random places: edges with three
 *  triangles, or with two that face the same way. */
std::vector<Triangle>
lattice(std::uint32_t count, std::size_t odd, unsigned seed)
{
  std::vector<Triangle> triangles;
  for (std::uint32_t y = 0; y + 1 < count; ++y)
    for (std::uint32_t x = 0; x + 1 < count; ++x) {
      const std::uint32_t v = y * count + x;
      triangles.push_back({v, v + 1, v + count});
      triangles.push_back({v + 1, v + count + 1, v + count});
    }
  std::mt19937 random(seed);
  for (std::size_t i = 0; i < odd; ++i) {
    Triangle t = triangles[random() % triangles.size()];
    t[random() % 3] = static_cast<std::uint32_t>(random() % (count * count));
    if (random() % 2)
      std::swap(t[0], t[1]);
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      triangles.push_back(t);
  }
  std::shuffle(triangles.begin(), triangles.end(), random);
  return triangles;
}

TEST(Triangulation, JoinsInParallelAsOneByOne)
{
  const int given = omp_get_max_threads();
  for (const std::size_t odd : {0, 30, 400})
    for (unsigned seed = 1; seed < 6; ++seed) {
      const std::vector<Triangle> triangles = lattice(20, odd, seed);
      Triangulation one_by_one(400, {});
      for (const Triangle& t : triangles) // one at a time: a half-edge is joined to the first that faces it
        one_by_one.append({t});
      Triangulation appended(400, {});
      appended.append(triangles);
      for (const int threads : {1, 2, 5}) {
        omp_set_num_threads(threads);
        const Triangulation whole(400, triangles);
        ASSERT_EQ(whole.halfEdgeCount(), appended.halfEdgeCount());
        std::size_t free = 0;
        for (std::uint32_t h = 0; h < whole.halfEdgeCount(); ++h) {
          ASSERT_EQ(whole.opposite(h), appended.opposite(h)) << h;
          free += whole.opposite(h) == Triangulation::none;
          if (whole.opposite(h) == Triangulation::none)
            continue;
          ASSERT_EQ(whole.opposite(whole.opposite(h)), h);
          ASSERT_EQ(whole.origin(whole.opposite(h)), whole.target(h));
          ASSERT_EQ(whole.target(whole.opposite(h)), whole.origin(h));
          if (odd == 0)
            ASSERT_EQ(whole.opposite(h), one_by_one.opposite(h));
        }
        if (odd == 0)
          EXPECT_EQ(free, 4u * 19u);
        for (std::size_t v = 0; v < 400; ++v) {
          ASSERT_EQ(whole.outgoingBegin(v + 1), appended.outgoingBegin(v + 1));
          std::set<std::uint32_t> leaving;
          for (std::size_t k = whole.outgoingBegin(v); k < whole.outgoingBegin(v + 1); ++k) {
            ASSERT_EQ(whole.outgoing(k), appended.outgoing(k));
            ASSERT_EQ(whole.origin(whole.outgoing(k)), v);
            leaving.insert(whole.outgoing(k));
          }
          ASSERT_EQ(leaving.size(), whole.outgoingBegin(v + 1) - whole.outgoingBegin(v));
        }
      }
    }
  omp_set_num_threads(given);
}

} // namespace

} // namespace triangulation_test
