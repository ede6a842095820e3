// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Reads the values of options. A wrong value is a UsageError that names option, value and
 * remedy.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>

#include "terminal.h"

#include "io/setting_names.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

/** 12.5 */
double numberValue(const std::string& name, const std::string& value);

/** \throw UsageError "--option value: rule" unless \p holds */
void requireOption(bool holds, const std::string& option, double value, const pcl_spiral::Diagnostic& rule);

/** 4 */
int wholeNumberValue(const std::string& name, const std::string& value);

/** The pieces between slashes. */
std::vector<std::string> piecesOf(const std::string& value);

/** The words between commas, without spaces. */
std::vector<std::string> listValue(const std::string& value);

/** 10,-5,120 */
Eigen::Vector3d placeValue(const std::string& name, const std::string& value);

/** One of an enumeration's words. */
template <typename Enum>
Enum
choiceValue(const std::string& name, const std::string& value)
{
  const std::optional<Enum> result = pcl_spiral::choiceFromName<Enum>(value);
  if (!result)
    throw UsageError(pcl_spiral::Diagnostic("--", name, " ", value, ": must be one of ", pcl_spiral::choiceList<Enum>()));
  return *result;
}
