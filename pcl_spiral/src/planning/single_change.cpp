// SPDX-License-Identifier: BSD-3-Clause
#include "planning/single_change.h"

#include "planning/closed_scan.h"
#include "planning/told_values.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace pcl_spiral {
namespace {

constexpr double lower_scallop = 0.7;                           // of the scallop height: turns run elsewhere, and the finish stays
constexpr std::array<double, 2> smaller_balls{0.7, 0.5};        // of the radius, if the refusal tells none
constexpr std::array<double, 2> keep_out_half_widths{2.0, 4.0}; // radii, about a place
constexpr double more_room = 1.5;                               // times the depth that a shank cuts: its lean changes with the place

/** Settings that say what is wanted, not how it is reached: their defaults are no remedy. */
constexpr std::array<const char*, 5> wanted{"setToolRadius", "setScallopHeight", "setChordError", "setViewPoint", "setFlipNormals"};

/** The changes of one refused input. */
class Changes {
public:
  Changes(const PlanInput& input, const Refused& refused)
  : input_(input), said_(refused.status.diagnostic()), late_(refused.late), named_(said_.settings())
  {}

  std::vector<SingleChange> find()
  {
    addDefaults();
    addTold();
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
  void add(const Diagnostic& words, bool keeps_surface, bool named, Make make)
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
      if (!names(setter.c_str()) || textOf(given[i]) == textOf(defaults[i]) ||
          std::find(wanted.begin(), wanted.end(), setter) != wanted.end())
        continue;
      add(Diagnostic(("without {" + setter + "}").c_str()), false, true, [i](PlanInput& changed) {
        SpiralSettings other;
        copyValue(settingTable(other)[i], settingTable(changed.settings)[i]);
      });
    }
  }

  /** Values that the refusal tells. */
  void addTold()
  {
    const double thinning = numberBehind(said_, {"thin to ", "{setThinning} "});
    if (names("setThinning") && thinning > 0.0)
      add(Diagnostic("{setThinning} ", thinning), false, true, [=](PlanInput& changed) { changed.settings.thinning = thinning; });
    const bool leans = input_.settings.tilt_angle != 0.0 && !input_.settings.fixed_axis;
    if (names("setTiltAngle") && leans)
      add("{setTiltAngle} 0", true, true, [](PlanInput& changed) { changed.settings.tilt_angle = 0.0; });
    if (names("setClusterHandling(ClusterHandling::Ride)") && input_.choice.clusters != ClusterHandling::Ride)
      add("{setClusterHandling(ClusterHandling::Ride)}", false, true,
          [](PlanInput& changed) { changed.choice.clusters = ClusterHandling::Ride; });
    if (names("setBoundaryMode") && input_.settings.boundary_mode != BoundaryMode::OneBoundary)
      add("{setBoundaryMode} one", true, true, [](PlanInput& changed) { changed.settings.boundary_mode = BoundaryMode::OneBoundary; });
    if (names("setHoleHandling") && input_.settings.holes != HoleHandling::Over)
      add("{setHoleHandling} over", true, true, [](PlanInput& changed) { changed.settings.holes = HoleHandling::Over; });
    const double cut = numberBehind(said_, {"would cut "});
    if (names("addKeepOut") && !input_.choice.keep_outs.empty() && cut > 0.0)
      add(Diagnostic("keep-outs wider by ", more_room * cut, " {mm} on all sides ({addKeepOut})"), false, true,
          [=](PlanInput& changed) { changed.choice.margin += more_room * cut; });
  }

  /** Other turns over the same surface, if turns were made or the refusal names them. */
  void addOtherTurns()
  {
    const SpiralSettings& s = input_.settings;
    const bool is_radial = s.method != SpiralMethod::ConstantScallop && s.method != SpiralMethod::Shortest;
    const bool clockwise = s.sense == SpiralSense::Clockwise;
    const double height = roundedDown(lower_scallop * s.scallop_height);
    if (late_ || names("setMethod"))
      add(is_radial ? "{setMethod} constant-scallop" : "{setMethod} radial", true, names("setMethod"),
          [is_radial](PlanInput& changed) { changed.settings.method = is_radial ? SpiralMethod::ConstantScallop : SpiralMethod::Radial; });
    if (late_ || names("setSense"))
      add(clockwise ? "{setSense} ccw" : "{setSense} cw", true, names("setSense"),
          [clockwise](PlanInput& changed) { changed.settings.sense = clockwise ? SpiralSense::CounterClockwise : SpiralSense::Clockwise; });
    if (late_ || names("setScallopHeight"))
      add(Diagnostic("{setScallopHeight} ", height), true, names("setScallopHeight"),
          [height](PlanInput& changed) { changed.settings.scallop_height = height; });
  }

  /** Each of several separate parts, the largest first. */
  void addParts()
  {
    if (!(names("setLargestPart") || names("setPartAt")) || input_.settings.largest_part || input_.choice.part_at)
      return;
    const std::vector<Eigen::Vector3d> parts = placesBehind(said_, "{mm2} at ");
    for (const Eigen::Vector3d& place : parts)
      add(Diagnostic("{setPartAt} ", Place(place)), false, true, [place](PlanInput& changed) { changed.choice.part_at = place; });
    if (parts.empty())
      add("{setLargestPart}", false, true, [](PlanInput& changed) { changed.settings.largest_part = true; });
  }

  /** The closing by the ball; it cuts more of several separate parts than one of them, and so comes before these. */
  void addClosing()
  {
    const bool separate = names("setLargestPart") || names("setPartAt");
    if (!input_.ball_closing && input_.cloud && !input_.mesh && knowsSide(input_))
      add("{setBallClosing}, with a fixed tool axis", false, separate, [](PlanInput& changed) { changed.ball_closing = true; });
  }

  /** Keep-outs about what the refusal gives the extents of, or about its first place. */
  void addKeepOuts()
  {
    if (input_.mesh || input_.ball_closing || !names("addKeepOut"))
      return;
    if (const std::vector<Eigen::AlignedBox3d> boxes = extentsOf(said_); !boxes.empty())
      addBoxes(boxes, true);
    else if (!said_.places().empty())
      for (const double half : keep_out_half_widths) {
        const Eigen::Vector3d aside = half * input_.settings.tool_radius * Eigen::Vector3d(1.0, 1.0, 0.0), place = said_.places().front();
        addBoxes({Eigen::AlignedBox3d(place - aside, place + aside)}, false);
      }
  }

  void addBoxes(const std::vector<Eigen::AlignedBox3d>& boxes, bool named)
  {
    Diagnostic words;
    for (const Eigen::AlignedBox3d& box : boxes)
      words += Diagnostic(words.empty() ? "{addKeepOut} from " : ", {addKeepOut} from ", Place(box.min()), " to ", Place(box.max()));
    add(words, false, named, [&boxes](PlanInput& changed) {
      for (const Eigen::AlignedBox3d& box : boxes)
        changed.choice.keep_outs.push_back(uprightPrism(box));
    });
  }

  /** A smaller ball, which is another tool. */
  void addSmallerBalls()
  {
    const double radius = input_.settings.tool_radius, told = roundedDown(numberBehind(said_, {"a radius of "}));
    const auto addBall = [&](double smaller) {
      add(Diagnostic("{setToolRadius} ", smaller), true, names("setToolRadius"),
          [=](PlanInput& changed) { changed.settings.tool_radius = smaller; });
    };
    if (told > 0.0 && told < radius)
      addBall(told);
    else if (names("setToolRadius") || late_ || input_.ball_closing)
      for (const double share : smaller_balls)
        addBall(roundedDown(share * radius));
  }

  const PlanInput& input_;
  const Diagnostic& said_;
  bool late_;
  std::vector<std::string> named_;
  std::vector<SingleChange> found_;
};

} // namespace

std::vector<SingleChange>
singleChanges(const PlanInput& input, const Refused& refused)
{
  return Changes(input, refused).find();
}

} // namespace pcl_spiral
