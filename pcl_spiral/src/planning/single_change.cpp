// SPDX-License-Identifier: BSD-3-Clause
#include "planning/single_change.h"

#include "core/given_together.h"
#include "planning/closed_scan.h"
#include "planning/idle_settings.h"
#include "planning/proposed_value.h"
#include <pcl_spiral/graph/impl/surface_graph.h>

#include <pcl/common/point_tests.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double lower_scallop = 0.7;                           // of the scallop height: turns run elsewhere, and the finish stays
constexpr std::array<double, 2> smaller_balls{0.7, 0.5};        // of the radius, if the refusal tells none
constexpr std::array<double, 2> keep_out_half_widths{2.0, 4.0}; // radii, about a place

/** Settings that say what is wanted, not how it is reached: their defaults are no remedy. */
constexpr std::array<const char*, 5> wanted{"setToolRadius", "setScallopHeight", "setChordError", "setViewPoint", "setFlipNormals"};

/** Values that are tried with others of their kind: they name another part, room or tool. */
constexpr std::array<const char*, 3> of_kinds{"setPartAt", "addKeepOut", "setToolRadius"};

template <std::size_t N>
bool
contains(const std::array<const char*, N>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/** Whether \p input has as many points as a surface needs: else no change of a setting makes one. */
bool
hasPoints(const PlanInput& input)
{
  if (input.mesh || !input.cloud)
    return true;
  std::size_t count = 0;
  return std::any_of(input.cloud->begin(), input.cloud->end(),
                     [&count](const pcl::PointXYZ& p) { return (count += pcl::isFinite(p) ? 1 : 0) >= SurfaceGraph::fewest_points; });
}

Diagnostic
without(const std::string& setter)
{
  return Diagnostic(("without {" + setter + "}").c_str());
}

/** Whether \p second sets the only setting of \p first again. */
bool
replaces(const ChangeWords& second, const ChangeWords& first)
{
  const std::vector<std::string> before = first.all().settings(), now = second.settings.settings();
  return before.size() == 1 && before[0] != "addKeepOut" && std::find(now.begin(), now.end(), before[0]) != now.end();
}

/** The changes of one refused input. */
class Changes {
public:
  Changes(const PlanInput& input, const Refused& refused)
  : input_(input), said_(refused.status.diagnostic()), late_(refused.late), named_(said_.settings()), proposed_(said_.proposed())
  {}

  std::vector<SingleChange> find()
  {
    addDefaults();
    addProposed();
    addNamed();
    addClosing();
    addParts();
    addKeepOuts();
    addOtherTurns();
    addSmallerBalls();
    std::stable_partition(found_.begin(), found_.end(), [](const SingleChange& change) { return change.named; });
    return std::move(found_);
  }

private:
  bool names(const char* setter) const { return std::find(named_.begin(), named_.end(), setter) != named_.end(); }

  /** Adds the change that \p make makes. */
  template <typename Make>
  void add(const ChangeWords& words, bool keeps_surface, bool named, Make make)
  {
    SingleChange change{words, input_, keeps_surface, named};
    make(change.input);
    found_.push_back(std::move(change));
  }

  /** The defaults of the settings that the refusal names. */
  void addDefaults()
  {
    SpiralSettings now = input_.settings, usual;
    const std::vector<Setting> given = settingTable(now), defaults = settingTable(usual);
    for (std::size_t i = 0; i < given.size(); ++i) {
      const std::string& setter = given[i].setter;
      if (!names(setter.c_str()) || textOf(given[i]) == textOf(defaults[i]) || contains(wanted, setter))
        continue;
      add({{}, without(setter)}, false, true, [i](PlanInput& changed) {
        SpiralSettings other;
        copyValue(settingTable(other)[i], settingTable(changed.settings)[i]);
      });
    }
  }

  /** The change to a value of a setting, unless it is there already. */
  bool add(const Proposed& proposed, bool named = true)
  {
    SingleChange change{{}, input_, keepsSurface(proposed.setting), named};
    const std::optional<Given> given = takeProposed(proposed, firstPlace(), change.input);
    if (!given)
      return false;
    change.words.settings = Diagnostic(*given);
    found_.push_back(std::move(change));
    return true;
  }

  /** What the refusal proposes, but for other parts, keep-outs and tools. */
  void addProposed()
  {
    for (const Proposed& proposed : proposed_)
      if (!contains(of_kinds, proposed.setting))
        add(proposed);
  }

  Eigen::Vector3d firstPlace() const
  {
    const std::vector<Eigen::Vector3d> places = said_.places();
    return places.empty() ? Eigen::Vector3d(Eigen::Vector3d::Zero()) : places.front();
  }

  /** What the refusal names where one value helps. */
  void addNamed()
  {
    if (names("setTiltAngle") && !input_.settings.fixed_axis)
      add(Proposed("setTiltAngle", 0.0));
    if (names("setClusterHandling(ClusterHandling::Ride)") && input_.choice.clusters != ClusterHandling::Ride)
      add({"{setClusterHandling(ClusterHandling::Ride)}"}, false, true,
          [](PlanInput& changed) { changed.choice.clusters = ClusterHandling::Ride; });
    if (names("setBoundaryMode"))
      add(Proposed("setBoundaryMode", "one"));
    if (names("setHoleHandling"))
      add(Proposed("setHoleHandling", "over"));
  }

  /** Other turns over the same surface, if turns were made or the refusal names them. */
  void addOtherTurns()
  {
    const SpiralSettings& s = input_.settings;
    const bool is_radial = s.method != SpiralMethod::ConstantScallop && s.method != SpiralMethod::Shortest;
    const auto addOther = [this](const Proposed& proposed) {
      const bool named = names(proposed.setting.c_str());
      if (late_ || named)
        add(proposed, named);
    };
    addOther({"setMethod", is_radial ? "constant-scallop" : "radial"});
    addOther({"setSense", s.sense == SpiralSense::Clockwise ? "ccw" : "cw"});
    addOther({"setScallopHeight", lower_scallop * s.scallop_height});
  }

  /** Each of several separate parts, the largest first. */
  void addParts()
  {
    if (!(names("setLargestPart") || names("setPartAt")) || input_.settings.largest_part || input_.choice.part_at)
      return;
    bool has_places = false;
    for (const Proposed& proposed : proposed_)
      has_places = (proposed.setting == "setPartAt" && add(proposed)) || has_places;
    if (!has_places)
      add({"{setLargestPart(true)}"}, false, true, [](PlanInput& changed) { changed.settings.largest_part = true; });
  }

  /** The closing by the ball; it cuts more of several separate parts than one of them, and so comes before these. */
  void addClosing()
  {
    const bool separate = names("setLargestPart") || names("setPartAt");
    if (input_.ball_closing || !input_.cloud || !knowsSide(input_))
      return;
    SingleChange change{{"{setBallClosing(true)}", "with a fixed tool axis"}, input_, false, separate};
    change.input.ball_closing = true;
    leaveOutIdle(change);
    if (checkClosable(change.input).ok() && goesWithClosing(change.input))
      found_.push_back(std::move(change));
  }

  /** Of a scan that is closed. */
  static AskedJob closedJob()
  {
    AskedJob job;
    job.has_holder = job.keeps_axis = true;
    return job;
  }

  /** Whether all that was asked for beside the settings of \p changed goes with the closing. */
  static bool goesWithClosing(PlanInput changed)
  {
    AskedNames others = changed.asked;
    for (const Setting& setting : settingTable(changed.settings))
      others.erase(setting.name);
    return !idleSetting(others, changed.settings, closedJob());
  }

  /** Leaves out what has no effect with an axis that stays: programs refuse it. */
  static void leaveOutIdle(SingleChange& change)
  {
    SpiralSettings usual;
    const std::vector<Setting> given = settingTable(change.input.settings), defaults = settingTable(usual);
    for (std::size_t i = 0; i < given.size(); ++i)
      if (textOf(given[i]) != textOf(defaults[i]) && idleSetting({given[i].name}, change.input.settings, closedJob())) {
        copyValue(defaults[i], given[i]);
        change.words.aside += Diagnostic(", ", without(given[i].setter));
      }
  }

  /** All keep-outs that the refusal proposes, or one about its first place. */
  void addKeepOuts()
  {
    if (input_.mesh || input_.ball_closing || !names("addKeepOut"))
      return;
    SingleChange change{{}, input_, false, true};
    for (const Proposed& proposed : proposed_)
      if (const std::optional<Given> given =
              proposed.setting == "addKeepOut" ? takeProposed(proposed, firstPlace(), change.input) : std::nullopt)
        change.words.settings = givenTogether(change.words.settings, Diagnostic(*given));
    if (!change.words.settings.empty())
      found_.push_back(std::move(change));
    else if (!said_.places().empty())
      for (const double half : keep_out_half_widths) {
        const Eigen::Vector3d aside = half * input_.settings.tool_radius * Eigen::Vector3d(1.0, 1.0, 0.0);
        add(Proposed("addKeepOut", firstPlace() - aside, firstPlace() + aside), false);
      }
  }

  /** A smaller ball, which is another tool. It stays less far from keep-outs, so that more of the part is left beside them. */
  void addSmallerBalls()
  {
    bool is_proposed = false;
    for (const Proposed& proposed : proposed_)
      is_proposed = (proposed.setting == "setToolRadius" && add(proposed)) || is_proposed;
    const bool is_edge = names("setTightHandling") && !names("setToolRadius"); // which no ball fits into
    const double radius = input_.settings.tool_radius;
    const bool may_help = names("setToolRadius") || late_ || input_.ball_closing || !input_.choice.keep_outs.empty();
    if (!is_proposed && !is_edge && may_help)
      for (const double share : smaller_balls)
        add(Proposed("setToolRadius", share * radius), names("setToolRadius"));
  }

  const PlanInput& input_;
  const Diagnostic& said_;
  bool late_;
  std::vector<std::string> named_;
  std::vector<Proposed> proposed_;
  std::vector<SingleChange> found_;
};

} // namespace

Diagnostic
ChangeWords::all() const
{
  return settings.empty() || aside.empty() ? settings + aside : Diagnostic(settings, ", ", aside);
}

ChangeWords
together(const ChangeWords& first, const ChangeWords& second)
{
  if (replaces(second, first))
    return second;
  return {givenTogether(first.settings, second.settings),
          first.aside.empty() || second.aside.empty() ? first.aside + second.aside : Diagnostic(first.aside, ", ", second.aside),
          first.changes + second.changes};
}

std::vector<SingleChange>
singleChanges(const PlanInput& input, const Refused& refused)
{
  return hasPoints(input) ? Changes(input, refused).find() : std::vector<SingleChange>();
}

} // namespace pcl_spiral
