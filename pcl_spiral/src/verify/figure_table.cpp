// SPDX-License-Identifier: BSD-3-Clause
#include "verify/figure_table.h"

#include <algorithm>
#include <stdexcept>

namespace pcl_spiral {

Figure&
Figure::named(const std::string& words, const std::string& value_words)
{
  name = words;
  reading = value_words;
  return *this;
}

Figure&
Figure::knownIf(bool condition, const std::string& otherwise)
{
  known = condition;
  if_none = otherwise;
  return *this;
}

Figure&
Figure::forPeople()
{
  in_json = false;
  return *this;
}

Figure&
Figure::first(const PlacedValue& where)
{
  place = where;
  return *this;
}

Figure&
Figure::limited(const char* limit_name, const std::optional<double>& most, double found, const char* where, bool needs_proof)
{
  if (most)
    limit = FigureLimit{limit_name, *most, found, where, needs_proof};
  return *this;
}

Figure&
FigureTable::count(const std::string& key, std::size_t value)
{
  return add(key, FigureKind::Count, static_cast<double>(value), {}).knownIf(value > 0);
}

Figure&
FigureTable::number(const std::string& key, double value, const FigureStyle& style)
{
  return add(key, FigureKind::Number, value, style);
}

Figure&
FigureTable::placed(const std::string& key, const std::optional<PlacedValue>& value, const FigureStyle& style)
{
  Figure& figure = add(key, FigureKind::Placed, value ? value->value : 0.0, style);
  figure.place = value;
  return figure.knownIf(value.has_value());
}

void
FigureTable::placeByLine(const std::vector<std::size_t>& lines)
{
  for (Figure& figure : figures_)
    if (figure.place && figure.place->index < lines.size()) {
      figure.place->index = lines[figure.place->index];
      figure.by_line = true;
    }
}

Figure&
FigureTable::add(const std::string& key, FigureKind kind, double value, const FigureStyle& style)
{
  Figure figure;
  figure.key = key;
  figure.kind = kind;
  figure.value = value;
  figure.style = style;
  return figures_.emplace_back(std::move(figure));
}

std::size_t
FigureTable::indexOf(const std::string& key) const
{
  const auto found = std::find_if(figures_.begin(), figures_.end(), [&](const Figure& figure) { return figure.key == key; });
  if (found == figures_.end())
    throw std::out_of_range("no figure is called " + key);
  return static_cast<std::size_t>(found - figures_.begin());
}

} // namespace pcl_spiral
