// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Values of a machine file by name.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/io/file_error.h>

#include <Eigen/Core>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace pcl_spiral {

/** A map of a machine file: every value is read once; names that were not read are not settings. */
class YamlSettings {
public:
  YamlSettings(std::string file, const YAML::Node& node, std::string what) : file_(std::move(file)), node_(node), what_(std::move(what))
  {
    if (!node_.IsMap())
      fail(node_, Diagnostic(what_, " needs lines such as 'name: value'"));
  }

  [[noreturn]] void fail(const YAML::Node& node, const Diagnostic& reason) const
  {
    throw FileError(file_, Diagnostic("line ", node.Mark().line + 1, ": ", reason));
  }
  bool has(const std::string& name)
  {
    asked_.push_back(name);
    return static_cast<bool>(node_[name]);
  }
  /** \throw FileError if there is none */
  YAML::Node at(const std::string& name, const std::string& example)
  {
    if (!has(name))
      fail(node_, Diagnostic(what_, " has no ", name, "; give it, such as ", name, ": ", example));
    return node_[name];
  }
  template <typename Value>
  Value value(const std::string& name, const std::string& example)
  {
    const YAML::Node node = at(name, example);
    try {
      return node.as<Value>();
    }
    catch (const YAML::Exception&) {
      fail(node, Diagnostic(name, " of ", what_, " cannot be read; write it as ", name, ": ", example));
    }
  }
  double number(const std::string& name, const std::string& example)
  {
    const double number = value<double>(name, example);
    if (!std::isfinite(number))
      fail(node_[name], Diagnostic(name, " of ", what_, " is not finite; write it as ", name, ": ", example));
    return number;
  }
  Eigen::Vector3d vector(const std::string& name, const std::string& example)
  {
    const auto v = value<std::vector<double>>(name, example);
    if (v.size() != 3)
      fail(node_[name], Diagnostic(name, " of ", what_, " needs three numbers, such as ", name, ": ", example));
    return {v[0], v[1], v[2]};
  }
  const YAML::Node& node() const { return node_; }
  /** Call this last. */
  void refuseOthers() const
  {
    for (const auto& entry : node_) {
      const std::string name = entry.first.as<std::string>();
      if (std::find(asked_.begin(), asked_.end(), name) == asked_.end())
        fail(entry.first, Diagnostic("'", name, "' is not a setting of ", what_, "; its settings are ", listed()));
    }
  }

private:
  std::string listed() const
  {
    std::string list;
    for (const std::string& name : asked_)
      list += (list.empty() ? "" : ", ") + name;
    return list;
  }

  std::string file_;
  YAML::Node node_;
  std::string what_;
  std::vector<std::string> asked_;
};

} // namespace pcl_spiral
