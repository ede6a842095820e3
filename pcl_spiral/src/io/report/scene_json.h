// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A scene as data for the script of a page. Private to io.
 */
#pragma once

#include "report_scene.h"

#include <string>

namespace pcl_spiral {

/** JSON that stands in HTML as it is: it has no < and no &. */
std::string sceneJson(const ReportScene& scene);

} // namespace pcl_spiral
