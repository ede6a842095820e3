// SPDX-License-Identifier: BSD-3-Clause
#include "errors.h"

#include <pybind11/stl.h>

#include <utility>

namespace pcl_spiral::python {

Words::Words(Vocabulary given, const ReadOptions& given_read) : vocabulary(std::move(given)), read(given_read)
{
  if (read.unit != LengthUnit::Millimetre || !read.origin.isZero())
    vocabulary.place = [given_read](const Eigen::Vector3d& place) { return placeText(shown(place, given_read)); };
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
