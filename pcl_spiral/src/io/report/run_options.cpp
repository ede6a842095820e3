// SPDX-License-Identifier: BSD-3-Clause
#include "run_options.h"

#include <nlohmann/json.hpp>

namespace pcl_spiral {

nlohmann::ordered_json
optionsJson(const RunOptions& options)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [name, value] : options)
    if (name == "output" || name == "keep-out" || name == "part-at" || name == "region") // these may be given several times
      json[name].push_back(value);
    else
      json[name] = value;
  return json;
}

} // namespace pcl_spiral
