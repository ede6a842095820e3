// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Keywords of a call, made from tables of settings.
 */
#pragma once

#include "errors.h"

#include <pcl_spiral/core/setting.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pcl_spiral::python {

/** A keyword that is not a single value of a table: an array, a file, a function. */
struct Input {
  std::string name;                 ///< the keyword
  std::string type;                 ///< for type checkers
  std::string help;                 ///< what it is
  std::vector<std::string> setters; ///< its names in C++
};

/** The keywords of one call. Its settings are variables that must outlive it. */
class Keywords {
public:
  /** A name that is in several tables sets all of them; its help is that of the first. */
  Keywords(std::string function, std::vector<Setting> settings, std::vector<Input> inputs)
  : function_(std::move(function)), settings_(std::move(settings)), inputs_(std::move(inputs))
  {}
  Keywords(const Keywords&) = delete;

  /** Sets the variables of the settings. Raises for a name that is none, with the nearest one, and for a value that a setting does not
   *  take. */
  void take(const py::dict& given);

  /** Takes the places among the settings out of the coordinates of the user. */
  void readPlaces(const ReadOptions& read);

  /** The names that were given. */
  std::set<std::string> asked() const;
  bool isGiven(const std::string& name) const { return given_.contains(name) && !given_[name.c_str()].is_none(); }
  /** The value of an input; None if it is not given. */
  py::object operator[](const std::string& name) const { return isGiven(name) ? py::object(given_[name.c_str()]) : py::none(); }

  /** The entries of an input that is a sequence; none if it is not given. */
  py::list list(const std::string& name) const { return isGiven(name) ? py::list((*this)[name]) : py::list(); }

  /** Names of C++ as keywords. */
  Vocabulary vocabulary() const;

  /** Adds for this call one dict for each keyword, with all that is shown of it, and the words that it has for names of C++. */
  void addTo(py::dict& tables) const;

private:
  std::vector<std::string> names() const;
  void set(const std::string& name, const py::handle& value);

  std::string function_;
  std::vector<Setting> settings_;
  std::vector<Input> inputs_;
  py::dict given_;
};

/** The settings of \p table with one of these \p names; the others if \p are_kept is false. */
std::vector<Setting> only(const std::vector<Setting>& table, const std::set<std::string>& names, bool are_kept = true);

/** Three numbers. */
Eigen::Vector3d placeFrom(const py::handle& value);
/** The same in the coordinates of the cloud. */
inline Eigen::Vector3d
placeFrom(const py::handle& value, const ReadOptions& read)
{
  return millimetres(read.unit) * (placeFrom(value) - read.origin);
}

/** The values of \p settings by their names. */
py::dict valuesOf(const std::vector<Setting>& settings);

} // namespace pcl_spiral::python
