// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/core/setting.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>

namespace pcl_spiral {
namespace {

/** As short as it can be without loss. */
std::string
shortest(double number)
{
  char text[32];
  for (const int digits : {6, 9, 17}) {
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    if (std::stod(text) == number)
      break;
  }
  return text;
}

std::string
textOfValue(const Eigen::Vector3d& v)
{
  return shortest(v.x()) + "," + shortest(v.y()) + "," + shortest(v.z());
}

/** A number with the unit behind it, if there is one: "1 {spacing}", "2 {spacings}". */
Diagnostic
withUnit(double number, const Setting& setting)
{
  const bool whole = number == std::floor(number) && std::abs(number) < 1e15;
  const Diagnostic digits = whole ? Diagnostic(static_cast<long long>(number)) : Diagnostic(number);
  std::string unit = setting.unit;
  if (number == 1.0 && !unit.empty() && unit.back() == 's')
    unit.pop_back();
  return unit.empty() ? digits : Diagnostic(digits, " ", ("{" + unit + "}").c_str());
}

/** The range in words: "above 0 and below 90 {degrees}". */
Diagnostic
rangeOf(const Setting& setting)
{
  const NumberRange& r = setting.range;
  const bool has_least = std::isfinite(r.least), has_most = std::isfinite(r.most);
  if (has_least && has_most)
    return r.takes_least && r.takes_most ? Diagnostic("from ", r.least, " to ", withUnit(r.most, setting))
                                         : Diagnostic(r.takes_least ? "at least " : "above ", r.least, " and ",
                                                      r.takes_most ? "at most " : "below ", withUnit(r.most, setting));
  if (has_least)
    return r.takes_least ? Diagnostic(withUnit(r.least, setting), " or more") : Diagnostic("above ", withUnit(r.least, setting));
  if (has_most)
    return Diagnostic(r.takes_most ? "at most " : "below ", withUnit(r.most, setting));
  return setting.unit.empty() ? Diagnostic("a number") : Diagnostic("a number of", (" {" + setting.unit + "}").c_str());
}

bool
isFinite(const Setting& setting)
{
  if (const auto* place = std::get_if<Eigen::Vector3d*>(&setting.target))
    return (*place)->allFinite();
  if (const auto* place = std::get_if<std::optional<Eigen::Vector3d>*>(&setting.target))
    return !**place || (**place)->allFinite();
  return true;
}

} // namespace

bool
NumberRange::takes(double number) const
{
  return (number > least || (takes_least && number == least)) && (number < most || (takes_most && number == most));
}

std::string
Setting::withDashes(std::string name)
{
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

std::optional<double>
numberOf(const Setting& setting)
{
  return std::visit(
      [](const auto& value) -> std::optional<double> {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, double*> || std::is_same_v<Value, int*> || std::is_same_v<Value, unsigned int*>)
          return static_cast<double>(*value);
        else if constexpr (std::is_same_v<Value, std::optional<double>*>)
          return *value;
        else
          return std::nullopt;
      },
      setting.target);
}

std::string
textOf(const Setting& setting)
{
  if (const std::optional<double> number = numberOf(setting))
    return shortest(*number);
  if (const auto* flag = std::get_if<bool*>(&setting.target))
    return **flag ? "yes" : "no";
  if (const auto* choice = std::get_if<ChoiceTarget>(&setting.target))
    return choice->get();
  if (const auto* place = std::get_if<Eigen::Vector3d*>(&setting.target))
    return textOfValue(**place);
  if (const auto* place = std::get_if<std::optional<Eigen::Vector3d>*>(&setting.target); place && **place)
    return textOfValue(***place);
  return {};
}

Diagnostic
ruleOf(const Setting& setting)
{
  Setting other = setting; // of those for which 0 has a meaning, all but 0
  other.range.takes_least = setting.range.takes_least && setting.zero.empty();
  Diagnostic rule("must be ", rangeOf(other));
  if (!setting.zero.empty())
    rule += Diagnostic(", or 0 for ", setting.zero.c_str());
  if (!setting.example.empty())
    rule += Diagnostic(", such as ", setting.example.c_str());
  return setting.remedy.empty() ? rule : Diagnostic(rule, "; ", setting.remedy);
}

Diagnostic
faultOf(const std::vector<Setting>& settings)
{
  for (const Setting& setting : settings) {
    const std::string setter = " ({" + setting.setter + "})";
    if (const std::optional<double> number = numberOf(setting); number && !setting.range.takes(*number))
      return Diagnostic("the ", setting.words.c_str(), " is ", withUnit(*number, setting), ": it ", ruleOf(setting), setter.c_str());
    if (!isFinite(setting))
      return Diagnostic("the ", setting.words.c_str(), " is ", textOf(setting), ": its coordinates must be finite", setter.c_str());
  }
  return {};
}

std::vector<Setting>
operator+(std::vector<Setting> settings, const std::vector<Setting>& more)
{
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

} // namespace pcl_spiral
