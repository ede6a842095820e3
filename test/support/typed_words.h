// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A user who types what a message names, as it stands.
 */
#pragma once

#include <string>
#include <vector>

namespace pcl_spiral::test {

/** \p command after a \p change that a refusal names, such as "without --holes and --part-at 1,2,3": options are left out, replaced or
 *  added, each with the word behind it as its value; keep-outs are added to those that are given. */
std::vector<std::string> typedChange(std::vector<std::string> command, const std::string& change);

} // namespace pcl_spiral::test
