// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Faults planted into the text of a good program.
 */
#pragma once

#include <pcl_spiral/io/program_writer.h>

#include <functional>
#include <string>
#include <vector>

namespace pcl_spiral::test {

/** An edit of the lines of a program, which a control must refuse. */
struct PlantedFault {
  std::string name;
  std::function<bool(std::vector<std::string>&)> plant; ///< false: the text has no place for it
  std::string words;                                    ///< of the refusal; empty: the program runs, but misses its path
};

/** Faults for a program of tool 3 at G54 (preset 1) with S12000 M3 and M8, under tool-tip control. */
std::vector<PlantedFault> plantedFaults(Dialect dialect, const std::string& rotary_letters);

/** \p text with the fault; Klartext gets its numbers anew. Empty: there is no place for it. */
std::string withFault(const std::string& text, Dialect dialect, const PlantedFault& fault);

} // namespace pcl_spiral::test
