// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The figures of a toolpath as a JSON object. Private to io.
 */
#pragma once

#include <pcl_spiral/verify/verification.h>

#include <nlohmann/json.hpp>

namespace pcl_spiral {

/** The figures of figuresOf in their order, then limits, time and warnings, in \p words; \p shift: see diagnosticsJson. */
nlohmann::ordered_json verificationJson(const Verification& verification, const Vocabulary& words, const Eigen::Vector3d& shift);

} // namespace pcl_spiral
