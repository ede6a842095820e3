// SPDX-License-Identifier: BSD-3-Clause
#include "fitted_text.h"

#include <vtkTextProperty.h>

#include <algorithm>
#include <string>

namespace pcl_spiral {
namespace {

constexpr int least_size = 12;         ///< of a font that is read at ease
constexpr double least_share = 0.6;    ///< of the size asked for: titles stay titles
constexpr double text_margin = 12.0;   ///< pixels
constexpr std::size_t least_words = 8; ///< bytes kept

bool
isWiderThan(double room, vtkTextActor* actor, vtkRenderer* view)
{
  double box[4];
  actor->GetBoundingBox(view, box);
  return box[1] - box[0] + 1.0 > room;
}

/** \p count bytes of UTF-8 and three dots in their middle; characters stay whole. */
std::string
shortened(const std::string& words, std::size_t count)
{
  const auto isInside = [&words](std::size_t at) { return at < words.size() && (static_cast<unsigned char>(words[at]) & 0xC0U) == 0x80U; };
  std::size_t head = count / 2, tail = words.size() - count / 2;
  while (head > 0 && isInside(head))
    --head;
  while (isInside(tail))
    ++tail;
  return words.substr(0, head) + "..." + words.substr(tail);
}

} // namespace

void
fitText(vtkTextActor* actor, vtkRenderer* view, double room)
{
  vtkTextProperty* const font = actor->GetTextProperty();
  const int least = std::max(least_size, static_cast<int>(least_share * font->GetFontSize()));
  while (font->GetFontSize() > least && isWiderThan(room, actor, view))
    font->SetFontSize(font->GetFontSize() - 1);
  const std::string words = actor->GetInput() ? actor->GetInput() : "";
  for (std::size_t count = words.size(); count > least_words && isWiderThan(room, actor, view);)
    actor->SetInput(shortened(words, count -= 2).c_str());
}

double
roomRightOf(double x, vtkRenderer* view)
{
  return view->GetSize()[0] - text_margin - x;
}

} // namespace pcl_spiral
