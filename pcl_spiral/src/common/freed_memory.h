// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Memory that was freed, given back to the system.
 */
#pragma once

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pcl_spiral {

/** Call after much small working memory was freed: the C library keeps it otherwise, beside the large arrays that come
 *  next. Does nothing where the C library has no such call. */
inline void
returnFreedMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace pcl_spiral
