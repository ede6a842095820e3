// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Progress callbacks, which can cancel.
 */
#pragma once

#include <functional>
#include <pcl_spiral/common/status.h>
#include <string>
#include <type_traits>
#include <utility>

namespace pcl_spiral {

/** True if a callback takes only the share and not the name of the stage. */
template <typename Callback>
constexpr bool is_share_callback =
    std::is_invocable_r_v<bool, Callback&, double> && !std::is_invocable_r_v<bool, Callback&, double, const std::string&>;

/** Converts a callback of the share only to a ProgressCallback; an empty std::function or a null pointer gives none. */
template <typename ShareAlone>
ProgressCallback
withStage(ShareAlone callback)
{
  const std::function<bool(double)> function(std::move(callback));
  if (!function)
    return {};
  return [function](double share, const std::string&) { return function(share); };
}

/** Progress of a part of the work, mapped to the shares \p from to \p to of the whole; empty if there is no callback. */
inline ProgressCallback
partOf(const ProgressCallback& whole, double from, double to)
{
  if (!whole)
    return {};
  return [whole, from, to](double share, const std::string& stage) { return whole(from + share * (to - from), stage); };
}

/** partOf with a fixed \p stage name, for a function that reports only its share. */
inline std::function<bool(double)>
partOf(const ProgressCallback& whole, double from, double to, const std::string& stage)
{
  if (!whole)
    return {};
  return [whole, from, to, stage](double share) { return whole(from + share * (to - from), stage); };
}

} // namespace pcl_spiral
