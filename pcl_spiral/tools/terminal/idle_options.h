// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Refuses options that others leave without an effect.
 */
#pragma once

#include "planning/idle_settings.h"

#include <optional>
#include <set>
#include <string>

/** The names of the tables for the options that were \p given. */
pcl_spiral::AskedNames askedNames(const std::set<std::string>& given);

/** \throw UsageError for an option that does nothing */
void requireUsed(const std::optional<pcl_spiral::IdleSetting>& idle);
