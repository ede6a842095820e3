// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_session.h"

#include <algorithm>

namespace pcl_spiral {
namespace {

constexpr double machine_room = 2.6; ///< of the width of the view of the part

} // namespace

void
ViewerSession::setPlayback(PlaybackScene scene_of_playback)
{
  const bool open = choice.page == ViewerPage::Playback;
  if (open)
    choice.page = ViewerPage::Stock; // the page goes with its player
  playback.reset();
  player = std::make_unique<Player>(std::move(scene_of_playback), scene);
  if (open)
    show();
}

/** Shows the playback, if there is one. */
bool
ViewerSession::openPlayback()
{
  if (choice.page == ViewerPage::Playback)
    return true;
  if (!player) {
    message = "there is nothing to play. " + pages.remedy();
    return false;
  }
  if (const std::string fault = player->prepare(); !fault.empty()) {
    message = fault;
    return false;
  }
  if (!playback)
    playback = std::make_unique<PlaybackPage>(*player, scene, window);
  choice.page = ViewerPage::Playback;
  return true;
}

bool
ViewerSession::obeyPlayback(ViewerCommand command)
{
  const bool open = choice.page == ViewerPage::Playback;
  switch (command) {
  case ViewerCommand::ShowPlayback:
    return openPlayback(), true;
  case ViewerCommand::Play:
    if (openPlayback())
      player->toggle();
    return true;
  case ViewerCommand::Faster:
  case ViewerCommand::Slower:
    if (openPlayback())
      player->faster(command == ViewerCommand::Faster);
    return true;
  case ViewerCommand::ByLength:
    if (openPlayback())
      player->toggleLength();
    return true;
  case ViewerCommand::NextSlow:
    if (openPlayback())
      message = player->nextSlow();
    return true;
  case ViewerCommand::NextWarning:
    if (openPlayback())
      message = player->nextWarning();
    return true;
  case ViewerCommand::NextExtreme:
    if (openPlayback())
      message = player->nextExtreme();
    return true;
  case ViewerCommand::ShowMachine:
    if (openPlayback()) {
      playback->toggleMachine();
      window.widen(playback->showsMachine() ? machine_room : 1.0 / machine_room);
    }
    return true;
  case ViewerCommand::NextPoint:
  case ViewerCommand::LastPoint:
    if (open)
      player->stepBlock(command == ViewerCommand::NextPoint);
    return open;
  case ViewerCommand::NextTurn:
  case ViewerCommand::LastTurn:
    if (open)
      player->stepTurn(command == ViewerCommand::NextTurn);
    return open;
  case ViewerCommand::GoToDeviation:
  case ViewerCommand::GoToScallop:
  case ViewerCommand::GoToGouge: {
    if (!open)
      return false;
    const PlacedValue& worst = command == ViewerCommand::GoToDeviation ? scene.deviation_figures.max
                               : command == ViewerCommand::GoToGouge   ? scene.removal_figures.gouge
                                                                       : scene.removal_figures.scallop.max;
    player->goToPoint(worst.index);
    message = formatted(command == ViewerCommand::GoToDeviation ? "largest deviation: %.4f mm"
                        : command == ViewerCommand::GoToGouge   ? "deepest gouge: %.4f mm"
                                                                : "highest scallop: %.4f mm",
                        worst.value);
    return true;
  }
  default:
    return false;
  }
}

void
ViewerSession::play(double wall_seconds)
{
  if (!player->playing() && !player->hasNewStock())
    return;
  player->advance(wall_seconds);
  playback->update();
  window.render();
}

void
ViewerSession::slide(int x)
{
  player->seekShare(playback->shareAt(x));
  playback->update();
  window.render();
}

void
ViewerSession::endSlide()
{
  slides_ = false;
  show();
}

} // namespace pcl_spiral
