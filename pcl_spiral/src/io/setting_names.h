// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Words for the choices in the settings, used in options, job files and reports.
 */
#pragma once

#include "drive/choice_words.h"
#include "machine/choice_words.h"
#include "ridge/choice_words.h"
#include "spiral/choice_words.h"
#include "surface/choice_words.h"
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/io/program_writer.h>

#include <array>
#include <utility>

namespace pcl_spiral {

template <>
struct ChoiceNames<LengthUnit> {
  static constexpr std::array<std::pair<LengthUnit, const char*>, 5> words{{{LengthUnit::Millimetre, "mm"},
                                                                            {LengthUnit::Metre, "m"},
                                                                            {LengthUnit::Inch, "inch"},
                                                                            {LengthUnit::Foot, "ft"},
                                                                            {LengthUnit::SurveyFoot, "us-ft"}}};
};
template <>
struct ChoiceNames<Dialect> {
  static constexpr auto words = [] {
    std::array<std::pair<Dialect, const char*>, dialect_entries.size()> pairs{};
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      pairs[i].first = dialect_entries[i].dialect;
      pairs[i].second = dialect_entries[i].word;
    }
    return pairs;
  }();
};
template <>
struct ChoiceNames<RobotZ> {
  static constexpr std::array<std::pair<RobotZ, const char*>, 2> words{{{RobotZ::Axis, "axis"}, {RobotZ::Normal, "normal"}}};
};
template <>
struct ChoiceNames<SpindleDirection> {
  static constexpr std::array<std::pair<SpindleDirection, const char*>, 2> words{
      {{SpindleDirection::Clockwise, "cw"}, {SpindleDirection::CounterClockwise, "ccw"}}};
};
template <>
struct ChoiceNames<Coolant> {
  static constexpr std::array<std::pair<Coolant, const char*>, 4> words{
      {{Coolant::None, "none"}, {Coolant::Mist, "mist"}, {Coolant::Flood, "flood"}, {Coolant::Through, "through"}}};
};
template <>
struct ChoiceNames<FeedMode> {
  static constexpr std::array<std::pair<FeedMode, const char*>, 2> words{
      {{FeedMode::InverseTime, "inverse-time"}, {FeedMode::PerMinute, "per-minute"}}};
};

} // namespace pcl_spiral
