// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_session.h"

#include "path_pick.h"
#include "visualization/path_layer.h"
#include "visualization/scene_check.h"

#include <pcl_spiral/io/file_error.h>

#include <vtkCallbackCommand.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

namespace pcl_spiral {
namespace {

constexpr std::chrono::milliseconds poll_interval(10);
constexpr Color place_color{0.80, 0.0, 0.55};
constexpr int message_bottom = 14, message_apart = 26, message_size = 18;

} // namespace

ViewerSession::ViewerSession(VerificationScene given)
: scene(checkedScene(std::move(given), false)), surface(displaySurface(scene.part)), window(surface, "pcl_spiral: " + scene.part.title),
  pages(scene, window), interactor(vtkSmartPointer<vtkRenderWindowInteractor>::New())
{
  interactor->SetRenderWindow(window.window());
  interactor->SetInteractorStyle(style);
  style->pressed = [this](const std::string& key) { press(key); };
  style->clicked = [this](int x, int y) { click(x, y); };
  style->moved = [this] {
    window.setLasso({}); // it belongs to the view in which it was drawn
    show();
  };
  style->zoomed = [this] {
    window.setLasso({});
    stale = true;
  };
  style->drawn = [this](int x, int y) { slides_ ? slide(x) : draw(x, y); };
  style->closed = [this] { slides_ ? endSlide() : endLasso(); };
  style->grabs = [this](int x, int y) { return slides_ = choice.page == ViewerPage::Playback && playback->isOnBar(x, y); };
  window.setResized([this] { fill(); });
  vtkNew<vtkCallbackCommand> close; // the close button of the window
  close->SetClientData(this);
  close->SetCallback([](vtkObject*, unsigned long, void* self, void*) { static_cast<ViewerSession*>(self)->closed = true; });
  interactor->AddObserver(vtkCommand::ExitEvent, close);
  interactor->Initialize();
  show();
}

ViewerSession::~ViewerSession()
{
  // VTK 9.3 keeps a list of all interactors, runs each of them, and removes only those that are done: a deleted
  // interactor would be called for the events of the next window
  interactor->Disable();
  interactor->SetDone(true);
  interactor->ProcessEvents();
}

void
ViewerSession::fill()
{
  const int below = choice.page == ViewerPage::Playback ? playback->fill() : pages.fill(choice);
  if (place)
    window.addCircle(*place, place_color);
  const KeyList list = choice.page == ViewerPage::Playback ? KeyList::Playback : KeyList::Views;
  addKeys(window.words(), window.page(), below, keys_listed ? list : KeyList::None);
  const bool point = choice.point && choice.page != ViewerPage::Playback;
  addText(window.words(), message, 30, message_bottom + (point ? message_apart : 0), message_size);
  if (point)
    addText(window.words(), pointInWords(), 30, message_bottom, message_size);
}

void
ViewerSession::show()
{
  stale = false;
  fill();
  window.render();
}

void
ViewerSession::run()
{
  // vtkRenderWindowInteractor::Start would close the window, and fails with interactors that others have
  // deleted
  closed = false;
  auto last = std::chrono::steady_clock::now();
  while (!closed && !(close_wanted && close_wanted())) {
    interactor->ProcessEvents();
    if (stale)
      show();
    const auto now = std::chrono::steady_clock::now();
    if (choice.page == ViewerPage::Playback)
      play(std::chrono::duration<double>(now - last).count());
    last = now;
    std::this_thread::sleep_for(player && player->playing() ? std::chrono::milliseconds(1) : poll_interval);
  }
}

void
ViewerSession::press(const std::string& key)
{
  const std::optional<ViewerCommand> command = commandOf(key);
  if (!command)
    return;
  message.clear();
  window.setLasso({});
  style->lasso = false;
  if (scene.part.path->empty() && needsPath(*command))
    message = "there is no path: start again with the scan and a path";
  else if (!obeyPlayback(*command))
    obey(*command);
  if (*command != ViewerCommand::Close)
    show();
}

void
ViewerSession::obey(ViewerCommand command)
{
  switch (command) {
  case ViewerCommand::ShowBoundaries:
    choice.page = ViewerPage::Boundaries;
    return;
  case ViewerCommand::ShowPath:
    choice.page = ViewerPage::Path;
    return;
  case ViewerCommand::ShowDeviation:
    choice.page = ViewerPage::Deviation;
    return;
  case ViewerCommand::ShowStock:
    choice.page = ViewerPage::Stock;
    return;
  case ViewerCommand::ShowHistogram:
    choice.page = ViewerPage::Histogram;
    return;
  case ViewerCommand::ToggleTurns:
    choice.every_turn = !choice.every_turn;
    message = choice.every_turn ? "every turn is shown" : "only turns that appear separate are shown";
    return;
  case ViewerCommand::GoToDeviation:
    return goToDeviation();
  case ViewerCommand::GoToScallop:
    return goToStock(false);
  case ViewerCommand::GoToGouge:
    return goToStock(true);
  case ViewerCommand::ToggleCutter:
    return toggleCutter();
  case ViewerCommand::NextPoint:
    return step(1);
  case ViewerCommand::LastPoint:
    return step(-1);
  case ViewerCommand::NextTurn:
    return stepTurn(1.0);
  case ViewerCommand::LastTurn:
    return stepTurn(-1.0);
  case ViewerCommand::ShowWhole:
    return window.reset();
  case ViewerCommand::LookDown:
    return window.lookDown();
  case ViewerCommand::ChoosePlace:
    return choosePlace(interactor->GetEventPosition()[0], interactor->GetEventPosition()[1]);
  case ViewerCommand::DrawLasso:
    return beginLasso();
  case ViewerCommand::SavePicture:
    return savePicture();
  case ViewerCommand::ToggleKeys:
    keys_listed = !keys_listed;
    return;
  case ViewerCommand::Close:
    closed = true;
    return;
  default:
    return; // see obeyPlayback
  }
}

void
ViewerSession::goTo(const PlacedValue& worst, const std::string& what)
{
  choice.point = std::min(worst.index, scene.part.path->size() - 1);
  window.lookAt(worst.position, normalOf((*scene.part.path)[*choice.point]), pages.nearWidth());
  message = what + formatted(": %.4f mm at (%.3f, ", worst.value, worst.position.x()) +
            formatted("%.3f, %.3f)", worst.position.y(), worst.position.z()) + ", by path point " + std::to_string(worst.index);
}

void
ViewerSession::goToDeviation()
{
  choice.page = ViewerPage::Deviation;
  if (!scene.deviation.empty())
    goTo(scene.deviation_figures.max, "largest deviation");
}

void
ViewerSession::goToStock(bool gouge)
{
  choice.page = ViewerPage::Stock;
  if (scene.stock.empty())
    return;
  const PlacedValue& worst = gouge ? scene.removal_figures.gouge : scene.removal_figures.scallop.max;
  if (worst.value > 0.0)
    goTo(worst, gouge ? "deepest gouge" : "highest scallop");
  else
    message = gouge ? "there is no gouge" : "there is no scallop";
}

void
ViewerSession::toggleCutter()
{
  if (!(scene.part.settings.tool_radius > 0.0)) {
    message = "the cutter's radius is not known";
    return;
  }
  choice.cutter = !choice.cutter;
  if (choice.cutter && !choice.point)
    choose(0);
  if (choice.page == ViewerPage::Boundaries || choice.page == ViewerPage::Histogram)
    choice.page = ViewerPage::Path;
}

void
ViewerSession::step(int points)
{
  const auto last = static_cast<std::ptrdiff_t>(scene.part.path->size()) - 1;
  if (!choice.point)
    return choose(0);
  choose(static_cast<std::size_t>(std::clamp(static_cast<std::ptrdiff_t>(*choice.point) + points, std::ptrdiff_t{0}, last)));
}

void
ViewerSession::stepTurn(double turns)
{
  if (!choice.point)
    return choose(0);
  const auto& path = *scene.part.path;
  const double wanted = path[*choice.point].turn + turns;
  std::size_t i = *choice.point;
  while (turns > 0.0 && i + 1 < path.size() && path[i].turn < wanted)
    ++i;
  while (turns < 0.0 && i > 0 && path[i].turn > wanted)
    --i;
  choose(i);
}

void
ViewerSession::choose(std::size_t point)
{
  choice.point = point;
}

void
ViewerSession::click(int x, int y)
{
  message.clear();
  if (choice.page == ViewerPage::Histogram || choice.page == ViewerPage::Playback)
    return;
  if (scene.part.path->empty()) {
    choosePlace(x, y);
    return show();
  }
  const ShownTurns shown = pages.turns(choice);
  const bool all = choice.page == ViewerPage::Stock || choice.page == ViewerPage::Boundaries;
  const auto found = pickPoint(
      window, *scene.part.path, [&](const ToolpathPoint& point) { return all || shown.shows(point.turn); }, Eigen::Vector2d(x, y));
  if (found)
    choose(*found);
  else
    message = "no visible point of the path is within 12 pixels of the click";
  show();
}

std::string
ViewerSession::pointInWords() const
{
  const ToolpathPoint& point = (*scene.part.path)[*choice.point];
  std::string words = "path point " + std::to_string(*choice.point) + " of " + std::to_string(scene.part.path->size()) +
                      formatted(" at (%.3f, %.3f, %.3f)", point.x, point.y, point.z) + formatted(" mm, turn %.2f", point.turn);
  if (!scene.deviation.empty()) {
    const float deviation = scene.deviation[*choice.point];
    words += std::isnan(deviation) ? ", no surface there" : formatted(", deviation %+.4f mm", deviation);
  }
  return words;
}

} // namespace pcl_spiral
