// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The time of a program in reports. Private to io.
 */
#pragma once

#include "html_page.h"
#include <pcl_spiral/machine/motion_time.h>

#include <nlohmann/json.hpp>

namespace pcl_spiral {

/** Time, losses and gains, s; null if the time is not known. */
nlohmann::ordered_json motionJson(const MotionStudy& study);

/** The same as rows of a table; none if the time is not known. */
HtmlRows motionRows(const MotionStudy& study);

} // namespace pcl_spiral
