// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Whether a build has sanitizers, and so cannot check some limits.
 */
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PCL_SPIRAL_TESTS_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PCL_SPIRAL_TESTS_SANITIZED 1
#endif
#endif

/** Whether AddressSanitizer or ThreadSanitizer is built in. Both need several times the memory of a program, keep freed
 *  memory, map terabytes of addresses and slow the program down: limits of memory and time are not checked with them. */
#ifdef PCL_SPIRAL_TESTS_SANITIZED
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif
