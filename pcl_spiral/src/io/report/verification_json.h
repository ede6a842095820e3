// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  A toolpath's figures as a JSON object, for the reports. Private to io.
 */
#pragma once

#include "verification_writer.h"

#include <nlohmann/json.hpp>

namespace pcl_spiral {

/** Keys in the order of writing. */
nlohmann::ordered_json verificationJson(const Verification& verification);

} // namespace pcl_spiral
