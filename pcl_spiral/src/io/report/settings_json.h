// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Settings for JSON reports.
 */
#pragma once

#include <pcl_spiral/core/setting.h>

#include <nlohmann/json.hpp>

#include <utility>

namespace pcl_spiral {

/** Each by its name: a number, a word, true or false, a place as three numbers, or null for one that is not set. */
nlohmann::ordered_json settingsJson(const std::vector<Setting>& settings);

/** The same for an object that has a table. */
template <typename Settings>
nlohmann::ordered_json
settingsJson(Settings settings)
{
  return settingsJson(settingTable(settings));
}

} // namespace pcl_spiral
