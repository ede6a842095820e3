// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether a stage of the path was given anything. Private.
 */
#pragma once

#include <pcl_spiral/common/status.h>

#include <cstddef>

namespace pcl_spiral {

/** Ok, or an error if \p what, of \p size points, is empty, as it is after a stage before has failed. */
inline Status
checkGiven(std::size_t size, const Diagnostic& what)
{
  if (size > 0)
    return Status::success();
  return {StatusCode::InvalidInput, Diagnostic(what, " is empty: look at the status of the stage that made it")};
}

} // namespace pcl_spiral
