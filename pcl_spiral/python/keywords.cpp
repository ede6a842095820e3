// SPDX-License-Identifier: BSD-3-Clause
#include "keywords.h"

#include "core/nearest_name.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <variant>

namespace pcl_spiral::python {
namespace {

/** Sets the variable of a setting to a value of its kind, as _inputs.py gives it. */
struct TakeValue {
  const Setting& setting;
  const py::handle& value;
  const Words& words;

  void operator()(bool* target) const { *target = value.cast<bool>(); }
  void operator()(int* target) const { *target = whole<int>(); }
  void operator()(unsigned int* target) const { *target = whole<unsigned int>(); }
  void operator()(double* target) const { *target = value.cast<double>(); }
  void operator()(std::optional<double>* target) const { *target = value.cast<std::optional<double>>(); }
  void operator()(Eigen::Vector3d* target) const { *target = placeFrom(value); }
  void operator()(std::optional<Eigen::Vector3d>* target) const
  {
    *target = value.is_none() ? std::nullopt : std::optional(placeFrom(value));
  }
  void operator()(const ChoiceTarget& target) const
  {
    if (!value.is_none() && !target.take(value.cast<std::string>()))
      refuse(Diagnostic("must be one of ", target.words));
  }

private:
  [[noreturn]] void refuse(const Diagnostic& rule) const
  {
    raise("invalid-argument", Diagnostic(setting.name, "=", std::string(py::str(py::repr(value))), ": it ", rule), words, {setting.name});
  }

  template <typename Integer>
  Integer whole() const
  {
    try {
      return value.cast<Integer>();
    }
    catch (const py::cast_error&) {
      refuse(ruleOf(setting));
    }
  }
};

/** The value of a setting. */
struct GiveValue {
  template <typename Value>
  py::object operator()(Value* value) const
  {
    return py::cast(*value);
  }
  py::object operator()(Eigen::Vector3d* place) const { return py::make_tuple(place->x(), place->y(), place->z()); }
  py::object operator()(std::optional<Eigen::Vector3d>* place) const { return *place ? (*this)(&**place) : py::none(); }
  py::object operator()(const ChoiceTarget& target) const { return py::str(target.get()); }
};

/** Whether it is in the coordinates of the points; others are directions, and the origin. */
bool
isPlace(const Setting& setting)
{
  static const std::set<std::string> places{"part_at", "view_point", "center", "start", "column_centre"};
  return places.count(setting.name) > 0;
}

/** What the variable of a setting is, by the place of its type in Setting::Target. */
constexpr const char* kinds[] = {"bool", "int", "int", "float", "Place", "float | None", "Place | None", "Literal"};
static_assert(std::size(kinds) == std::variant_size_v<Setting::Target>);

/** What the library calls a setting that has another name in its table too, and what is shown of it; empty: the keyword. */
struct OtherName {
  const char* name;
  const char* keyword;
  const char* shown = "";
};
constexpr OtherName other_names[] = {{"setInputMesh", "faces"},
                                     {"readCloud", "faces", "leave faces= out"},
                                     {"Scale it to mm", "unit", "Give its unit=, or scale it to mm"},
                                     {"ReadOptions::find_origin", "origin", "without origin="},
                                     {"MeshSettings::crease_angle", "crease_angle"},
                                     {"clearCenter", "center", "without center="},
                                     {"DriveCylinder::axis", "column_axis"},
                                     {"setPlaneNormal", "direction"},
                                     {"setCeiling", "ceiling"},
                                     {"setMaxRetilt", "max_retilt"},
                                     {"setRetiltStep", "retilt_step"},
                                     {"PassSettings::cutter", "tool_radius"},
                                     {"RidgeRowSettings::stand_off", "stand_off"},
                                     {"RidgeRowSettings::step_over", "step_over"},
                                     {"RidgeRowSettings::overlap", "overlap"},
                                     {"RidgeRowSettings::tool_radius", "scallop"},
                                     {"RidgeRowSettings::tilt", "tilt"},
                                     {"RidgeSettings::measuring_error", "measuring_error"},
                                     {"setSpacing", "sample_spacing"},
                                     {"setClusterHandling(ClusterHandling::LeaveOut)", "clusters", "clusters='leave-out'"},
                                     {"setClusterHandling(ClusterHandling::Ride)", "clusters", "clusters='ride'"},
                                     {"setBallClosing(true)", "ball_closing", "ball_closing=True"},
                                     {"setLargestPart(true)", "largest", "largest=True"},
                                     {"setTightHandling(TightHandling::Refuse)", "tight", "tight='refuse'"}};

} // namespace

Eigen::Vector3d
placeFrom(const py::handle& value)
{
  const auto numbers = value.cast<std::array<double, 3>>();
  return {numbers[0], numbers[1], numbers[2]};
}

std::vector<Setting>
only(const std::vector<Setting>& table, const std::set<std::string>& names, bool are_kept)
{
  std::vector<Setting> kept;
  std::copy_if(table.begin(), table.end(), std::back_inserter(kept),
               [&](const Setting& setting) { return (names.count(setting.name) > 0) == are_kept; });
  return kept;
}

py::dict
valuesOf(const std::vector<Setting>& settings)
{
  py::dict values;
  for (const Setting& setting : settings)
    values[setting.name.c_str()] = std::visit(GiveValue(), setting.target);
  return values;
}

void
Keywords::readPlaces(const ReadOptions& read)
{
  for (const Setting& setting : settings_)
    if (auto* const* place = std::get_if<std::optional<Eigen::Vector3d>*>(&setting.target); place && **place && isPlace(setting))
      **place = millimetres(read.unit) * (***place - read.origin);
}

std::set<std::string>
Keywords::asked() const
{
  std::set<std::string> names;
  for (const auto& [name, value] : given_)
    if (!value.is_none())
      names.insert(py::str(name));
  return names;
}

std::vector<std::string>
Keywords::names() const
{
  std::vector<std::string> names;
  for (const Setting& setting : settings_)
    names.push_back(setting.name);
  for (const Input& input : inputs_)
    names.push_back(input.name);
  return names;
}

void
Keywords::set(const std::string& name, const py::handle& value)
{
  Words words{vocabulary()};
  for (const Setting& setting : settings_) {
    if (setting.name != name)
      continue;
    words.vocabulary.words[setting.setter] = name + "="; // several may share a setter
    std::visit(TakeValue{setting, value, words}, setting.target);
    if (const Diagnostic fault = faultOf(std::vector<Setting>{setting}); !fault.empty())
      raise("invalid-argument", fault, words);
  }
}

void
Keywords::take(const py::dict& given)
{
  given_ = given;
  const std::vector<std::string> known = names();
  for (const auto& [key, value] : given) {
    const std::string name = py::str(key);
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      const std::string nearest = nearestName(name, known);
      raiseType(Diagnostic(function_, "() has no keyword '", name, "'",
                           nearest.empty() ? Diagnostic("; help(pcl_spiral." + function_ + ") lists them")
                                           : Diagnostic("; did you mean '", nearest, "'?")));
    }
    set(name, value);
  }
}

Vocabulary
Keywords::vocabulary() const
{
  Vocabulary vocabulary;
  vocabulary.has_setters = false;
  for (const Input& input : inputs_)
    for (const std::string& setter : input.setters)
      vocabulary.words[setter] = input.name + "=";
  for (const Setting& setting : settings_)
    vocabulary.words.emplace(setting.setter, setting.name + "=");
  const std::vector<std::string> known = names();
  for (const OtherName& other : other_names)
    if (std::find(known.begin(), known.end(), other.keyword) != known.end())
      vocabulary.words.emplace(other.name, *other.shown != 0 ? other.shown : std::string(other.keyword) + "=");
  vocabulary.words.insert({{"setInputCloud", "points"}, {"ScannedSurface", "scan"}});
  return vocabulary;
}

void
Keywords::addTo(py::dict& tables) const
{
  py::list table;
  std::set<std::string> seen;
  for (const Input& input : inputs_)
    table.append(py::dict(py::arg("name") = input.name, py::arg("type") = input.type, py::arg("help") = input.help));
  for (const Setting& s : settings_) {
    if (!seen.insert(s.name).second)
      continue;
    const auto* choice = std::get_if<ChoiceTarget>(&s.target);
    table.append(py::dict(py::arg("name") = s.name, py::arg("type") = kinds[s.target.index()], py::arg("help") = s.help,
                          py::arg("unit") = s.unit, py::arg("text") = textOf(s), py::arg("words") = choice ? choice->words : "",
                          py::arg("zero") = s.zero, py::arg("example") = s.example, py::arg("rule") = ruleOf(s).text(),
                          py::arg("least") = s.range.least, py::arg("takes_least") = s.range.takes_least, py::arg("most") = s.range.most,
                          py::arg("takes_most") = s.range.takes_most));
  }
  tables[function_.c_str()] = py::make_tuple(table, vocabulary().words);
}

} // namespace pcl_spiral::python
