/** \file
 *  Progress reports that can cancel.
 */
#pragma once

#include <functional>
#include <string>

namespace pcl_spiral {

/** Called with the share done, 0 to 1, and the stage's name. Return false to cancel. Called from one thread only. */
using ProgressCallback = std::function<bool(double share, const std::string& stage)>;

} // namespace pcl_spiral
