// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Settings that a sentence gives together (Given), as each face takes them.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include <string>

namespace pcl_spiral {

/** The field between two settings, and what C++ shows for it. A face has its own in Vocabulary::words, such as a space. */
inline const std::string between_settings = " and ";

/** What Vocabulary::words may have for a \p setting that takes a list: what is shown before its first value, "keep_outs=", with what the
 *  list has already; and what is shown between two values, " + ". Without them each value has the name of the setting before it.
 *  @{ */
inline std::string
beforeValues(const std::string& setting)
{
  return setting + ' ';
}
inline std::string
betweenValues(const std::string& setting)
{
  return between_settings + setting;
}
/** @} */

/** Both; of one of them that is empty the other. */
inline Diagnostic
givenTogether(const Diagnostic& first, const Diagnostic& second)
{
  return first.empty() || second.empty() ? first + second : Diagnostic(first, "{ and }", second);
}

} // namespace pcl_spiral
