// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How the programs run.
 */
#pragma once

#include <cstdlib>
#include <string>

namespace pcl_spiral {

/** Whether the environment says how threads wait. */
inline bool
isWaitPolicyGiven()
{
  return std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT");
}

/** Sets what the OpenMP and C libraries of a program that is started next read before its main. Threads that have nothing to do sleep:
 *  spinning, they hold up those with work where other programs run. Large arrays get large pages where the system has them: on a virtual
 *  machine, providing small ones took a quarter of the time. \return false if it cannot be set. */
inline bool
setProgramEnvironment()
{
  const char* const tunables = "GLIBC_TUNABLES";
  const char* const given = std::getenv(tunables);
  const std::string all = (given ? given + std::string(":") : std::string()) + "glibc.malloc.hugetlb=1";
  return setenv("OMP_WAIT_POLICY", "passive", 1) == 0 && setenv(tunables, all.c_str(), 1) == 0;
}

} // namespace pcl_spiral
