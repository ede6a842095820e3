// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A user who types what a message names, as it stands.
 */
#pragma once

#include <string>
#include <vector>

namespace pcl_spiral::test {

/** \p command after a \p change that a refusal names, such as "--part-at 1,2,3 --sense cw, without --holes": what is in front of the first
 *  comma is pasted behind it as it stands, once options that it replaces and those behind "without" are taken out. */
std::vector<std::string> typedChange(std::vector<std::string> command, const std::string& change);

} // namespace pcl_spiral::test
