// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Words for the choices in the settings, used in options, job files and reports.
 */
#pragma once

#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/io/cloud_reader.h>
#include <pcl_spiral/io/path_exchange.h>
#include <pcl_spiral/io/program_writer.h>
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/ridge/ridge_rows.h>
#include <pcl_spiral/spiral/spiral_settings.h>
#include <pcl_spiral/surface/surface.h>

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace pcl_spiral {

/** The words of an enumeration: pairs of a value and its word. Specialised for every choice of the user. */
template <typename Enum>
struct ChoiceNames;

template <>
struct ChoiceNames<LengthUnit> {
  static constexpr std::array<std::pair<LengthUnit, const char*>, 5> words{{{LengthUnit::Millimetre, "mm"},
                                                                            {LengthUnit::Metre, "m"},
                                                                            {LengthUnit::Inch, "inch"},
                                                                            {LengthUnit::Foot, "ft"},
                                                                            {LengthUnit::SurveyFoot, "us-ft"}}};
};
template <>
struct ChoiceNames<ClusterHandling> {
  static constexpr std::array<std::pair<ClusterHandling, const char*>, 3> words{
      {{ClusterHandling::Refuse, "refuse"}, {ClusterHandling::Ride, "ride"}, {ClusterHandling::LeaveOut, "leave-out"}}};
};
template <>
struct ChoiceNames<BoundaryMode> {
  static constexpr std::array<std::pair<BoundaryMode, const char*>, 4> words{{{BoundaryMode::Automatic, "auto"},
                                                                              {BoundaryMode::OneBoundary, "one"},
                                                                              {BoundaryMode::TwoBoundaries, "two"},
                                                                              {BoundaryMode::AllBoundaries, "all"}}};
};
template <>
struct ChoiceNames<SpiralDirection> {
  static constexpr std::array<std::pair<SpiralDirection, const char*>, 2> words{
      {{SpiralDirection::Outward, "outward"}, {SpiralDirection::Inward, "inward"}}};
};
template <>
struct ChoiceNames<SpiralSense> {
  static constexpr std::array<std::pair<SpiralSense, const char*>, 2> words{
      {{SpiralSense::CounterClockwise, "ccw"}, {SpiralSense::Clockwise, "cw"}}};
};
template <>
struct ChoiceNames<Pitch> {
  static constexpr std::array<std::pair<Pitch, const char*>, 2> words{{{Pitch::AcrossFeed, "across"}, {Pitch::AlongLine, "along"}}};
};
template <>
struct ChoiceNames<GapHandling> {
  static constexpr std::array<std::pair<GapHandling, const char*>, 2> words{
      {{GapHandling::Bridge, "bridge"}, {GapHandling::Refuse, "refuse"}}};
};
template <>
struct ChoiceNames<TightHandling> {
  static constexpr std::array<std::pair<TightHandling, const char*>, 2> words{
      {{TightHandling::Ride, "ride"}, {TightHandling::Refuse, "refuse"}}};
};
template <>
struct ChoiceNames<HoleHandling> {
  static constexpr std::array<std::pair<HoleHandling, const char*>, 3> words{
      {{HoleHandling::Around, "around"}, {HoleHandling::Over, "over"}, {HoleHandling::Refuse, "refuse"}}};
};
template <>
struct ChoiceNames<LineMethod> {
  static constexpr std::array<std::pair<LineMethod, const char*>, 3> words{
      {{LineMethod::Automatic, "auto"}, {LineMethod::Geodesic, "geodesic"}, {LineMethod::Harmonic, "harmonic"}}};
};
template <>
struct ChoiceNames<SpiralMethod> {
  static constexpr std::array<std::pair<SpiralMethod, const char*>, 4> words{{{SpiralMethod::Shortest, "shortest"},
                                                                              {SpiralMethod::Radial, "radial"},
                                                                              {SpiralMethod::ConstantScallop, "constant-scallop"},
                                                                              {SpiralMethod::Published, "published"}}};
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
struct ChoiceNames<LeadKind> {
  static constexpr std::array<std::pair<LeadKind, const char*>, 2> words{{{LeadKind::Normal, "normal"}, {LeadKind::Arc, "arc"}}};
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
template <>
struct ChoiceNames<DriveKind> {
  static constexpr std::array<std::pair<DriveKind, const char*>, 5> words{{{DriveKind::Planes, "planes"},
                                                                           {DriveKind::Helix, "helix"},
                                                                           {DriveKind::Rings, "rings"},
                                                                           {DriveKind::Curve, "curve"},
                                                                           {DriveKind::BoundaryOffset, "offset"}}};
};
template <>
struct ChoiceNames<DriveRows> {
  static constexpr std::array<std::pair<DriveRows, const char*>, 2> words{{{DriveRows::Even, "even"}, {DriveRows::Kept, "kept"}}};
};
template <>
struct ChoiceNames<DriveAxisMode> {
  static constexpr std::array<std::pair<DriveAxisMode, const char*>, 4> words{{{DriveAxisMode::Fixed, "fixed"},
                                                                               {DriveAxisMode::Cylinder, "cylinder"},
                                                                               {DriveAxisMode::LocalPlane, "plane"},
                                                                               {DriveAxisMode::Surface, "surface"}}};
};

template <>
struct ChoiceNames<RidgeDirection> {
  static constexpr std::array<std::pair<RidgeDirection, const char*>, 2> words{
      {{RidgeDirection::AlongRail, "along"}, {RidgeDirection::AcrossRail, "across"}}};
};
template <>
struct ChoiceNames<RidgeSteps> {
  static constexpr std::array<std::pair<RidgeSteps, const char*>, 2> words{
      {{RidgeSteps::EqualOnRow, "equal"}, {RidgeSteps::Stations, "stations"}}};
};
template <>
struct ChoiceNames<RidgeNormals> {
  static constexpr std::array<std::pair<RidgeNormals, const char*>, 3> words{
      {{RidgeNormals::True, "true"}, {RidgeNormals::InNormalPlane, "in-plane"}, {RidgeNormals::Arc, "arc"}}};
};

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
