// SPDX-License-Identifier: BSD-3-Clause
#include "errors.h"

#include "common/formatted_text.h"
#include "core/given_together.h"

#include <pybind11/stl.h>

#include <utility>
#include <variant>

namespace pcl_spiral::python {
namespace {

/** The value as Python has it; a box as the only polygon of a list. */
std::string
pythonText(const Proposed::Value& value, const ReadOptions& read)
{
  if (const auto* word = std::get_if<std::string>(&value))
    return "'" + *word + "'";
  if (const auto* place = std::get_if<Eigen::Vector3d>(&value))
    return placeText(shown(*place, read));
  if (const auto* box = std::get_if<Extents>(&value)) {
    const Eigen::Vector3d a = shown(box->low, read), b = shown(box->high, read);
    return formatted("[[(%.12g, %.12g), (%.12g, %.12g), (%.12g, %.12g), (%.12g, %.12g)]]", a.x(), a.y(), b.x(), a.y(), b.x(), b.y(), a.x(),
                     b.y());
  }
  return Diagnostic(std::get<double>(value)).text();
}

} // namespace

Words::Words(Vocabulary given, const ReadOptions& given_read) : vocabulary(std::move(given)), read(given_read)
{
  if (read.unit != LengthUnit::Millimetre || !read.origin.isZero())
    vocabulary.place = [given_read](const Eigen::Vector3d& place) { return placeText(shown(place, given_read)); };
  vocabulary.words.insert({{between_settings, ", "}, {betweenValues("addKeepOut"), " + "}}); // a keyword is given once
  vocabulary.given = [given_read](const Proposed::Value& value) { return pythonText(value, given_read); };
}

void
raise(const std::string& code, const Diagnostic& diagnostic, const Words& words, const std::vector<std::string>& names)
{
  py::list places, settings = py::cast(names);
  for (const Eigen::Vector3d& place : diagnostic.places()) {
    const Eigen::Vector3d p = shown(place, words.read);
    places.append(py::make_tuple(p.x(), p.y(), p.z()));
  }
  for (const std::string& setter : diagnostic.settings()) // names of C++ for which there is no keyword are left out
    if (const auto found = words.vocabulary.words.find(setter); found != words.vocabulary.words.end()) {
      const std::string& word = found->second; // "scallop=", "clusters='ride'", "without center=", or "points"
      const std::string name = word.substr(0, word.find('='));
      const py::str keyword(name.substr(name.rfind(' ') + 1));
      if ((name.size() < word.size() || name == "points") && !settings.contains(keyword))
        settings.append(keyword);
    }
  const py::object type = py::module_::import("pcl_spiral._results").attr("Error");
  const py::object error = type(words.text(diagnostic), diagnostic.id(), code, py::tuple(places), py::tuple(settings));
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

void
require(const Status& status, const Words& words)
{
  constexpr const char* codes[] = {"failed", "", "invalid-argument", "invalid-input", "failed", "cancelled"};
  if (!status.ok())
    raise(codes[static_cast<std::size_t>(status.code())], status.diagnostic(), words);
}

void
raiseType(const Diagnostic& diagnostic, const Words& words)
{
  throw py::type_error(words.text(diagnostic));
}

} // namespace pcl_spiral::python
