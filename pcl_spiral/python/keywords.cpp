// SPDX-License-Identifier: BSD-3-Clause
#include "keywords.h"

#include "core/nearest_name.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <limits>

namespace pcl_spiral::python {
namespace {

std::string
shown(const py::handle& value)
{
  constexpr std::size_t most = 60;
  const std::string text = py::str(py::repr(value));
  return text.size() > most ? text.substr(0, most) + "..." : text;
}

[[noreturn]] void
refuse(const std::string& name, const py::handle& value, const Diagnostic& rule)
{
  raiseType(Diagnostic(name, "=", shown(value), ": ", rule));
}

/** Sets the variable of a setting. */
struct TakeValue {
  const std::string& name;
  const Setting& setting;
  const py::handle& value;
  const Words& words;

  void operator()(bool* target) const
  {
    static const py::object numpy_bool = py::module_::import("numpy").attr("bool_");
    if (!py::isinstance<py::bool_>(value) && !py::isinstance(value, numpy_bool))
      refuse(name, value, "must be True or False");
    *target = value.cast<bool>();
  }
  void operator()(int* target) const { *target = whole<int>(std::numeric_limits<int>::min()); }
  void operator()(unsigned int* target) const { *target = whole<unsigned int>(0); }
  void operator()(double* target) const { *target = numberFrom(name, value, ruleOf(setting)); }
  void operator()(std::optional<double>* target) const
  {
    if (value.is_none())
      target->reset();
    else
      *target = numberFrom(name, value, ruleOf(setting));
  }
  void operator()(Eigen::Vector3d* target) const { *target = placeFrom(name, value); }
  void operator()(std::optional<Eigen::Vector3d>* target) const
  {
    if (value.is_none())
      target->reset();
    else
      *target = placeFrom(name, value);
  }
  void operator()(const ChoiceTarget& target) const
  {
    if (!py::isinstance<py::str>(value))
      refuse(name, value, Diagnostic("must be one of ", target.words));
    if (!target.take(value.cast<std::string>()))
      raise("invalid-argument", Diagnostic(name, "=", shown(value), ": must be one of ", target.words), words);
  }

private:
  template <typename Integer>
  Integer whole(long long least) const
  {
    int overflow = 0;
    const long long number = PyIndex_Check(value.ptr()) != 0 && !py::isinstance<py::bool_>(value)
                                 ? PyLong_AsLongLongAndOverflow(py::int_(py::reinterpret_borrow<py::object>(value)).ptr(), &overflow)
                                 : (refuse(name, value, Diagnostic(ruleOf(setting), "; a whole number")), 0);
    if (overflow != 0 || number < least || number > static_cast<long long>(std::numeric_limits<Integer>::max()))
      raise("invalid-argument", Diagnostic(name, "=", shown(value), ": it ", ruleOf(setting)), words);
    return static_cast<Integer>(number);
  }
};

/** What a type checker is told: "float", "Literal['auto', 'one']". */
std::string
typeOf(const Setting& setting)
{
  if (std::holds_alternative<bool*>(setting.target))
    return "bool";
  if (std::holds_alternative<int*>(setting.target) || std::holds_alternative<unsigned int*>(setting.target))
    return "int";
  if (std::holds_alternative<double*>(setting.target))
    return "float";
  if (std::holds_alternative<std::optional<double>*>(setting.target))
    return "float | None";
  const auto* choice = std::get_if<ChoiceTarget>(&setting.target);
  if (!choice)
    return std::holds_alternative<Eigen::Vector3d*>(setting.target) ? "Place" : "Place | None";
  std::string type = "Literal['" + choice->words + "']";
  for (std::size_t at = type.find('|'); at != std::string::npos; at = type.find('|', at + 4))
    type.replace(at, 1, "', '");
  return choice->get().empty() ? type + " | None" : type;
}

/** The value as it is typed in Python. */
struct DefaultOf {
  py::object operator()(bool* value) const { return py::bool_(*value); }
  py::object operator()(int* value) const { return py::int_(*value); }
  py::object operator()(unsigned int* value) const { return py::int_(*value); }
  py::object operator()(double* value) const { return py::float_(*value); }
  py::object operator()(std::optional<double>* value) const { return *value ? py::object(py::float_(**value)) : py::none(); }
  py::object operator()(Eigen::Vector3d* v) const { return py::make_tuple(v->x(), v->y(), v->z()); }
  py::object operator()(std::optional<Eigen::Vector3d>* value) const { return *value ? (*this)(&**value) : py::none(); }
  py::object operator()(const ChoiceTarget& value) const { return value.get().empty() ? py::object(py::none()) : py::str(value.get()); }
};

bool
isRequired(const Setting& setting)
{
  const std::optional<double> number = numberOf(setting);
  return number && !setting.range.takes(*number);
}

} // namespace

double
numberFrom(const std::string& name, const py::handle& value, const Diagnostic& rule)
{
  const double number = py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value) ? -1.0 : PyFloat_AsDouble(value.ptr());
  if (py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value) || PyErr_Occurred()) {
    PyErr_Clear();
    refuse(name, value, rule);
  }
  return number;
}

Eigen::Vector3d
placeFrom(const std::string& name, const py::handle& value)
{
  const bool is_sequence = py::isinstance<py::sequence>(value) || py::isinstance<py::array>(value);
  if (!is_sequence || py::isinstance<py::str>(value) || py::len(value) != 3)
    refuse(name, value, "must be three numbers, such as (0, 0, 1)");
  Eigen::Vector3d place;
  for (int i = 0; i < 3; ++i)
    place[i] = numberFrom(name, value[py::int_(i)], "must be three numbers, such as (0, 0, 1)");
  return place;
}

std::vector<Setting>
without(std::vector<Setting> table, const std::set<std::string>& names)
{
  table.erase(std::remove_if(table.begin(), table.end(), [&](const Setting& setting) { return names.count(setting.name) > 0; }),
              table.end());
  return table;
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
    std::visit(TakeValue{name, setting, value, words}, setting.target);
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
  return vocabulary;
}

py::list
Keywords::table() const
{
  py::list table;
  std::set<std::string> seen;
  for (const Input& input : inputs_)
    table.append(py::dict(py::arg("name") = input.name, py::arg("type") = input.type, py::arg("help") = input.help));
  for (const Setting& s : settings_)
    if (seen.insert(s.name).second)
      table.append(py::dict(py::arg("name") = s.name, py::arg("type") = typeOf(s), py::arg("help") = s.help, py::arg("unit") = s.unit,
                            py::arg("default") = std::visit(DefaultOf{}, s.target), py::arg("required") = isRequired(s),
                            py::arg("zero") = s.zero, py::arg("example") = s.example,
                            py::arg("rule") = numberOf(s) || typeOf(s) == "float | None" ? ruleOf(s).text() : std::string(),
                            py::arg("least") = s.range.least, py::arg("takes_least") = s.range.takes_least, py::arg("most") = s.range.most,
                            py::arg("takes_most") = s.range.takes_most));
  return table;
}

} // namespace pcl_spiral::python
