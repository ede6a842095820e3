// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Settings that were asked for, and that others leave without an effect: refused by all faces of the library.
 */
#pragma once

#include <pcl_spiral/core/diagnostic.h>
#include <pcl_spiral/drive/drive_settings.h>
#include <pcl_spiral/planning/pass_plan.h>
#include <pcl_spiral/spiral/spiral_settings.h>

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace pcl_spiral {

/** The names in tables of the settings that were asked for, with "curve", "crop", "regions" and others that are in none. */
using AskedNames = std::set<std::string>;

/** A setting that was asked for and does nothing. A face shows its name in its own words, and the remedy behind it. */
struct IdleSetting {
  std::string name;
  Diagnostic remedy;
};

/** Finds the first idle setting of several rules. */
class IdleRules {
public:
  explicit IdleRules(AskedNames asked) : asked_(std::move(asked)) {}

  /** One of \p names does nothing, because \p remedy. */
  void forbid(std::initializer_list<const char*> names, const Diagnostic& remedy);
  /** The same unless it is \p meant. */
  void require(bool meant, std::initializer_list<const char*> names, const Diagnostic& remedy)
  {
    if (!meant)
      forbid(names, remedy);
  }
  bool isAsked(const char* name) const { return asked_.count(name) > 0; }
  const std::optional<IdleSetting>& found() const { return found_; }

private:
  AskedNames asked_;
  std::optional<IdleSetting> found_;
};

/** What a job has beside its settings. */
struct AskedJob {
  bool on_mesh = false;
  bool has_holder = false;
  bool checks_gouges = true; ///< of passes over a mesh
  bool keeps_axis = false;   ///< of a spiral over a scan that is closed by the ball
};

/** Of a spiral. */
std::optional<IdleSetting> idleSetting(const AskedNames& asked, const SpiralSettings& settings, const AskedJob& job);

/** Of passes along a drive path. */
std::optional<IdleSetting> idleSetting(const AskedNames& asked, const DriveSettings& drive, const PassSettings& tool, const AskedJob& job);

/** Of rows over a ridge, with a beam if the cutter has no radius. */
std::optional<IdleSetting> idleSetting(const AskedNames& asked, const PassSettings& tool, const AskedJob& job);

/** Of a path that is judged. */
std::optional<IdleSetting> idleOfJudging(const AskedNames& asked, const AskedJob& job);

} // namespace pcl_spiral
