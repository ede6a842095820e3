// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The scene of a page, with the script that shows it. Private to io.
 */
#pragma once

#include "embedded_texts.h"
#include "html_page.h"
#include "report_scene.h"

namespace pcl_spiral {

/** Adds \p scene with its notes; null: nothing. \p three: three.js; where it is empty, a sentence says that there are pictures alone. */
void addScene(const ReportScene* scene, HtmlPage& page, const char* three = three_script);

} // namespace pcl_spiral
