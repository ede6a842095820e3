// SPDX-License-Identifier: BSD-3-Clause
#include "verify/figure_text.h"

#include "common/formatted_text.h"

namespace pcl_spiral {
namespace {

/** A hole of a text: the key, and '#' or '@' before it, or 0. */
struct Hole {
  char mark = 0;
  std::string key;
};

/** Calls \p words_between with each piece of text, and \p hole_at with each hole, from left to right. */
template <typename Words, typename AtHole>
void
forEachPiece(const std::string& words, const Words& words_between, const AtHole& hole_at)
{
  std::size_t at = 0;
  for (std::size_t open = words.find('{'); open != std::string::npos; open = words.find('{', at)) {
    const std::size_t close = words.find('}', open);
    words_between(words.substr(at, open - at));
    const char mark = words[open + 1];
    const bool marked = mark == '#' || mark == '@';
    const std::size_t key = open + (marked ? 2 : 1);
    hole_at(Hole{marked ? mark : '\0', words.substr(key, close - key)});
    at = close + 1;
  }
  words_between(words.substr(at));
}

double
inUnit(double value, FigureUnit unit)
{
  return unit == FigureUnit::Metre ? value / 1000.0 : unit == FigureUnit::Share ? 100.0 * value : value;
}

std::string
holeText(const Hole& hole, const FigureTable& table, const FigureWriting& writing)
{
  const Figure& figure = table.at(hole.key);
  if (hole.mark == '@')
    return placeSuffix(figure);
  return numberText(figure, writing) + (hole.mark == '#' ? "" : unitSuffix(figure, writing));
}

} // namespace

std::string
numberText(const Figure& figure, const FigureWriting& writing)
{
  if (figure.kind == FigureKind::Count)
    return std::to_string(static_cast<std::size_t>(figure.value));
  const std::string format = std::string(writing.signs && figure.style.sign ? "%+" : "%") + figure.style.digits;
  return formatted(format.c_str(), inUnit(figure.value, figure.style.unit));
}

std::string
unitSuffix(const Figure& figure, const FigureWriting& writing)
{
  switch (figure.style.unit) {
  case FigureUnit::None:
    return "";
  case FigureUnit::Millimetre:
    return " mm";
  case FigureUnit::Metre:
    return " m";
  case FigureUnit::Degree:
    return writing.degree;
  case FigureUnit::Percent:
  case FigureUnit::Share:
    return " %";
  }
  return "";
}

std::string
placeSuffix(const Figure& figure)
{
  if (!figure.place)
    return "";
  const Eigen::Vector3d& at = figure.place->position;
  return (figure.kind == FigureKind::Placed ? " " : ", first ") +
         formatted("at (%.3f, %.3f, %.3f), %s %zu", at.x(), at.y(), at.z(), figure.by_line ? "line" : "path point", figure.place->index);
}

std::string
filled(const std::string& words, const FigureTable& table, const FigureWriting& writing)
{
  std::string text;
  forEachPiece(
      words, [&](const std::string& between) { text += between; }, [&](const Hole& hole) { text += holeText(hole, table, writing); });
  return text;
}

bool
allKnown(const std::string& words, const FigureTable& table)
{
  bool all = true;
  forEachPiece(
      words, [](const std::string&) {}, [&](const Hole& hole) { all = table.at(hole.key).known && all; });
  return all;
}

} // namespace pcl_spiral
