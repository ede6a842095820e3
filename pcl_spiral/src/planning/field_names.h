// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Settings in the names that a user of a planner knows: stages name their own setters, planners have members of settings instead.
 */
#pragma once

#include <pcl_spiral/common/status.h>

#include <map>
#include <string>

namespace pcl_spiral {

using FieldNames = std::map<std::string, std::string>; ///< a field of a diagnostic, and what is said instead

/** Setters of CutterLocation: members of PassSettings. */
extern const FieldNames location_names;
/** Setters of RidgeToolpath and RidgeLines: members of RidgeSettings and RidgeRowSettings. */
extern const FieldNames ridge_names;
/** Setters of the cutter and its holder: members of PassSettings, for planners without these setters. */
extern const FieldNames tool_names;

inline Status
renamed(const Status& status, const FieldNames& names)
{
  return {status.code(), status.diagnostic().renamed(names)};
}

/** Adds \p more to \p warnings. */
inline void
addRenamed(const Diagnostics& more, const FieldNames& names, Diagnostics& warnings)
{
  for (const Diagnostic& warning : more)
    warnings.push_back(warning.renamed(names));
}

} // namespace pcl_spiral
