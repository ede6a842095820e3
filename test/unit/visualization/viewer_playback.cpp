// SPDX-License-Identifier: BSD-3-Clause
// The playback of a viewer: keys, bar, tool and stock on the screen.
#include "visualization/viewer/viewer_session.h"

#include "support/judged_passes.h"
#include "support/window_frame.h"

#include <gtest/gtest.h>

#include <vtkCommand.h>

#include <cmath>

namespace viewer_playback_test {

using namespace pcl_spiral;
using namespace pcl_spiral::test;

namespace {

/** Passes of a ball over a dome, judged, in a window. */
class ViewerPlayback : public testing::Test {
protected:
  void SetUp() override
  {
    if (!displayFault().empty())
      GTEST_SKIP() << "no display here";
    JudgedPasses passes;
    ASSERT_NO_FATAL_FAILURE(passes.make());
    session = std::make_unique<ViewerSession>(std::move(passes.scene));
    session->window.window()->SetSize(960, 720);
    session->setPlayback(std::move(passes.played));
  }
  std::size_t magenta() const
  {
    const Frame frame(session->window.window());
    return frame.count([](const Pixel& p) { return p[0] > 120 && p[2] > 110 && p[1] < 70; }, 0, 550, 130, frame.height() - 100);
  }

  std::unique_ptr<ViewerSession> session;
};

} // namespace

TEST_F(ViewerPlayback, KeysMoveTheToolThroughTheProgram)
{
  session->press("space");
  ASSERT_EQ(session->choice.page, ViewerPage::Playback) << session->message;
  Player& player = *session->player;
  EXPECT_TRUE(player.playing());
  session->play(0.5);
  EXPECT_NEAR(player.seconds(), 0.5, 1e-9);
  session->press("plus");
  session->play(0.5);
  EXPECT_NEAR(player.seconds(), 1.5, 1e-9) << "twice as fast";
  for (int i = 0; i < 20; ++i)
    session->press("plus");
  EXPECT_EQ(player.speed(), 1000.0);
  for (int i = 0; i < 20; ++i)
    session->press("minus");
  EXPECT_EQ(player.speed(), 0.1);
  session->press("space");
  EXPECT_FALSE(player.playing());
  const std::size_t block = player.frame().block;
  session->press("Right");
  EXPECT_EQ(player.frame().block, block + 1);
  session->press("Left");
  EXPECT_EQ(player.frame().block, block);
  session->press("w");
  EXPECT_EQ(session->message, "look here");
  EXPECT_EQ(player.seconds(), player.time().reached[100]);
  session->press("e");
  const MotionFrame slow = player.frame();
  EXPECT_LT(slow.feed, 0.9 * slow.asked) << session->message;
  session->press("g");
  EXPECT_EQ(player.seconds(), player.time().reached[session->scene.removal_figures.gouge.index]);
  session->press("x");
  EXPECT_EQ(session->message.find("X at its smallest: "), 0U) << session->message;
  EXPECT_NE(session->message.find("it has no limit"), std::string::npos) << session->message;
  session->press("1");
  EXPECT_EQ(session->choice.page, ViewerPage::Boundaries);
}

TEST_F(ViewerPlayback, TheMachineIsShownAndThePartTurnsWithItsTable)
{
  session->press("6");
  session->player->seekShare(0.4);
  session->press("z");
  const std::size_t alone = magenta();
  session->press("m");
  EXPECT_TRUE(session->playback->showsMachine());
  const std::size_t with_machine = magenta();
  EXPECT_LT(with_machine, 0.5 * alone) << "seen from farther away, and turned with the table";
  EXPECT_NE(session->playback->motion().find("axes X Y Z"), std::string::npos) << session->playback->motion();
  session->press("m");
  EXPECT_NEAR(static_cast<double>(magenta()), static_cast<double>(alone), 0.02 * alone) << "as before";
}

TEST_F(ViewerPlayback, ThePageGoesWithItsPlayback)
{
  session->press("6");
  ASSERT_EQ(session->choice.page, ViewerPage::Playback) << session->message;
  PlaybackScene other = session->player->scene();
  session->setPlayback(other);
  EXPECT_EQ(session->choice.page, ViewerPage::Stock);
  session->show();
  session->press("6");
  EXPECT_EQ(session->choice.page, ViewerPage::Playback) << session->message;
}

TEST_F(ViewerPlayback, StockFallsAndTheBarLeadsThroughTheTime)
{
  session->press("6");
  session->player->waitForStock();
  session->show();
  const std::size_t whole = magenta();
  EXPECT_GT(whole, 10000U) << "nothing is cut";
  const auto dragTo = [&](double share) {
    int x = 30;
    while (session->playback->shareAt(x) < share)
      ++x;
    session->interactor->SetEventInformation(x, 108);
    session->interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
    session->interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  };
  dragTo(0.5);
  EXPECT_NEAR(session->player->share(), 0.5, 0.01);
  const std::size_t half = magenta();
  EXPECT_LT(half, 0.8 * whole);
  EXPECT_GT(half, 0.1 * whole);
  session->press("b");
  dragTo(0.25);
  EXPECT_NEAR(session->player->frame().length, 0.25 * session->player->time().track.length(),
              0.01 * session->player->time().track.length());
  dragTo(1.0);
  EXPECT_LT(magenta(), 0.02 * whole);
  dragTo(0.0);
  EXPECT_NEAR(static_cast<double>(magenta()), static_cast<double>(whole), 0.15 * whole) << "it stands again";
}

TEST_F(ViewerPlayback, WithoutACutterThereIsNothingToPlay)
{
  session->player.reset();
  session->pages.setRemedy("Give the cutter");
  session->press("space");
  EXPECT_NE(session->message.find("nothing to play. Give the cutter"), std::string::npos);
  EXPECT_EQ(session->choice.page, ViewerPage::Boundaries);
}

} // namespace viewer_playback_test
