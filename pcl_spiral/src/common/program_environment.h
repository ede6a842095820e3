// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  How the programs run.
 */
#pragma once

#include <cstdlib>
#include <string>

namespace pcl_spiral {

/** Sets what the OpenMP and C libraries of a program that is started next read before its main, where the user did not. Threads that have
 *  nothing to do sleep: spinning, they hold up those with work where other programs run. Large arrays get large pages where the system has
 *  them: on a virtual machine, providing small ones took up to a third of the time. \return whether something was set. */
inline bool
setProgramEnvironment()
{
  const char* const tunables = "GLIBC_TUNABLES";
  const std::string ours = "glibc.malloc.hugetlb", given = std::getenv(tunables) ? std::getenv(tunables) : "";
  bool set = false;
  if (!std::getenv("OMP_WAIT_POLICY") && !std::getenv("GOMP_SPINCOUNT"))
    set = setenv("OMP_WAIT_POLICY", "passive", 1) == 0;
  if (given.find(ours) == std::string::npos)
    set = setenv(tunables, (ours + "=1" + (given.empty() ? "" : ":") + given).c_str(), 1) == 0 || set;
  return set;
}

} // namespace pcl_spiral
