// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Time of the shortest block that a control can run.
 */
#pragma once

#include <pcl_spiral/io/program_writer.h>

namespace pcl_spiral::test {

/** Minutes; Fanuc reads F up to 9999.999 1/min with G93. */
inline double
shortestBlock(Dialect dialect)
{
  return dialect == Dialect::Fanuc || dialect == Dialect::FanucVectors ? 1.0 / 9999.999 : 0.0;
}

} // namespace pcl_spiral::test
