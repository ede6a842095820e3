// SPDX-License-Identifier: BSD-3-Clause
// The tables of settings: each entry is whole, each setter sets its own variable and no other one through every base class and in every
// order, each value out of range is refused by the class that uses it with value and remedy in the words of every face, and a surface knows
// by which settings it was made.
#include <pcl_spiral/drive/drive_path.h>
#include <pcl_spiral/machine/machine_program_generator.h>
#include <pcl_spiral/planning/drive_planner.h>
#include <pcl_spiral/planning/path_verifier.h>
#include <pcl_spiral/planning/spiral_planner.h>
#include <pcl_spiral/ridge/ridge_toolpath.h>
#include <pcl_spiral/spiral/spiral_toolpath_generator.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace settings_test {
namespace {

using namespace pcl_spiral;
using Point = pcl::PointXYZ;

std::vector<double>
numbersIn(const std::string& text)
{
  std::vector<double> numbers;
  std::stringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');)
    numbers.push_back(std::stod(word));
  return numbers;
}

/** Gives the variable a value that is not its default: the example, or the other truth. */
struct Change {
  const Setting& setting;
  void operator()(bool* target) const { *target = !*target; }
  void operator()(Eigen::Vector3d* target) const { *target = place(); }
  void operator()(std::optional<Eigen::Vector3d>* target) const { *target = place(); }
  void operator()(const ChoiceTarget& target) const { EXPECT_TRUE(target.take(setting.example)) << setting.name; }
  template <typename Number>
  void operator()(Number* target) const
  {
    *target = static_cast<typename std::decay_t<decltype(*target)>>(number());
  }
  void operator()(std::optional<double>* target) const { *target = number(); }

private:
  double number() const { return numbersIn(setting.example).at(0); }
  Eigen::Vector3d place() const
  {
    const std::vector<double> n = numbersIn(setting.example);
    return {n.at(0), n.at(1), n.at(2)};
  }
};

template <typename Settings>
std::vector<std::string>
textsOf(Settings settings)
{
  std::vector<std::string> texts;
  for (const Setting& setting : settingTable(settings))
    texts.push_back(setting.name + "=" + textOf(setting));
  return texts;
}

template <typename Settings>
void
expectWhole(Settings settings)
{
  std::set<std::string> names;
  const std::vector<std::string> defaults = textsOf(settings);
  std::size_t i = 0;
  for (const Setting& setting : settingTable(settings)) {
    EXPECT_TRUE(names.insert(setting.name).second) << setting.name;
    for (const std::string& text : {setting.setter, setting.words, setting.help})
      EXPECT_FALSE(text.empty()) << setting.name;
    std::visit(Change{setting}, setting.target);
    EXPECT_NE(setting.name + "=" + textOf(setting), defaults[i++]) << "the example is the default, or has no effect";
    if (const std::optional<double> number = numberOf(setting))
      EXPECT_TRUE(setting.range.takes(*number)) << setting.name << " does not take its example";
  }
  EXPECT_EQ(faultOf(settingTable(settings)), Diagnostic());
}

TEST(settings, everyEntryIsWhole)
{
  expectWhole(SpiralSettings());
  expectWhole(DriveSettings());
  expectWhole(PassSettings());
  expectWhole(MeshSettings());
  expectWhole(RidgeSettings());
  expectWhole(RidgeRowSettings());
  expectWhole(ProgramSettings());
  expectWhole(JudgeSettings());
  expectWhole(Limits());
}

TEST(settings, rangesInWords)
{
  double number = 1.0;
  const auto rule = [&](const NumberRange& range, const char* zero = "") {
    return ruleOf(Setting("depth", "setDepth", "depth", "how deep", "3", number).in("mm", range).zeroFor(zero)).text();
  };
  EXPECT_EQ(rule(NumberRange::above(0.0)), "must be above 0 mm, such as 3");
  EXPECT_EQ(rule(NumberRange::from(2.0)), "must be 2 mm or more, such as 3");
  EXPECT_EQ(rule(NumberRange::from(0.0), "none"), "must be above 0 mm, or 0 for none, such as 3");
  EXPECT_EQ(rule(NumberRange::from(0.0).upTo(256.0), "all"), "must be above 0 and at most 256 mm, or 0 for all, such as 3");
  EXPECT_EQ(rule(NumberRange::above(-90.0).below(90.0)), "must be above -90 and below 90 mm, such as 3");
  EXPECT_EQ(rule(NumberRange::from(0.0).upTo(0.25)), "must be from 0 to 0.25 mm, such as 3");
  EXPECT_EQ(rule(NumberRange()), "must be a number of mm, such as 3");
  const auto count_of = [&](double least) {
    return ruleOf(Setting("depth", "setDepth", "depth", "how deep", "3", number).in("spacings", NumberRange::from(least))).text();
  };
  EXPECT_EQ(count_of(1.0), "must be 1 spacing or more, such as 3");
  EXPECT_EQ(count_of(2.0), "must be 2 spacings or more, such as 3");
  EXPECT_EQ(ruleOf(Setting("depth", "setDepth", "depth", "how deep", "", number).in("", NumberRange::above(0.0)).withRemedy("dig")).text(),
            "must be above 0; dig");
  unsigned int count = 4294967295U;
  EXPECT_EQ(faultOf({Setting("count", "setCount", "count", "how many", "", count).in("", NumberRange::from(0.0).upTo(9.0))}).text(),
            "the count is 4294967295: it must be from 0 to 9 (setCount)");
  EXPECT_FALSE(NumberRange().takes(std::nan("")));
  EXPECT_FALSE(NumberRange::above(0.0).takes(INFINITY));
  EXPECT_TRUE(NumberRange::above(0.0).upTo(INFINITY).takes(INFINITY));
}

/** What a setter does: the value of \p from, through a base class. */
template <typename Base, typename Settings>
using Setters = std::vector<std::pair<const char*, std::function<void(Base&, const Settings&)>>>;

/** Every setter changes its own variable alone, and two of them the same in both orders. */
template <typename Class, typename Base, typename Settings>
void
expectOwn(const Setters<Base, Settings>& setters)
{
  const auto changed = [](const std::set<std::string>& by) {
    Settings settings = Class().getSettings();
    for (const Setting& setting : settingTable(settings))
      if (by.count(setting.setter) > 0)
        std::visit(Change{setting}, setting.target);
    return settings;
  };
  for (const auto& [name, set] : setters) {
    Class object;
    set(object, changed({name}));
    EXPECT_EQ(textsOf(object.getSettings()), textsOf(changed({name}))) << name;
    for (const auto& [other, set_other] : setters) {
      Class after;
      set_other(after, changed({other}));
      set(after, changed({name}));
      EXPECT_EQ(textsOf(after.getSettings()), textsOf(changed({name, other}))) << other << ", then " << name;
    }
  }
}

/** Whether each setter of a table is among \p setters, but for \p others. */
template <typename Base, typename Settings>
void
expectAll(const Setters<Base, Settings>& setters, Settings settings, const std::set<std::string>& others)
{
  for (const Setting& setting : settingTable(settings)) {
    const bool known = std::any_of(setters.begin(), setters.end(), [&](const auto& entry) { return setting.setter == entry.first; });
    EXPECT_NE(known, others.count(setting.setter) > 0) << setting.setter;
  }
}

using Input = SurfaceInput<pcl::PCLBase<Point>, Point>;
using Spiral = SpiralInput<Point>;

const Setters<Input, SpiralSettings> surface_setters{
    {"setViewPoint", [](Input& c, const SpiralSettings& s) { c.setViewPoint(*s.view_point); }},
    {"setFlipNormals", [](Input& c, const SpiralSettings& s) { c.setFlipNormals(s.flip_normals); }},
    {"setTrustNormals", [](Input& c, const SpiralSettings& s) { c.setTrustNormals(s.trust_normals); }},
    {"setLargestPart", [](Input& c, const SpiralSettings& s) { c.setLargestPart(s.largest_part); }},
    {"setPartAt", [](Input& c, const SpiralSettings& s) { c.setPartAt(*s.part_at); }},
    {"setClusterHandling", [](Input& c, const SpiralSettings& s) { c.setClusterHandling(s.clusters); }},
    {"setThinning", [](Input& c, const SpiralSettings& s) { c.setThinning(s.thinning); }},
    {"setOutlierRemoval", [](Input& c, const SpiralSettings& s) { c.setOutlierRemoval(s.outlier_neighbours, s.outlier_deviations); }},
    {"setNumberOfThreads", [](Input& c, const SpiralSettings& s) { c.setNumberOfThreads(s.threads); }},
};

const Setters<Spiral, SpiralSettings> spiral_setters{
    {"setToolRadius", [](Spiral& c, const SpiralSettings& s) { c.setToolRadius(s.tool_radius); }},
    {"setScallopHeight", [](Spiral& c, const SpiralSettings& s) { c.setScallopHeight(s.scallop_height); }},
    {"setChordError", [](Spiral& c, const SpiralSettings& s) { c.setChordError(s.chord_error); }},
    {"setMaxStep", [](Spiral& c, const SpiralSettings& s) { c.setMaxStep(s.max_step); }},
    {"setTiltAngle", [](Spiral& c, const SpiralSettings& s) { c.setTiltAngle(s.tilt_angle); }},
    {"setLeadAngle", [](Spiral& c, const SpiralSettings& s) { c.setLeadAngle(s.lead_angle); }},
    {"setFixedAxis", [](Spiral& c, const SpiralSettings& s) { c.setFixedAxis(*s.fixed_axis); }},
    {"setMaxAxisRate", [](Spiral& c, const SpiralSettings& s) { c.setMaxAxisRate(s.max_axis_rate); }},
    {"setAxisSmoothing", [](Spiral& c, const SpiralSettings& s) { c.setAxisSmoothing(s.axis_smoothing); }},
    {"setAxisDeviation", [](Spiral& c, const SpiralSettings& s) { c.setAxisDeviation(s.axis_deviation); }},
    {"setFeed", [](Spiral& c, const SpiralSettings& s) { c.setFeed(s.feed); }},
    {"setAcceleration", [](Spiral& c, const SpiralSettings& s) { c.setAcceleration(s.acceleration); }},
    {"setCenter", [](Spiral& c, const SpiralSettings& s) { c.setCenter(*s.centre); }},
    {"setStartPoint", [](Spiral& c, const SpiralSettings& s) { c.setStartPoint(*s.start_point); }},
    {"setBoundaryMode", [](Spiral& c, const SpiralSettings& s) { c.setBoundaryMode(s.boundary_mode); }},
    {"setHoleHandling", [](Spiral& c, const SpiralSettings& s) { c.setHoleHandling(s.holes); }},
    {"setHoleSize", [](Spiral& c, const SpiralSettings& s) { c.setHoleSize(s.hole_size); }},
    {"setHoleMargin", [](Spiral& c, const SpiralSettings& s) { c.setHoleMargin(s.hole_margin); }},
    {"setRimOverhang", [](Spiral& c, const SpiralSettings& s) { c.setRimOverhang(s.rim_overhang); }},
    {"setDirection", [](Spiral& c, const SpiralSettings& s) { c.setDirection(s.direction); }},
    {"setSense", [](Spiral& c, const SpiralSettings& s) { c.setSense(s.sense); }},
    {"setOneWay", [](Spiral& c, const SpiralSettings& s) { c.setOneWay(s.one_way); }},
    {"setMethod", [](Spiral& c, const SpiralSettings& s) { c.setMethod(s.method); }},
    {"setLeastTurnRadius", [](Spiral& c, const SpiralSettings& s) { c.setLeastTurnRadius(s.least_turn_radius); }},
    {"setPitch", [](Spiral& c, const SpiralSettings& s) { c.setPitch(s.pitch); }},
    {"setLineMethod", [](Spiral& c, const SpiralSettings& s) { c.setLineMethod(s.lines); }},
    {"setTightHandling", [](Spiral& c, const SpiralSettings& s) { c.setTightHandling(s.tight); }},
    {"setGapHandling", [](Spiral& c, const SpiralSettings& s) { c.setGapHandling(s.gaps); }},
};

TEST(settings, everySetterOfASpiralThroughItsBases)
{
  Setters<Spiral, SpiralSettings> all = spiral_setters;
  for (const auto& [name, set] : surface_setters)
    all.push_back({name, [set = set](Spiral& c, const SpiralSettings& s) { set(c, s); }});
  expectAll(all, SpiralSettings(), {"setKSearch", "setAlpha"}); // of ScannedSurface alone
  expectOwn<SpiralToolpathGenerator<Point>>(all);
  expectOwn<SpiralPlanner<Point>>(all);
}

TEST(settings, everySetterOfPassesThroughTheirBase)
{
  using Base = DriveInput<Point>;
  const Setters<Base, DriveSettings> setters{
      {"setKind", [](Base& c, const DriveSettings& s) { c.setKind(s.kind); }},
      {"setStepOver", [](Base& c, const DriveSettings& s) { c.setStepOver(s.step_over); }},
      {"setPointSpacing", [](Base& c, const DriveSettings& s) { c.setPointSpacing(s.point_spacing); }},
      {"setChordError", [](Base& c, const DriveSettings& s) { c.setChordError(s.chord_error); }},
      {"setOverrun", [](Base& c, const DriveSettings& s) { c.setOverrun(s.overrun); }},
      {"setPlaneDirection", [](Base& c, const DriveSettings& s) { c.setPlaneDirection(s.plane_angle); }},
      {"setRows", [](Base& c, const DriveSettings& s) { c.setRows(s.rows); }},
      {"setLinkRows", [](Base& c, const DriveSettings& s) { c.setLinkRows(s.link_rows); }},
      {"setZigzag", [](Base& c, const DriveSettings& s) { c.setZigzag(s.zigzag); }},
      {"setAxis", [](Base& c, const DriveSettings& s) { c.setAxis(s.axis); }},
      {"setAxisMode", [](Base& c, const DriveSettings& s) { c.setAxisMode(*s.axis_mode); }},
      {"setScallopHeight",
       [](Base& c, const DriveSettings& s) {
         c.setToolRadius(6.0);
         c.setScallopHeight(s.scallop_height);
       }},
  };
  expectAll(setters, DriveSettings(), {});
  expectOwn<DrivePath<Point>>(setters);
  expectOwn<DrivePlanner<Point>>(setters);
}

/** Gives a number the \p value; false if its type cannot hold it. */
bool
put(double value, const Setting& setting)
{
  if (const auto* number = std::get_if<double*>(&setting.target))
    **number = value;
  else if (const auto* whole = std::get_if<int*>(&setting.target); whole && std::abs(value) < 1e9)
    **whole = static_cast<int>(value);
  else if (const auto* count = std::get_if<unsigned int*>(&setting.target); count && value >= 0.0 && value < 1e9)
    **count = static_cast<unsigned int>(value);
  else
    return false;
  return true;
}

/** The table of \p settings, each number of which in turn is out of its range, and what \p check says to it. */
template <typename Settings>
void
expectRefused(const Settings& settings, const std::function<Status(const Settings&)>& check, bool (*skipped)(const Setting&))
{
  Settings whole = settings;
  ASSERT_TRUE(check(whole).ok()) << check(whole).message();
  const std::size_t count = settingTable(whole).size();
  for (std::size_t i = 0; i < count; ++i) {
    Settings wrong = settings;
    const Setting setting = settingTable(wrong)[i];
    if (skipped(setting))
      continue;
    for (const double value : {setting.range.least - (setting.range.takes_least ? 1.0 : 0.0),
                               setting.range.most + (setting.range.takes_most ? 1.0 : 0.0), std::nan("")}) {
      if (setting.range.takes(value) || !put(value, setting))
        continue;
      const Status status = check(wrong);
      EXPECT_EQ(status.code(), StatusCode::InvalidArgument) << setting.name << " " << value;
      const std::string cxx = status.message();
      EXPECT_NE(cxx.find(setting.words), std::string::npos) << cxx;
      EXPECT_NE(cxx.find(setting.setter), std::string::npos) << cxx;
      EXPECT_EQ(cxx.find('{'), std::string::npos) << cxx;
      Vocabulary option;
      option.has_setters = false;
      option.words[setting.setter] = "--" + setting.name;
      const std::string program = status.diagnostic().text(option);
      EXPECT_NE(program.find("(--" + setting.name + ")"), std::string::npos) << program;
      EXPECT_EQ(program.find(setting.setter), std::string::npos) << program;
      const std::vector<double> numbers = status.diagnostic().numbers();
      ASSERT_FALSE(numbers.empty());
      EXPECT_TRUE(numbers[0] == value || std::isnan(value)) << cxx;
    }
  }
}

pcl::PointCloud<Point>::Ptr
cap()
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<Point>>();
  for (int i = 0; i < 2000; ++i) { // a spiral of Vogel's on a sphere of radius 100
    const double r = 35.0 * std::sqrt((i + 0.5) / 2000.0), angle = 2.399963 * i;
    cloud->emplace_back(static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)),
                        static_cast<float>(std::sqrt(1e4 - r * r)));
  }
  return cloud;
}

TEST(settings, numbersOutOfRangeAreRefusedByTheClasses)
{
  const auto cloud = cap();
  const auto none = [](const Setting&) { return false; };
  SpiralSettings spiral;
  spiral.tool_radius = 10.0;
  spiral.scallop_height = 0.3;
  spiral.centre = Eigen::Vector3d(0.0, 0.0, 100.0);
  expectRefused<SpiralSettings>(
      spiral,
      [&](const SpiralSettings& s) {
        SpiralToolpathGenerator<Point> generator;
        generator.setInputCloud(cloud);
        generator.setSettings(s);
        generator.setQuiet(true);
        pcl::PointCloud<ToolpathPoint> path;
        generator.compute(path);
        EXPECT_EQ(path.empty(), !generator.getStatus().ok());
        return generator.getStatus();
      },
      none);
  expectRefused<SurfaceSettings>(
      SurfaceSettings(),
      [&](const SurfaceSettings& s) {
        ScannedSurface<Point> scanned;
        scanned.setInputCloud(cloud);
        scanned.setSettings(s);
        scanned.setQuiet(true);
        Surface::ConstPtr surface;
        scanned.compute(surface);
        return scanned.getStatus();
      },
      none);
  DriveSettings drive;
  drive.step_over = 5.0;
  expectRefused<DriveSettings>(
      drive, [](const DriveSettings& s) { return checkSettings(s); },
      [](const Setting& setting) { return setting.name == "step_over"; }); // its message asks for one
  RidgeRowSettings rows;
  rows.step_over = 2.0;
  Polyline rail, generator;
  for (int i = 0; i <= 50; ++i) {
    rail.emplace_back(i * 4.0, 0.0, 0.0);
    generator.emplace_back(0.0, i - 25.0, -0.01 * (i - 25.0) * (i - 25.0));
  }
  RidgeSurface::ConstPtr surface;
  ASSERT_TRUE(RidgeSurface::make(rail, generator, RidgeSettings(), surface).ok());
  expectRefused<RidgeRowSettings>(
      rows,
      [&](const RidgeRowSettings& s) {
        DrivePasses passes;
        RidgeRowReport report;
        return planRidgeRows(*surface, s, passes, report);
      },
      [](const Setting& setting) { return setting.name == "spot" || setting.name == "scallop"; }); // two distances of rows
  expectRefused<PassSettings>(
      PassSettings(),
      [](const PassSettings& s) {
        return Status(rangeFault(s).empty() ? Status::success() : Status(StatusCode::InvalidArgument, rangeFault(s)));
      },
      none);
  expectRefused<ProgramSettings>(
      ProgramSettings(),
      [](const ProgramSettings& s) {
        MachineProgramGenerator programs;
        programs.setMachine(xyzacTrunnion());
        ToolPose pose;
        pose.contact = pose.tip = Eigen::Vector3d::Zero();
        pose.axis = Eigen::Vector3d::UnitZ();
        ToolPose next = pose;
        next.contact.x() = next.tip.x() = 5.0;
        programs.setInputPoses({pose, next});
        programs.setSettings(s);
        programs.setQuiet(true);
        MachineProgram program;
        programs.compute(program);
        return programs.getStatus();
      },
      none);
  expectRefused<RidgeSettings>(
      RidgeSettings(),
      [&](const RidgeSettings& s) {
        RidgeSurface::ConstPtr made;
        return RidgeSurface::make(rail, generator, s, made);
      },
      none);
}

TEST(settings, aSurfaceRefusesSettingsThatItWasNotMadeWith)
{
  SurfaceSettings any;
  const std::size_t count = settingTable(any).size();
  for (std::size_t i = 0; i < count; ++i) {
    SurfaceSettings asked;
    const Setting setting = settingTable(asked)[i];
    std::visit(Change{setting}, setting.target);
    EXPECT_EQ(disagreement(asked, asked), Diagnostic()) << setting.name;
    EXPECT_EQ(disagreement(SurfaceSettings(), asked), Diagnostic()) << "a default agrees with everything: " << setting.name;
    const Diagnostic said = disagreement(asked, SurfaceSettings());
    const bool compared = setting.name != "threads" && setting.name != "trust_normals" && setting.name != "outlier_deviations";
    EXPECT_EQ(said.text(), compared ? setting.setter : "");
  }
}

/** The values that a setting takes: "above 0 mm", "auto, one, two". */
std::string
valuesOf(Setting setting)
{
  if (const auto* choice = std::get_if<ChoiceTarget>(&setting.target)) {
    std::string words;
    for (const char letter : choice->words)
      words += letter == '|' ? std::string(", ") : std::string(1, letter);
    return words;
  }
  setting.example.clear();
  const std::string must = "must be ";
  const bool is_number = numberOf(setting) || std::holds_alternative<std::optional<double>*>(setting.target);
  return is_number ? ruleOf(setting).text().substr(must.size()) : std::holds_alternative<bool*>(setting.target) ? "yes, no" : "X,Y,Z";
}

/** A setting as a row of doc/settings.md. */
std::string
rowOf(const Setting& setting)
{
  const std::string value = textOf(setting);
  const std::optional<double> number = numberOf(setting);
  const bool needed = number && !setting.range.takes(*number), is_zero = value.empty() || value == "0";
  const std::string by_default = needed ? "must be set" : !is_zero ? value : !setting.zero.empty() ? setting.zero : number ? value : "none";
  const std::string option = setting.option.empty() ? "" : "`--" + setting.option + "`";
  return "| `" + setting.name + "` | `" + setting.setter + "` | " + option + " | " + by_default + " | " + valuesOf(setting) + " | " +
         setting.help + " |\n";
}

template <typename Settings>
std::string
tableOf(const char* heading, const char* what, Settings settings)
{
  std::string text =
      std::string("\n## ") + heading + "\n" + what + "\n\n| name | C++ | option | default | values | what |\n|---|---|---|---|---|---|\n";
  for (const Setting& setting : settingTable(settings))
    text += rowOf(setting);
  return text;
}

TEST(settings, aJudgeTakesNoNumberOutOfItsRange)
{
  PathVerifier<Point> verifier;
  verifier.setInputCloud(pcl::make_shared<pcl::PointCloud<Point>>(3, 1));
  verifier.setInputToolpath(pcl::make_shared<pcl::PointCloud<ToolpathPoint>>(2, 1));
  verifier.setCutter(CutterShape::ball(3.0));
  const auto said = [&] {
    Verification found;
    verifier.compute(found);
    return verifier.getStatus().message();
  };
  Limits limits;
  limits.gouge = -0.1;
  verifier.setLimits(limits);
  EXPECT_EQ(said(), "the limit on gouges is -0.1 mm: it must be 0 mm or more, such as 0.01 (Limits::gouge)");
  verifier.setLimits({});
  verifier.setChordError(0.0);
  EXPECT_EQ(said(), "the chord error is 0 mm: it must be above 0 mm, such as 0.002 (setChordError)");
  verifier.setChordError(0.005);
  verifier.setSampleSpacing(-1.0);
  EXPECT_NE(said().find("the sample spacing is -1 mm"), std::string::npos);
}

TEST(settings, thePageHasTheTables)
{
  const std::string tables =
      tableOf("Spiral", "`SpiralSettings`: `SpiralToolpathGenerator`, `SpiralPlanner`, `pcl_spiral_toolpath`.", SpiralSettings()) +
      tableOf("Drive path", "`DriveSettings`: `DrivePath`, `DrivePlanner`, `pcl_spiral_drive`.", DriveSettings()) +
      tableOf("Tool of passes", "`PassSettings`: `DrivePlanner`, `RidgePlanner`, `pcl_spiral_drive`, `pcl_spiral_ridge`.", PassSettings()) +
      tableOf("Ridge", "`RidgeSettings`: `RidgeToolpath`, `RidgePlanner`, `pcl_spiral_ridge`.", RidgeSettings()) +
      tableOf("Rows over a ridge", "`RidgeRowSettings`: `RidgeToolpath`, `RidgePlanner`, `pcl_spiral_ridge`.", RidgeRowSettings()) +
      tableOf("Mesh", "`MeshSettings`: `SurfaceMesh`, `pcl_spiral_drive --mesh`.", MeshSettings()) +
      tableOf("Program", "`ProgramSettings`: `MachineProgramGenerator`, `ProgramPlanner`, all programs that write machine programs.",
              ProgramSettings()) +
      tableOf("Judge", "`PathVerifier`, `pcl_spiral_verify`, `pcl_spiral_view`; as C++ calls them, setters of `PathVerifier`.",
              JudgeSettings()) +
      tableOf("Limits", "`Limits`: `PathVerifier`, `pcl_spiral_verify`, `pcl_spiral_toolpath --verify`.", Limits());
  std::ifstream file(PCL_SPIRAL_MACHINES_DIR "/../../pcl_spiral/doc/settings.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::size_t first = page.find("\n## ");
  ASSERT_NE(first, std::string::npos);
  if (page.substr(first) == tables)
    return;
  std::ofstream("settings.md") << page.substr(0, first) << tables;
  ADD_FAILURE() << "pcl_spiral/doc/settings.md has other tables; the right ones are in settings.md beside this test's output";
}

} // namespace
} // namespace settings_test
