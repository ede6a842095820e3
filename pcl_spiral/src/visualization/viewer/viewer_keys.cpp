// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_keys.h"

#include <algorithm>
#include <map>

namespace pcl_spiral {
namespace {

using Command = ViewerCommand;

/** A line of the list of keys. */
struct KeyLine {
  const char *keys, *meaning;
};

constexpr KeyLine lines[] = {{"1", "part and boundaries"},
                             {"2", "path on the surface"},
                             {"3", "deviation map"},
                             {"4", "stock map"},
                             {"5", "scallop histogram"},
                             {"6  space", "playback"},
                             {"t", "every turn, or separate turns only"},
                             {"d", "go to the largest deviation"},
                             {"s", "go to the highest scallop"},
                             {"g", "go to the deepest gouge"},
                             {"click", "choose a point of the path"},
                             {"left right", "previous point, next point"},
                             {"down up", "previous turn, next turn"},
                             {"c", "cutter at the chosen point on, off"},
                             {"drag", "rotate; with shift: move; wheel: zoom"},
                             {"r  z", "show the whole part; look along z"},
                             {"a", "place of the scanned point at the mouse"},
                             {"l", "lasso: drag round it; a polygon file"},
                             {"p", "save the view as PNG"},
                             {"h  q", "this list on, off; quit"}};
constexpr KeyLine playback_lines[] = {{"1 ... 5", "the other views"},
                                      {"space", "play, stop"},
                                      {"+  -", "faster, slower: 1/10 to 1000 times"},
                                      {"b", "bar by length, by time; drag it"},
                                      {"left right", "previous block, next block"},
                                      {"down up", "turn; also shift with left, right"},
                                      {"d", "go to the largest deviation"},
                                      {"s", "go to the highest scallop"},
                                      {"g", "go to the deepest gouge"},
                                      {"e", "go to the next of the slowest blocks"},
                                      {"w", "go to the next warning with a place"},
                                      {"x", "go to the next end of the way of an axis"},
                                      {"m", "machine on, off: the part on its table"},
                                      {"drag", "rotate; with shift: move; wheel: zoom"},
                                      {"r  z", "show the whole part; look along z"},
                                      {"p", "save the view as PNG"},
                                      {"h  q", "this list on, off; quit"}};
/** lowest: above the messages, which may be long */
constexpr int key_width = 92, lowest = 72, most_pitch = 25, least_pitch = 12, gap = 16; ///< pixels

} // namespace

std::optional<ViewerCommand>
commandOf(const std::string& key)
{
  static const std::map<std::string, Command> commands{{"1", Command::ShowBoundaries},     {"2", Command::ShowPath},
                                                       {"3", Command::ShowDeviation},      {"4", Command::ShowStock},
                                                       {"5", Command::ShowHistogram},      {"KP_1", Command::ShowBoundaries},
                                                       {"KP_2", Command::ShowPath},        {"KP_3", Command::ShowDeviation},
                                                       {"KP_4", Command::ShowStock},       {"KP_5", Command::ShowHistogram},
                                                       {"t", Command::ToggleTurns},        {"d", Command::GoToDeviation},
                                                       {"s", Command::GoToScallop},        {"g", Command::GoToGouge},
                                                       {"c", Command::ToggleCutter},       {"Right", Command::NextPoint},
                                                       {"Left", Command::LastPoint},       {"Up", Command::NextTurn},
                                                       {"Down", Command::LastTurn},        {"r", Command::ShowWhole},
                                                       {"z", Command::LookDown},           {"a", Command::ChoosePlace},
                                                       {"l", Command::DrawLasso},          {"p", Command::SavePicture},
                                                       {"h", Command::ToggleKeys},         {"q", Command::Close},
                                                       {"Escape", Command::Close},         {"6", Command::ShowPlayback},
                                                       {"KP_6", Command::ShowPlayback},    {"space", Command::Play},
                                                       {"plus", Command::Faster},          {"minus", Command::Slower},
                                                       {"equal", Command::Faster},         {"KP_Add", Command::Faster},
                                                       {"KP_Subtract", Command::Slower},   {"b", Command::ByLength},
                                                       {"e", Command::NextSlow},           {"w", Command::NextWarning},
                                                       {"x", Command::NextExtreme},        {"m", Command::ShowMachine},
                                                       {"shift Right", Command::NextTurn}, {"shift Left", Command::LastTurn}};
  const auto found = commands.find(key);
  return found == commands.end() ? std::nullopt : std::optional(found->second);
}

bool
needsPath(ViewerCommand command)
{
  constexpr Command others[] = {Command::ShowBoundaries, Command::ShowWhole,   Command::LookDown,   Command::ChoosePlace,
                                Command::DrawLasso,      Command::SavePicture, Command::ToggleKeys, Command::Close};
  return std::find(std::begin(others), std::end(others), command) == std::end(others);
}

void
addKeys(vtkRenderer* words, const PageSize& page, int below, KeyList list)
{
  const int left = page.wordsLeft();
  if (list == KeyList::None)
    return addText(words, "h   list of keys", left, lowest, 17);
  const bool playback = list == KeyList::Playback;
  const KeyLine* const first = playback ? playback_lines : lines;
  const int count = static_cast<int>(playback ? std::size(playback_lines) : std::size(lines));
  const int pitch = std::clamp((below - gap - lowest) / count, least_pitch, most_pitch);
  const int font = std::min(17, pitch * 4 / 5);
  int y = lowest + (count - 1) * pitch;
  for (const KeyLine* line = first; line != first + count; ++line, y -= pitch) {
    addText(words, line->keys, left, y, font, true);
    addText(words, line->meaning, left + key_width, y, font);
  }
}

} // namespace pcl_spiral
