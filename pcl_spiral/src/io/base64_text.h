// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Bytes as text. Private to io.
 */
#pragma once

#include <cstddef>
#include <string>

namespace pcl_spiral {

/** \p size bytes at \p data as base64. */
std::string base64(const void* data, std::size_t size);

} // namespace pcl_spiral
