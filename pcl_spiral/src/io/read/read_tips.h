// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Reader of text files with tips and axes only.
 */
#pragma once

#include <pcl_spiral/io/toolpath_reader.h>

#include <string>
#include <string_view>

namespace pcl_spiral {

/** Whether the first line of a text that is not a comment names tips or x y z, and no contacts. */
bool holdsOnlyTips(std::string_view bytes);

/** Reads them; see readToolpath. \throw FileError */
ToolpathFile readTips(const std::string& file, const Eigen::Vector3d& origin);

} // namespace pcl_spiral
