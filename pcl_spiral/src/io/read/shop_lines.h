// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Lines and words of a shop in a machine file.
 */
#pragma once

#include <pcl_spiral/machine/machine.h>

#include <yaml-cpp/yaml.h>

#include <string>

namespace pcl_spiral {

/** Reads the map `program` of a machine file. \throw FileError with the line and what is wrong */
void readProgramWords(const std::string& file, const YAML::Node& node, Machine& machine);

} // namespace pcl_spiral
