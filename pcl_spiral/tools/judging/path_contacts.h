// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Contacts for paths of tips and axes.
 */
#pragma once

#include <pcl_spiral/core/cutter_profile.h>
#include <pcl_spiral/io/toolpath_reader.h>
#include <pcl_spiral/verify/impl/reference_surface.h>

/** Gives \p file the contacts of \p cutter with the surface, and arc lengths along them; where there is no surface, the tip stays and the
 *  axis is the normal. */
void findContacts(const pcl_spiral::ReferenceSurface& reference, const pcl_spiral::CutterShape& cutter, pcl_spiral::ToolpathFile& file);
