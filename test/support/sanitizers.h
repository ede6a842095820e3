// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  What a build with sanitizers cannot tell.
 */
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PCL_SPIRAL_TESTS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PCL_SPIRAL_TESTS_SANITIZED 1
#endif
#endif

/** Whether AddressSanitizer or ThreadSanitizer is built in. Both hold several times the memory of a program, keep what it
 *  frees, map terabytes of addresses and slow it down: limits of memory and of time are not judged under them. */
#ifdef PCL_SPIRAL_TESTS_SANITIZED
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif
