// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Words for the values of enumerations.
 */
#pragma once

#include <optional>
#include <string>

namespace pcl_spiral {

/** The words of an enumeration, as options, job files, reports and scripts have them: an array \c words of pairs of a value and its word.
 *  Specialised for every choice of the user. */
template <typename Enum>
struct ChoiceNames;

/** The word for \p choice. */
template <typename Enum>
std::string
choiceName(Enum choice)
{
  for (const auto& [value, word] : ChoiceNames<Enum>::words)
    if (value == choice)
      return word;
  return "?";
}

/** The choice of the word \p name; nothing if no word matches. */
template <typename Enum>
std::optional<Enum>
choiceFromName(const std::string& name)
{
  for (const auto& [value, word] : ChoiceNames<Enum>::words)
    if (word == name)
      return value;
  return std::nullopt;
}

/** Every word, for help and messages: "auto|one|two". */
template <typename Enum>
std::string
choiceList()
{
  std::string list;
  for (const auto& [value, word] : ChoiceNames<Enum>::words)
    list += (list.empty() ? "" : "|") + std::string(word);
  return list;
}

} // namespace pcl_spiral
