// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Settings as a table: what every face of the library shows of each one, and the variable that holds it.
 */
#pragma once

#include <pcl_spiral/core/choice.h>
#include <pcl_spiral/core/diagnostic.h>

#include <Eigen/Core>

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pcl_spiral {

/** The numbers that a setting takes; by default all that are finite. */
struct NumberRange {
  double least = -std::numeric_limits<double>::infinity(); ///< the lower end
  bool takes_least = false;                                ///< whether the lower end belongs to it
  double most = std::numeric_limits<double>::infinity();   ///< the upper end
  bool takes_most = false;                                 ///< whether the upper end belongs to it

  bool takes(double number) const; ///< Whether \p number is in it; not-a-number never is.

  /** The numbers above \p bound. */
  static NumberRange above(double bound) { return {bound, false, std::numeric_limits<double>::infinity(), false}; }
  /** The numbers from \p bound on. */
  static NumberRange from(double bound) { return {bound, true, std::numeric_limits<double>::infinity(), false}; }
  NumberRange below(double bound) const { return {least, takes_least, bound, false}; } ///< Of these, the numbers below \p bound.
  NumberRange upTo(double bound) const { return {least, takes_least, bound, true}; }   ///< Of these, the numbers up to \p bound.
};

/** One of the words of an enumeration: the variable of a setting that is a choice. */
struct ChoiceTarget {
  std::string words;                                 ///< all of them: "auto|one|two"
  std::function<std::string()> get;                  ///< the word of the value
  std::function<bool(const std::string& word)> take; ///< sets the value; false if it is none of the words
};

/** One setting of an object that holds settings. It refers to a variable of that object, and must not outlive it.
 *
 *  Everything that shows or checks settings is made from tables of these: checks of compute, options of the programs with their help, JSON
 *  reports, keywords of scripts, the page of all settings.
 *  \code
 *  SpiralSettings settings;
 *  for (const Setting& setting : settingTable(settings))
 *    std::cout << setting.name << " = " << textOf(setting) << ' ' << setting.unit << '\n'; // tool_radius = 0 mm
 *  \endcode
 */
struct Setting {
  /** The variable; a null pointer does not occur. */
  using Target = std::variant<bool*, int*, unsigned int*, double*, Eigen::Vector3d*, std::optional<double>*,
                              std::optional<Eigen::Vector3d>*, ChoiceTarget>;

  /** \p name, \p setter, \p words, \p help and \p example: see the members of these names. \p variable holds the value. */
  template <typename Value>
  Setting(const char* name, const char* setter, const char* words, const char* help, const char* example, Value& variable)
  : name(name), setter(setter), words(words), help(help), example(example), option(withDashes(name)), target(targetOf(variable))
  {}

  /** The same with a unit and a range. */
  Setting in(const char* of_unit, const NumberRange& of_range) &&
  {
    unit = of_unit;
    range = of_range;
    return std::move(*this);
  }
  /** The same, where 0 means \p meaning. */
  Setting zeroFor(const char* meaning) &&
  {
    zero = meaning;
    return std::move(*this);
  }
  /** The same, where a value out of range has a remedy beside another value. */
  Setting withRemedy(const char* sentence) &&
  {
    remedy = sentence;
    return std::move(*this);
  }
  /** The same, whose option \p of_option the programs write in their own way. */
  Setting writtenBy(const char* of_option) &&
  {
    option = of_option;
    by_table = false;
    return std::move(*this);
  }
  /** The same, without an option of the programs. */
  Setting onlyInCode() && { return std::move(*this).writtenBy(""); }

  std::string name;     ///< in scripts and reports: "tool_radius"
  std::string setter;   ///< in C++: "setToolRadius", or the member of a struct
  std::string words;    ///< in a sentence: "tool radius"
  std::string help;     ///< what it is
  std::string example;  ///< a value that is usual
  std::string unit;     ///< "mm"; empty: none
  std::string zero;     ///< what 0, or no value, stands for, as in "0 for the tool radius"; empty: for itself
  Diagnostic remedy;    ///< for a value out of range, beside another value; empty: none
  std::string option;   ///< of the programs, without dashes: "tool-radius"; empty: none
  bool by_table = true; ///< whether the option is made of the table
  NumberRange range;    ///< of a number
  Target target;        ///< the variable

private:
  static std::string withDashes(std::string name);

  template <typename Value>
  static Target targetOf(Value& variable)
  {
    if constexpr (std::is_constructible_v<Target, Value*>)
      return &variable;
    else
      return choiceOf(variable);
  }
  template <typename Enum>
  static ChoiceTarget choiceOf(Enum& variable)
  {
    return {choiceList<Enum>(), [&variable] { return choiceName(variable); }, takeInto<Enum>(variable)};
  }
  template <typename Enum>
  static ChoiceTarget choiceOf(std::optional<Enum>& variable)
  {
    return {choiceList<Enum>(), [&variable] { return variable ? choiceName(*variable) : std::string(); }, takeInto<Enum>(variable)};
  }
  template <typename Enum, typename Variable>
  static std::function<bool(const std::string&)> takeInto(Variable& variable)
  {
    return [&variable](const std::string& word) {
      const std::optional<Enum> value = choiceFromName<Enum>(word);
      if (value)
        variable = *value;
      return value.has_value();
    };
  }
};

/** The value: "0.05", "1,2,3", "yes", "outward"; empty: an optional one that is not set. */
std::string textOf(const Setting& setting);

/** The value as a number; nothing if it is none. */
std::optional<double> numberOf(const Setting& setting);

/** What a number must be: "must be above 0 {mm}, such as 10". */
Diagnostic ruleOf(const Setting& setting);

/** Empty, or the first value that its setting does not take, with the remedy: "the tool radius is -1 {mm}: it must be above 0 {mm}, such as
 *  10 ({setToolRadius})". Places and directions must be finite. */
Diagnostic faultOf(const std::vector<Setting>& settings);

/** The same for an object that has a table. */
template <typename Settings>
Diagnostic
rangeFault(Settings settings)
{
  return faultOf(settingTable(settings));
}

/** Both tables, that of \p more behind \p settings. */
std::vector<Setting> operator+(std::vector<Setting> settings, const std::vector<Setting>& more);

} // namespace pcl_spiral
