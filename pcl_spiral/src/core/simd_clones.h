// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Hot loops compiled twice: for AVX2, and for any processor.
 */
#pragma once

/** Put before a function over plain arrays: the loader takes the AVX2 version if the processor has it. Without fused
 *  multiply-add, so that both give the same bits. Not for functions that hold Eigen or PCL types: their alignment must
 *  not depend on the version. */
#if defined(__has_feature)
#if __has_feature(thread_sanitizer) // the loader chooses before the sanitizer is ready
#define PCL_SPIRAL_SIMD_CLONES
#endif
#endif
#if !defined(PCL_SPIRAL_SIMD_CLONES) && defined(__x86_64__) && defined(__GLIBC__) && defined(__has_attribute)
#if __has_attribute(target_clones)
#define PCL_SPIRAL_SIMD_CLONES __attribute__((target_clones("avx2", "default")))
#endif
#endif
#ifndef PCL_SPIRAL_SIMD_CLONES
#define PCL_SPIRAL_SIMD_CLONES
#endif
