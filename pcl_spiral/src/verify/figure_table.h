// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Figures of a judgement, each with its name, unit, place and limit.
 */
#pragma once

#include <pcl_spiral/verify/figures.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl_spiral {

/** The unit that people read a figure in. */
enum class FigureUnit {
  None,
  Millimetre,
  Metre, ///< the value is in mm
  Degree,
  Percent,
  Share ///< read in percent; the value is from 0 to 1
};

/** How people read a figure. */
struct FigureStyle {
  FigureUnit unit = FigureUnit::None;
  const char* digits = ".4f"; ///< precision and conversion of printf
  bool sign = false;          ///< whether a page shows the sign of a positive value too
};

enum class FigureKind {
  Count,
  Number, ///< if it has a place, it is that of the first of many, as for a count
  Placed  ///< the place is where the value was found
};

/** The limit on a figure. */
struct FigureLimit {
  const char* name; ///< member of Limits: "Limits::gouge"
  double most;
  double found;             ///< the value that must not be above most
  const char* where = "";   ///< where the figure was taken, after its unit: " beyond the rim"
  bool needs_proof = false; ///< whether the noise of the reference can hide that the limit is broken
  bool holds() const { return found <= most; }
};

/** A figure. JSON has every figure unless forPeople was called; a page can show those that have a name. */
struct Figure {
  std::string key; ///< in JSON, each "/" leads into an object: "deviation/max"
  FigureKind kind = FigureKind::Number;
  double value = 0.0;
  FigureStyle style;
  std::optional<PlacedValue> place;
  bool known = true; ///< false: nothing was measured; people do not see the figure, JSON shows 0, or null without a place
  bool in_json = true;
  std::string name;    ///< for people, filled; see filled()
  std::string reading; ///< what stands for the value, filled; empty: the number and its unit
  std::string if_none; ///< what people read if nothing is known; empty: the figure is left out
  std::optional<FigureLimit> limit;
  bool by_line = false; ///< the index of the place is a line of a program; false: a path point

  Figure& named(const std::string& words, const std::string& value_words = "");
  Figure& knownIf(bool condition, const std::string& otherwise = "");
  Figure& forPeople();
  /** The first place of those counted. */
  Figure& first(const PlacedValue& where);
  /** No limit if \p most is empty. */
  Figure& limited(const char* limit_name, const std::optional<double>& most, double found, const char* where = "",
                  bool needs_proof = false);
};

/** Figures in the order of JSON. */
class FigureTable {
public:
  /** Known if above 0. */
  Figure& count(const std::string& key, std::size_t value);
  Figure& number(const std::string& key, double value, const FigureStyle& style);
  /** Not known if \p value is empty. */
  Figure& placed(const std::string& key, const std::optional<PlacedValue>& value, const FigureStyle& style);

  /** \throw std::out_of_range if there is no such figure */
  Figure& at(const std::string& key) { return figures_[indexOf(key)]; }
  const Figure& at(const std::string& key) const { return figures_[indexOf(key)]; }
  const std::vector<Figure>& figures() const { return figures_; }
  /** Names places by line of a program: \p lines has that of each path point. */
  void placeByLine(const std::vector<std::size_t>& lines);

private:
  Figure& add(const std::string& key, FigureKind kind, double value, const FigureStyle& style);
  std::size_t indexOf(const std::string& key) const;

  std::vector<Figure> figures_;
};

} // namespace pcl_spiral
