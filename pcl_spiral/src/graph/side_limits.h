// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Limits of the outer side that several places use. Private.
 */
#pragma once

namespace pcl_spiral {

/** Area-weighted mean cosine between the normals and +z from which on +z decides the outer side, see chooseOuterSide; below minus this the
 *  side faces away from +z. */
constexpr double clear_z = 0.1;

} // namespace pcl_spiral
