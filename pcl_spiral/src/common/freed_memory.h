// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Gives freed memory back to the system.
 */
#pragma once

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pcl_spiral {

/** Call after much small working memory was freed. Otherwise the C library keeps it beside the large arrays that come
 *  next. Does nothing if the C library has no such call. */
inline void
returnFreedMemory()
{
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

} // namespace pcl_spiral
