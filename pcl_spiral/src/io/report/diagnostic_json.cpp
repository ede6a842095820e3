// SPDX-License-Identifier: BSD-3-Clause
#include "diagnostic_json.h"

namespace pcl_spiral {

nlohmann::ordered_json
diagnosticsJson(const Diagnostics& diagnostics, const Vocabulary& words, const Eigen::Vector3d& shift)
{
  using Json = nlohmann::ordered_json;
  Json all = Json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    Json places = Json::array(), directions = Json::array();
    for (const Eigen::Vector3d& place : diagnostic.places())
      places.push_back({place.x() + shift.x(), place.y() + shift.y(), place.z() + shift.z()});
    for (const Eigen::Vector3d& direction : diagnostic.directions())
      directions.push_back({direction.x(), direction.y(), direction.z()});
    all.push_back({{"id", diagnostic.id()},
                   {"text", diagnostic.text(words)},
                   {"places", places},
                   {"directions", directions},
                   {"numbers", diagnostic.numbers()},
                   {"names", diagnostic.names()},
                   {"settings", diagnostic.settings()}});
  }
  return all;
}

} // namespace pcl_spiral
