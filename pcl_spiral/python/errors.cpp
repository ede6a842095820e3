// SPDX-License-Identifier: BSD-3-Clause
#include "errors.h"

namespace pcl_spiral::python {
namespace {

py::tuple
placesOf(const Diagnostic& diagnostic, const Eigen::Vector3d& shift)
{
  py::list places;
  for (const Eigen::Vector3d& place : diagnostic.places())
    places.append(py::make_tuple(place.x() + shift.x(), place.y() + shift.y(), place.z() + shift.z()));
  return py::tuple(places);
}

/** The keywords for the settings that are named; names of C++ for which there is none are left out. */
py::tuple
settingsOf(const Diagnostic& diagnostic, const Vocabulary& vocabulary)
{
  py::list names;
  for (const std::string& setter : diagnostic.settings())
    if (const auto found = vocabulary.words.find(setter); found != vocabulary.words.end()) {
      const std::string& word = found->second;
      names.append(word.substr(0, word.find('=')));
    }
  return py::tuple(names);
}

std::string
codeOf(StatusCode code)
{
  switch (code) {
  case StatusCode::InvalidArgument:
    return "invalid-argument";
  case StatusCode::InvalidInput:
    return "invalid-input";
  case StatusCode::Cancelled:
    return "cancelled";
  default:
    return "failed";
  }
}

} // namespace

void
raise(const std::string& code, const Diagnostic& diagnostic, const Words& words)
{
  const py::object type = py::module_::import("pcl_spiral._results").attr("Error");
  const py::object error =
      type(words.text(diagnostic), diagnostic.id(), code, placesOf(diagnostic, words.shift), settingsOf(diagnostic, words.vocabulary));
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

void
require(const Status& status, const Words& words)
{
  if (!status.ok())
    raise(codeOf(status.code()), status.diagnostic(), words);
}

void
raiseType(const Diagnostic& diagnostic, const Words& words)
{
  throw py::type_error(words.text(diagnostic));
}

} // namespace pcl_spiral::python
