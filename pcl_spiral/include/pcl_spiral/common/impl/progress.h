/** \file
 *  Progress reports that can cancel.
 */
#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <utility>

namespace pcl_spiral {

/** Called with the share done, 0 to 1, and the stage's name. Return false to cancel. Called from one thread only. */
using ProgressCallback = std::function<bool(double share, const std::string& stage)>;

/** Whether a callback takes the share alone, and not the stage's name as well. */
template <typename Callback>
constexpr bool is_share_callback = std::is_invocable_r_v<bool, Callback&, double> &&
                                   !std::is_invocable_r_v<bool, Callback&, double, const std::string&>;

/** A callback of the share alone as a ProgressCallback; none where it is an empty std::function or a null pointer. */
template <typename ShareAlone>
ProgressCallback
withStage(ShareAlone callback)
{
  const std::function<bool(double)> function(std::move(callback));
  if (!function)
    return {};
  return [function](double share, const std::string&) { return function(share); };
}

/** Reports of a part of the work, which goes \p from one share of the whole \p to another; none where there is no callback. */
inline ProgressCallback
partOf(const ProgressCallback& whole, double from, double to)
{
  if (!whole)
    return {};
  return [whole, from, to](double share, const std::string& stage) { return whole(from + share * (to - from), stage); };
}

/** partOf with a \p stage of its own, for a function that tells its share alone. */
inline std::function<bool(double)>
partOf(const ProgressCallback& whole, double from, double to, const std::string& stage)
{
  if (!whole)
    return {};
  return [whole, from, to, stage](double share) { return whole(from + share * (to - from), stage); };
}

} // namespace pcl_spiral
