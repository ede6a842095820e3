/** \file
 *  Progress reports that can cancel.
 */
#pragma once

#include <functional>
#include <string>

namespace pcl_spiral {

/** Called with the share done, 0 to 1, and the stage's name. Return false to cancel. Called from one thread only. */
using ProgressCallback = std::function<bool(double share, const std::string& stage)>;

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
