// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Words for the choices in the settings of this room.
 */
#pragma once

#include <pcl_spiral/core/choice.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <array>
#include <utility>

namespace pcl_spiral {

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

} // namespace pcl_spiral
