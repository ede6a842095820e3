// SPDX-License-Identifier: BSD-3-Clause
// Times and memory of a playback of about a million moves. Run on a machine that does nothing else, by
//   test_visualization --gtest_also_run_disabled_tests --gtest_filter='*FullSize*'
#include "visualization/viewer/viewer_session.h"
#include <pcl_spiral/common/impl/stage_clock.h>

#include "support/judged_passes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <fstream>

namespace viewer_full_size_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

/** Seconds since the last call. */
class Watch {
public:
  double lap()
  {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - begin_).count();
    begin_ = now;
    return seconds;
  }

private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

double
megabytes(std::size_t bytes)
{
  return 1e-6 * static_cast<double>(bytes);
}

/** Seconds of a frame while the whole program is played in \p frames frames; \p drawn: with the drawing. */
double
secondsOfFrames(ViewerSession& session, int frames, bool drawn)
{
  Player& player = *session.player;
  player.seek(0.0);
  Watch watch;
  for (int i = 1; i <= frames; ++i) {
    player.seek(player.time().track.seconds() * i / frames);
    session.playback->update();
    if (drawn)
      session.window.render();
  }
  return watch.lap() / frames;
}

void
measure(std::size_t points, double scallop = 0.0075, double contact_spacing = 0.53)
{
  if (!displayFault().empty())
    GTEST_SKIP() << "no display here";
  JudgedPasses passes;
  passes.dome_radius = 600.0;
  passes.part_radius = 400.0;
  passes.half = 280.0;
  passes.scallop = scallop;
  passes.contact_spacing = contact_spacing;
  passes.points = points;
  Watch watch;
  ASSERT_NO_FATAL_FAILURE(passes.make());
  std::printf("%zu points, %zu moves; judged in %.1f s\n", points, passes.scene.part.path->size(), watch.lap());
  std::ofstream("/proc/self/clear_refs") << 5; // the peak from now on
  const MemoryUse before = memoryUse();
  ViewerSession session(std::move(passes.scene));
  session.setPlayback(std::move(passes.played));
  std::printf("window and first page      %6.2f s\n", watch.lap());
  session.press("6");
  ASSERT_EQ(session.choice.page, ViewerPage::Playback) << session.message;
  std::printf("first frame of playback    %6.2f s, %zu blocks, stock of %zu places\n", watch.lap(), session.player->time().track.blocks(),
              session.player->scene().left.places.size());
  session.player->waitForStock();
  std::printf("stock computed beside it   %6.2f s\n", watch.lap());
  std::printf("update of a frame          %6.2f ms\n", 1e3 * secondsOfFrames(session, 600, false));
  std::printf("the same and the drawing   %6.2f ms\n", 1e3 * secondsOfFrames(session, 60, true));
  session.press("m");
  std::printf("the same with the machine  %6.2f ms\n", 1e3 * secondsOfFrames(session, 60, true));
  const MemoryUse after = memoryUse();
  std::printf("memory before, after, peak %6.0f %6.0f %6.0f MB\n", megabytes(before.resident), megabytes(after.resident),
              megabytes(after.peak));
}

} // namespace

/** What the measurements below do, on a small part. */
TEST(ViewerFullSize, OfThreeThousandPoints)
{
  measure(3000, 0.5, 5.0);
}

TEST(ViewerFullSize, DISABLED_OfTwoHundredThousandPoints)
{
  measure(200000);
}

TEST(ViewerFullSize, DISABLED_OfTwoMillionPoints)
{
  measure(2000000);
}

} // namespace viewer_full_size_test
