// SPDX-License-Identifier: BSD-3-Clause
#include "planning/proposed_value.h"

#include "planning/input_tables.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>
#include <variant>

namespace pcl_spiral {
namespace {

constexpr double more_room = 1.5; // times the depth that a ball or a shank cuts: where it comes from changes with the outline
constexpr double per_mm = 1000.0; // places are shown to 0.001 mm
constexpr double upright = 1e-6;  // sine of the lean of a keep-out

/** \p value to three digits, not below it. */
double
roundedUp(double value)
{
  const double down = roundedDown(value), unit = value > 0.0 ? std::pow(10.0, std::floor(std::log10(value)) - 2.0) : 0.0;
  return down * (1.0 + 1e-12) >= value ? down : down + unit;
}

/** \p box, made larger so that its corners are as they are shown. */
Eigen::AlignedBox3d
asShown(const Eigen::AlignedBox3d& box)
{
  return {Eigen::Vector3d((per_mm * box.min()).array().floor() / per_mm), Eigen::Vector3d((per_mm * box.max()).array().ceil() / per_mm)};
}

/** The box about the keep-out of \p input that is nearest to \p place, wider by \p more, mm; empty: there is none, or it leans, and no box
 *  is about it. */
Eigen::AlignedBox3d
widerKeepOut(const PlanInput& input, const Eigen::Vector3d& place, double more)
{
  const Prism* nearest = nullptr;
  for (const Prism& prism : input.choice.keep_outs)
    if (!nearest || prism.distance(place) < nearest->distance(place))
      nearest = &prism;
  Eigen::AlignedBox3d box;
  if (!nearest || nearest->axis().cross(Eigen::Vector3d::UnitZ()).norm() > upright)
    return box;
  for (const Eigen::Vector3d& corner : nearest->outline(nearest->width()))
    box.extend(corner);
  const Eigen::Vector3d aside(more, more, 0.0);
  return {box.min() - aside, box.max() + aside};
}

/** A box in which nothing is cut, of the \p proposed value. */
std::optional<Given>
takeKeepOut(const Proposed& proposed, const Eigen::Vector3d& place, PlanInput& input)
{
  Eigen::AlignedBox3d box;
  if (const auto* extents = std::get_if<Extents>(&proposed.value))
    box.extend(extents->low).extend(extents->high);
  else if (const auto* depth = std::get_if<double>(&proposed.value))
    box = widerKeepOut(input, place, more_room * *depth);
  if (box.isEmpty())
    return std::nullopt;
  box = asShown(box);
  input.choice.keep_outs.push_back(uprightPrism(box));
  return Given("addKeepOut", box.min(), box.max());
}

/** A number, in a variable of \p setting; what it is then. */
std::optional<double>
takeNumber(double value, const Setting& setting)
{
  auto* const* target = std::get_if<double*>(&setting.target);
  if (!target || !setting.range.takes(value) || **target == value)
    return std::nullopt;
  **target = value;
  return value;
}

} // namespace

std::optional<Given>
takeProposed(const Proposed& proposed, const Eigen::Vector3d& place, PlanInput& input)
{
  if (proposed.setting == "addKeepOut")
    return takeKeepOut(proposed, place, input);
  if (const auto* at = std::get_if<Eigen::Vector3d>(&proposed.value); at && proposed.setting == "setPartAt") {
    const Eigen::Vector3d shown = (per_mm * *at).array().round() / per_mm;
    input.choice.part_at = shown;
    return Given(proposed.setting, shown);
  }
  for (const Setting& setting : settingTable(input.settings) + settingTable(input)) {
    if (setting.setter != proposed.setting)
      continue;
    if (const auto* number = std::get_if<double>(&proposed.value)) {
      const bool is_longer = proposed.setting == "setFlankLength";
      if (const auto taken = takeNumber(is_longer ? roundedUp(*number) : roundedDown(*number), setting))
        return Given(proposed.setting, *taken);
    }
    else if (const auto* word = std::get_if<std::string>(&proposed.value))
      if (auto* choice = std::get_if<ChoiceTarget>(&setting.target); choice && choice->get() != *word && choice->take(*word))
        return Given(proposed.setting, *word);
  }
  return std::nullopt;
}

bool
keepsSurface(const std::string& setter)
{
  SurfaceSettings surface;
  const std::vector<Setting> table = settingTable(surface);
  return setter != "addKeepOut" && setter != "setBallClosing" &&
         std::none_of(table.begin(), table.end(), [&](const Setting& setting) { return setting.setter == setter; });
}

Prism
uprightPrism(const Eigen::AlignedBox3d& box)
{
  const Eigen::Vector3d low = box.min(), high = box.max();
  return Prism({{low.x(), low.y(), 0.0}, {high.x(), low.y(), 0.0}, {high.x(), high.y(), 0.0}, {low.x(), high.y(), 0.0}},
               Eigen::Vector3d::UnitZ());
}

double
roundedDown(double value)
{
  if (!(value > 0.0))
    return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2.0);
  return std::floor(value / unit * (1.0 + 1e-12)) * unit;
}

void
copyValue(const Setting& from, const Setting& to)
{
  std::visit(
      [&from](const auto& target) {
        using Target = std::decay_t<decltype(target)>;
        if constexpr (std::is_same_v<Target, ChoiceTarget>)
          target.take(std::get<Target>(from.target).get());
        else
          *target = *std::get<Target>(from.target);
      },
      to.target);
}

} // namespace pcl_spiral
