// SPDX-License-Identifier: BSD-3-Clause
#include "settings_json.h"

namespace pcl_spiral {
namespace {

using Json = nlohmann::ordered_json; // keeps the order of writing

struct JsonOf {
  Json operator()(const ChoiceTarget& choice) const
  {
    const std::string word = choice.get();
    return word.empty() ? Json() : Json(word);
  }
  Json operator()(const Eigen::Vector3d* place) const { return Json::array({place->x(), place->y(), place->z()}); }
  template <typename Value>
  Json operator()(const std::optional<Value>* value) const
  {
    return *value ? of(**value) : Json();
  }
  template <typename Value>
  Json operator()(const Value* value) const
  {
    return *value;
  }

private:
  Json of(double number) const { return number; }
  Json of(const Eigen::Vector3d& place) const { return (*this)(&place); }
};

} // namespace

Json
settingsJson(const std::vector<Setting>& settings)
{
  Json json;
  for (const Setting& setting : settings)
    json[setting.name] = std::visit(JsonOf(), setting.target);
  return json;
}

} // namespace pcl_spiral
