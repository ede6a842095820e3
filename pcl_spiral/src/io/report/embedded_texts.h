// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Files that the build puts into the library (cmake/embedded_texts.cmake). Private to io.
 */
#pragma once

namespace pcl_spiral {

extern const char* const scene_markup;  ///< scene.html
extern const char* const scene_style;   ///< scene.css
extern const char* const scene_script;  ///< scene.js
extern const char* const three_licence; ///< three_licence.txt
extern const char* const three_script;  ///< three.min.js; empty: it was not there when the build was configured

} // namespace pcl_spiral
