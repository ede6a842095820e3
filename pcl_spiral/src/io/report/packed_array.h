// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Arrays of numbers for the script of a page: little-endian, as base64. Private to io.
 */
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_spiral {

/** Numbers as they are. \p type: the name that the script knows, such as "u32". */
template <typename Number>
nlohmann::ordered_json packedNumbers(const char* type, const std::vector<Number>& numbers);

/** Values of \p size components each in 16 bits: value = low + step * number for each component; NaN has the number "none". The error is at
 *  most half a step, the range of the component / 131068. */
nlohmann::ordered_json packedValues(const std::vector<double>& values, std::size_t size);

} // namespace pcl_spiral
