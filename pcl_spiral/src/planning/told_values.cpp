// SPDX-License-Identifier: BSD-3-Clause
#include "planning/told_values.h"

#include <cmath>
#include <type_traits>
#include <variant>

namespace pcl_spiral {
namespace {

/** How often \p field stands in the first \p end characters of \p id. */
std::size_t
countOf(const std::string& field, const std::string& id, std::size_t end)
{
  std::size_t count = 0;
  for (std::size_t at = id.find(field); at < end; at = id.find(field, at + 1))
    ++count;
  return count;
}

} // namespace

double
numberBehind(const Diagnostic& said, std::initializer_list<std::string> words)
{
  const std::string id = said.id();
  for (const std::string& before : words)
    if (const std::size_t at = id.rfind(before + "{number}"); at != std::string::npos)
      return said.numbers().at(countOf("{number}", id, at + before.size()));
  return 0.0;
}

std::vector<Eigen::Vector3d>
placesBehind(const Diagnostic& said, const std::string& words)
{
  const std::string id = said.id(), sought = words + "{place}";
  const std::vector<Eigen::Vector3d> places = said.places();
  std::vector<Eigen::Vector3d> found;
  for (std::size_t at = id.find(sought); at != std::string::npos; at = id.find(sought, at + 1))
    found.push_back(places.at(countOf("{place}", id, at + words.size())));
  return found;
}

std::vector<Eigen::AlignedBox3d>
extentsOf(const Diagnostic& said)
{
  const std::string id = said.id(), extent = "from {place} to {place}";
  const std::vector<Eigen::Vector3d> places = said.places();
  std::vector<Eigen::AlignedBox3d> boxes;
  for (std::size_t at = id.find(extent); at != std::string::npos; at = id.find(extent, at + 1)) {
    const std::size_t first = countOf("{place}", id, at);
    boxes.emplace_back(places.at(first));
    boxes.back().extend(places.at(first + 1));
  }
  return boxes;
}

Prism
uprightPrism(const Eigen::AlignedBox3d& box)
{
  const Eigen::Vector3d low = box.min(), high = box.max();
  return Prism({low, {high.x(), low.y(), 0.0}, high, {low.x(), high.y(), 0.0}}, Eigen::Vector3d::UnitZ());
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
