// SPDX-License-Identifier: BSD-3-Clause
// Machine programs from outside: from a scan to a program that LinuxCNC's interpreter runs, and messages for
// wrong command lines.
#include "command_line/cap_scan.h"
#include "command_line/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <map>
#include <random>
#include <sstream>

namespace program_test {

namespace {

const std::string program = PCL_SPIRAL_TOOLPATH_PROGRAM;
const std::string machines = PCL_SPIRAL_MACHINES_DIR;

RunResult
run(const ScratchFolder& folder, std::vector<std::string> arguments)
{
  writeText(folder.path("cap.xyz"), capScan(3000));
  const std::vector<std::string> begin{"cap.xyz", "--tool-radius", "8", "--scallop", "0.2"};
  arguments.insert(arguments.begin(), begin.begin(), begin.end());
  return endOf(startProgram(program, arguments, folder), folder);
}

void
expectHas(const std::string& text, const std::string& part)
{
  EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' in: " << text;
}

/** Runs LinuxCNC's interpreter, with M428 and M429 as its configurations have them, on \p file; it writes canon.txt and messages.txt. */
int
interpret(const ScratchFolder& folder, const std::string& file)
{
  const std::string call = "export HOME='" + folder.root().string() + "'; cd '" + machines + "/rs274' && rs274 -i rs274.ini -g '" +
                           folder.path(file) + "' '" + folder.path("canon.txt") + "' 2>'" + folder.path("messages.txt") + "'";
  return std::system(call.c_str());
}

std::size_t
linesWith(const std::string& text, const std::string& part)
{
  std::istringstream stream(text);
  std::size_t count = 0;
  for (std::string line; std::getline(stream, line);)
    count += line.find(part) != std::string::npos;
  return count;
}

} // namespace

TEST(Program, FromAScanToWhatTheInterpreterRuns)
{
  const ScratchFolder folder;
  const RunResult done = run(folder, {"-o", "part.ngc", "-o", "part.csv", "--machine", machines + "/xyzac.yaml", "--spindle", "9000"});
  ASSERT_EQ(done.code, 0) << done.err;
  expectHas(done.out, "program         xyzac-trt: ");
  expectHas(done.out, "rotary axes     C ");
  const std::string text = readText(folder.path("part.ngc"));
  const std::size_t rows = linesWith(readText(folder.path("part.csv")), ",") - 1;
  EXPECT_GE(linesWith(text, "G1 X"), rows);
  ASSERT_EQ(interpret(folder, "part.ngc"), 0) << "run cmake/install_dependencies.sh test where rs274 is missing: "
                                              << readText(folder.path("messages.txt"));
  EXPECT_EQ(linesWith(readText(folder.path("canon.txt")), "STRAIGHT_FEED("), linesWith(text, "G1 X"));
}

TEST(Program, TheTimeOnTheControlIsThatOfTheFirstProgram)
{
  const ScratchFolder folder;
  const RunResult slow = run(folder, {"-o", "part.ngc", "-o", "part.json", "--machine", machines + "/xyzac.yaml", "--feed", "5000"});
  ASSERT_EQ(slow.code, 0) << slow.err;
  expectHas(slow.out, " on LinuxCNC with usual accelerations: ");
  expectHas(slow.out, "would gain most a control that rounds corners of rotary moves");
  const std::string json = readText(folder.path("part.json"));
  for (const nlohmann::json& gain : nlohmann::json::parse(json).at("motion").at("gains"))
    EXPECT_NE(gain.at("change"), "chord_error") << "planned again although nobody asked";
  for (const char* name : {"\"motion\": {", "\"control\": \"LinuxCNC\"", "\"rotary\": ", "\"rotary_blend\""})
    expectHas(json, name);
  const RunResult fast =
      run(folder, {"-o", "part.mpf", "--machine", machines + "/head_head.yaml", "--tool", "3", "--feed", "5000", "--smoothing", "0.02"});
  ASSERT_EQ(fast.code, 0) << fast.err;
  expectHas(fast.out, " on Siemens with usual accelerations: ");
}

TEST(Program, TheGainsOfOtherSettingsAreThoseOfRunsWithThem)
{
  const ScratchFolder folder;
  const auto motionOf = [&](const std::vector<std::string>& more) {
    std::vector<std::string> call{"-o", "part.json", "-o", "part.ngc", "--machine", machines + "/xyzac.yaml", "--feed", "5000", "--quiet"};
    call.insert(call.end(), more.begin(), more.end());
    const RunResult done = run(folder, call);
    EXPECT_EQ(done.code, 0) << done.err;
    return nlohmann::json::parse(readText(folder.path("part.json"))).at("motion");
  };
  const nlohmann::json study = motionOf({"--gains"});
  const double now = study.at("seconds");
  std::map<std::string, double> gains;
  for (const nlohmann::json& gain : study.at("gains"))
    gains[gain.at("change")] = gain.at("seconds");
  ASSERT_EQ(gains.count("chord_error") + gains.count("axis_smoothing") + gains.count("longer_blocks"), 3U) << study;
  const auto secondsWith = [&](const std::vector<std::string>& more) { return motionOf(more).at("seconds").get<double>(); };
  EXPECT_NEAR(gains["chord_error"], now - secondsWith({"--chord-error", "0.01"}), 1e-6);
  EXPECT_NEAR(gains["axis_smoothing"], now - secondsWith({"--axis-smoothing", "100"}), 1e-6);
  EXPECT_NEAR(gains["longer_blocks"], now - secondsWith({"--thin-blocks", "0.005,0.14323944878270581"}), 1e-6);
  EXPECT_NE(gains["longer_blocks"], 0.0);
  const RunResult idle = run(folder, {"-o", "part.csv", "--gains"});
  EXPECT_EQ(idle.code, 2);
  expectHas(idle.err, "--gains: no output is a program");
}

TEST(Program, EveryLanguageAndExchangeFileIsWritten)
{
  const ScratchFolder folder;
  for (const std::string dialect : {"linuxcnc", "fanuc", "fanuc-ijk", "siemens", "heidenhain"}) {
    const std::string machine = machines + (dialect == "fanuc-ijk" ? "/xyzac.yaml" : "/head_head.yaml"); // a vector cannot unwind C
    const RunResult done = run(folder, {"-o", dialect + ".nc", "--dialect", dialect, "--machine", machine, "--tool", "3", "--quiet"});
    ASSERT_EQ(done.code, 0) << done.err;
  }
  const std::string fork_head = machines + "/head_head.yaml";
  ASSERT_EQ(run(folder, {"-o", "part.mpf", "-o", "part.h", "--machine", fork_head, "--tool", "3", "--quiet"}).code, 0);
  EXPECT_EQ(readText(folder.path("part.mpf")), readText(folder.path("siemens.nc")));
  EXPECT_EQ(readText(folder.path("part.h")).substr(readText(folder.path("part.h")).find('\n')),
            readText(folder.path("heidenhain.nc")).substr(readText(folder.path("heidenhain.nc")).find('\n')));
  const RunResult unwinding =
      run(folder, {"-o", "x.nc", "--dialect", "fanuc-ijk", "--machine", machines + "/head_head.yaml", "--tool", "3", "--quiet"});
  EXPECT_EQ(unwinding.code, 1);
  expectHas(unwinding.err, "C turns back at its limit, and fanuc-ijk has no words for it; use fanuc");
  expectHas(readText(folder.path("linuxcnc.nc")), "G93\n");
  expectHas(readText(folder.path("fanuc.nc")), "G43.4 H3 X");
  expectHas(readText(folder.path("fanuc-ijk.nc")), "G43.5 H3 X");
  expectHas(readText(folder.path("siemens.nc")), "TRAORI\n");
  expectHas(readText(folder.path("heidenhain.nc")), " M128\n");
  const RunResult done = run(folder, {"-o", "a.apt", "-o", "b.cls", "-o", "c.yaml", "--quiet"});
  ASSERT_EQ(done.code, 0) << done.err;
  EXPECT_EQ(readText(folder.path("a.apt")), readText(folder.path("b.cls")));
  expectHas(readText(folder.path("a.apt")), "CUTTER/16.000000,8.000000,");
  expectHas(readText(folder.path("c.yaml")), "# place: tip of the tool; z: tool axis");
  EXPECT_EQ(linesWith(readText(folder.path("c.yaml")), "- - - - {x: "), 1U);
  ASSERT_EQ(run(folder, {"-o", "d.yaml", "--robot-z", "normal", "--quiet"}).code, 0);
  expectHas(readText(folder.path("d.yaml")), "# place: contact; z: normal of the surface");
  const RunResult refused = run(folder, {"-o", "d.csv", "--robot-z", "normal"});
  EXPECT_EQ(refused.code, 2);
  expectHas(refused.err, "--robot-z: no output has robot frames; add an output .yaml, or leave it out");
}

/** A flat L as the text of an .xyz file. */
std::string
ellScan()
{
  std::ostringstream text;
  for (int i = 0; i <= 70; ++i)
    for (int k = 0; k <= 80; ++k)
      if (i <= 34 || k <= 30)
        text << i + 0.2 * std::sin(3.0 * i + 7.0 * k) << ' ' << k + 0.2 * std::cos(5.0 * i + 2.0 * k) << " 0\n";
  return text.str();
}

TEST(Program, OneWayPathsAreLiftedBetweenPassesInEveryFormat)
{
  const ScratchFolder folder;
  writeText(folder.path("ell.xyz"), ellScan());
  const auto called = [&folder](std::vector<std::string> arguments) {
    const std::vector<std::string> begin{"ell.xyz", "--tool-radius", "5", "--scallop", "0.1", "--method", "constant-scallop", "--one-way"};
    arguments.insert(arguments.begin(), begin.begin(), begin.end());
    return endOf(startProgram(program, arguments, folder), folder);
  };
  const RunResult done = called({"-o", "a.nc", "-o", "a.csv", "-o", "a.json", "--dialect", "linuxcnc", "--tool", "3", "--machine",
                                 machines + "/xyzac.yaml", "--verify"});
  ASSERT_EQ(done.code, 0) << done.err;
  expectHas(done.out, "; 0 % against the requested sense");
  expectHas(done.out, "passes          3, ");
  expectHas(readText(folder.path("a.json")), "\"passes\": 3");
  expectHas(readText(folder.path("a.json")), "\"one_way\": true");
  std::istringstream lines(readText(folder.path("a.nc")));
  std::size_t cuts = 0;
  bool cutting = false;
  for (std::string line; std::getline(lines, line);) {
    const bool feeds = line.rfind("G1 ", 0) == 0;
    cuts += feeds && !cutting;
    cutting = feeds;
  }
  EXPECT_EQ(cuts, 3u); // rapids between
  const RunResult exchanged = called({"-o", "b.apt", "-o", "b.yaml"});
  ASSERT_EQ(exchanged.code, 0) << exchanged.err;
  EXPECT_EQ(linesWith(readText(folder.path("b.apt")), "RAPID"), 3u * 3u); // on a plane the end of the climb is the top
  EXPECT_EQ(linesWith(readText(folder.path("b.yaml")), "- - {x: "), 3u);  // segments
}

TEST(Program, CodesStandBeforeAndAfterThePass)
{
  const ScratchFolder folder;
  const RunResult done = run(folder, {"-o", "a.ngc", "-o", "b.nc", "--dialect", "heidenhain", "--tool", "3", "--machine",
                                      machines + "/xyzac.yaml", "--pass-begin", "M62 P0", "--pass-end", "M63 P0", "--quiet"});
  ASSERT_EQ(done.code, 0) << done.err;
  for (const char* code : {"M62 P0", "M63 P0"}) {
    EXPECT_EQ(linesWith(readText(folder.path("a.ngc")), code), 1U);
    EXPECT_EQ(linesWith(readText(folder.path("b.nc")), std::string(" ") + code), 1U); // its lines are numbered
  }
  ASSERT_EQ(interpret(folder, "a.ngc"), 0) << readText(folder.path("messages.txt"));
  EXPECT_EQ(linesWith(readText(folder.path("canon.txt")), "SET_MOTION_OUTPUT_BIT(0)"), 1U);
  EXPECT_EQ(linesWith(readText(folder.path("canon.txt")), "CLEAR_MOTION_OUTPUT_BIT(0)"), 1U);
  writeText(folder.path("job.yaml"), "output: c.ngc\nmachine: " + machines + "/xyzac.yaml\npass-begin: M62 P0\npass-end: M63 P0\n");
  ASSERT_EQ(run(folder, {"--config", "job.yaml", "--quiet"}).code, 0);
  EXPECT_EQ(linesWith(readText(folder.path("c.ngc")), "M62 P0"), 1U);
}

TEST(Program, AJobFileHoldsTheSameNames)
{
  const ScratchFolder folder;
  writeText(folder.path("job.yaml"), "output: [a.nc, a.png]\nmachine: " + machines +
                                         "/xyzbc.yaml\ndialect: fanuc\nlead-in: arc\nlead-length: "
                                         "3\nthin-blocks: [0.01, 0.2]\ndecimals: 5\ntool: 2\n");
  const RunResult done = run(folder, {"--config", "job.yaml"});
  ASSERT_EQ(done.code, 0) << done.err;
  expectHas(readText(folder.path("a.nc")), " B");
  EXPECT_EQ(done.out.find(" 0 left out"), std::string::npos) << done.out;
  for (const char* picture : {"a.png", "a_lines.png", "a_rotary.png"})
    EXPECT_TRUE(std::filesystem::exists(folder.path(picture))) << picture;
}

TEST(Program, WithoutAMachineFileTheMessageSaysWhatWasTaken)
{
  const ScratchFolder folder;
  const RunResult done = run(folder, {"-o", "part.ngc"});
  ASSERT_EQ(done.code, 0) << done.err;
  expectHas(done.err, "no --machine is given: the program is for LinuxCNC's xyzac-trt-kins");
  expectHas(done.err, "no retract_z is given");
  expectHas(readText(folder.path("part.ngc")), "\nG43\n"); // of the loaded tool
}

TEST(Program, TheJudgeTakesTheLanguageOfTheName)
{
  const ScratchFolder folder;
  for (const std::string name : {"a.ngc", "a.mpf", "a.h"}) {
    const RunResult done =
        endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM,
                           {"cap.xyz", name, "--machine", machines + "/xyzac.yaml", "--tool-radius", "8", "--dialect", "fanuc"}, folder),
              folder);
    EXPECT_EQ(done.code, 2) << done.err;
    expectHas(done.err, name + ": is always for ");
  }
}

TEST(Program, WrongCallsAreRefusedBeforeTheScanIsRead)
{
  const ScratchFolder folder;
  const std::string machine = machines + "/xyzac.yaml";
  const auto said = [&folder](const std::vector<std::string>& arguments, int code) {
    const RunResult done = run(folder, arguments);
    EXPECT_EQ(done.code, code) << done.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path("a.nc")));
    EXPECT_FALSE(std::filesystem::exists(folder.path("a.ngc")));
    return done.err;
  };
  expectHas(said({"-o", "a.nc", "--dialect", "fanuc"}, 2), "-o a.nc: no --machine is given");
  expectHas(said({"-o", "a.nc", "--machine", machine}, 2), "no --dialect is given; it must be one of linuxcnc|fanuc|");
  expectHas(said({"-o", "a.nc", "--machine", machine, "--dialect", "fanuc"}, 2), "-o a.nc: no --tool is given");
  expectHas(said({"-o", "a.ngc", "--machine", machine, "--dialect", "siemens"}, 2), "--dialect: no output is in the language siemens");
  expectHas(said({"-o", "a.mpf", "--machine", machine, "--dialect", "fanuc", "--tool", "3"}, 2), "a .mpf for Siemens");
  expectHas(said({"-o", "a.h"}, 2), "-o a.h: no --machine is given");
  expectHas(said({"-o", "a.h", "--machine", machine}, 2), "-o a.h: no --tool is given");
  expectHas(said({"-o", "a.ngc", "--machine", machine, "--coolant", "through"}, 1), "a.ngc: coolant through the spindle has another word");
  expectHas(said({"-o", "a.ngc", "--coolant", "through"}, 1), "give it in the machine file, such as program: {coolant: {through: M88}}");
  expectHas(said({"-o", "a.ngc", "--feed-mode", "per-minute"}, 1), "a.ngc: a feed in mm/min of the tip needs fanuc");
  expectHas(said({"-o", "a.ngc", "--feed-mode", "per-minute"}, 1), "instead (--feed-mode inverse-time)");
  const std::vector<std::pair<std::string, std::string>> words{
      {"--coolant", "flood"},        {"--spindle", "9000"},    {"--spindle-direction", "ccw"}, {"--tool", "3"},         {"--decimals", "3"},
      {"--feed-mode", "per-minute"}, {"--line-numbers", "10"}, {"--smoothing", "0"},           {"--work-offset", "G55"}};
  for (const auto& [option, value] : words)
    expectHas(said({"-o", "a.csv", option, value}, 2), option + ": no output is a program");
  expectHas(said({"-o", "a.apt", "--feed-mode", "per-minute"}, 2), "--feed-mode: no output is a program; write one such as part.ngc");
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.csv")));
  expectHas(said({"-o", "a.ngc", "--machine", machine, "--block-tolerance", "1e-9,1e-9"}, 2), "must be 0.0001 mm");
  expectHas(said({"-o", "a.nc", "--machine", machine, "--dialect", "okuma"}, 2), "--dialect okuma: must be one of");
  expectHas(said({"-o", "a.ngc", "--machine", "none.yaml"}, 1), "none.yaml: there is no such machine file");
  expectHas(said({"-o", "a.ngc", "--machine", machine, "--clearance", "0"}, 2), "--clearance 0: must be above 0 mm");
  expectHas(said({"-o", "a.ngc", "--machine", machine, "--decimals", "2"}, 2), "--decimals 2: must be from 3 to 6");
  expectHas(said({"-o", "a.ngc", "--machine", machine, "--thin-blocks", "1"}, 2), "--thin-blocks 1: give mm for the tip and degrees");
  const std::vector<std::string> on{"--pass-begin", "M62 P0"}, off{"--pass-end", "M63 P0"};
  const auto codes = [&](const std::string& output, std::vector<std::string> begin, const std::vector<std::string>& end) {
    begin.insert(begin.begin(), {"-o", output});
    begin.insert(begin.end(), end.begin(), end.end());
    return said(begin, 2);
  };
  expectHas(codes("a.ngc", on, {}),
            "--pass-begin M62 P0: is given without the other, and a beam that is never switched off burns the part; give both");
  expectHas(codes("a.ngc", {}, off), "--pass-end M63 P0: is given without the other");
  expectHas(codes("a.csv", on, off), "--pass-begin M62 P0: no output is a program; add an output .ngc, .nc, .mpf or .h, or leave it out");
  expectHas(codes("a.ngc", on, {"--pass-end", "M63 P0\nM3"}), "the code has a line break");
  expectHas(codes("a.ngc", {"--pass-begin", "M62 (on)"}, off), "--pass-begin M62 (on): the code has (, which belongs to comments");
  expectHas(codes("a.ngc", {"--pass-begin", "%"}, off), "--pass-begin %: the code has %, which ends the program");
  expectHas(codes("a.ngc", {"--pass-begin", " "}, off), "the code has only spaces; give one line such as M62 P0");
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.csv")));
  expectHas(said({"-o", "a.nc", "--machine", machines + "/head_table.yaml", "--dialect", "siemens", "--tool", "1"}, 1), "rtcp: false");
}

/** Across the well, the tool axis, near the normal, points to the other side. */
TEST(Program, LeadsIntoTheOtherSideOfAWellAreRefused)
{
  const ScratchFolder folder;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::ostringstream well; // half an ellipsoid from inside, 60 mm deep and 40 across
  for (int i = 0; i < 9000; ++i) {
    const double z = -60.0 + 50.0 * unit(random), angle = 2.0 * M_PI * unit(random);
    const double r = 20.0 * std::sqrt(1.0 - z * z / 3600.0);
    well << r * std::cos(angle) << ' ' << r * std::sin(angle) << ' ' << z << '\n';
  }
  writeText(folder.path("well.xyz"), well.str());
  const auto made = [&](const std::vector<std::string>& more) {
    std::vector<std::string> call{
        "well.xyz", "--tool-radius", "5", "--scallop", "0.2", "-o", "part.ngc", "--machine", machines + "/head_head.yaml"};
    call.insert(call.end(), more.begin(), more.end());
    return endOf(startProgram(program, call, folder), folder);
  };
  const RunResult refused = made({});
  EXPECT_EQ(refused.code, 1);
  expectHas(refused.err, "a shank as wide as the cutter would be ");
  expectHas(refused.err, " mm deep in the part ");
  expectHas(refused.err, "--accept-collisions");
  EXPECT_FALSE(std::filesystem::exists(folder.path("part.ngc")));
  const RunResult accepted = made({"--accept-collisions"});
  EXPECT_EQ(accepted.code, 0) << accepted.err;
  expectHas(accepted.err, "warning: a shank as wide as the cutter would be ");
}

TEST(Program, OnlyOutliersInTheWayOfLeadsAreAWarning)
{
  const ScratchFolder folder;
  std::mt19937 random(8);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::ostringstream echoes; // in the air above the cap
  for (int i = 0; i < 150; ++i)
    echoes << 40.0 * unit(random) << ' ' << 40.0 * unit(random) << ' ' << 25.0 + 15.0 * unit(random) << '\n';
  writeText(folder.path("echoes.xyz"), capScan(20000) + echoes.str());
  const RunResult done =
      endOf(startProgram(program, {"echoes.xyz", "--tool-radius", "8", "--scallop", "0.2", "-o", "part.ngc"}, folder), folder);
  EXPECT_EQ(done.code, 0) << done.err;
  expectHas(done.err, "only single points off the scanned surface");
}

TEST(Program, AMachineThatCannotMakeItIsNamedAndNothingIsWritten)
{
  const ScratchFolder folder;
  std::string text = readText(machines + "/xyzac.yaml");
  text.replace(text.find("[-100, 120]"), 11, "[-2, 2]");
  writeText(folder.path("stiff.yaml"), text);
  const RunResult done = run(folder, {"-o", "a.ngc", "-o", "a.csv", "--machine", "stiff.yaml"});
  EXPECT_EQ(done.code, 1);
  for (const char* part : {"stiff.yaml: block ", ": A would be at ", "limit of ", "turn the part"})
    expectHas(done.err, part);
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.ngc")));
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.csv")));
}

/** Where the spindle stands still, one line says so; a speed, or a line of the shop that starts it, takes the warning away. */
TEST(Program, ASpindleThatStandsStillIsWarnedOf)
{
  const ScratchFolder folder;
  const std::string warning = "part.nc: the spindle stands still: no --spindle is given, and no line of the machine file starts it; give "
                              "--spindle 12000";
  const std::vector<std::string> siemens{"-o", "part.nc", "--dialect", "siemens", "--tool", "3", "--machine"};
  const auto with = [&](const std::string& machine, std::vector<std::string> more) {
    std::vector<std::string> all = siemens;
    all.push_back(machine);
    all.insert(all.end(), more.begin(), more.end());
    const RunResult done = run(folder, all);
    EXPECT_EQ(done.code, 0) << done.err;
    return done.err;
  };
  EXPECT_EQ(linesWith(with(machines + "/head_head.yaml", {}), warning), 1U);
  EXPECT_EQ(linesWith(with(machines + "/head_head.yaml", {"--spindle", "12000"}), "spindle"), 0U);
  writeText(folder.path("shop.yaml"), readText(machines + "/head_head.yaml") + "program: {header: [\"S8000 M3\"]}\n");
  EXPECT_EQ(linesWith(with(folder.path("shop.yaml"), {}), "spindle"), 0U);
}

/** A machine with three axes refuses a leaning tool; the option that its message names makes a program, which the judge accepts. */
TEST(Program, OfThreeAxes)
{
  const ScratchFolder folder;
  std::vector<std::string> call{"-o", "part.ngc", "--spindle", "9000", "--machine", machines + "/three_axes.yaml"};
  const RunResult refused = run(folder, call);
  EXPECT_EQ(refused.code, 1);
  expectHas(refused.err, "a machine with three axes cannot tilt the tool; make the path with the tool axis along +Z (--axis)");
  EXPECT_FALSE(std::filesystem::exists(folder.path("part.ngc")));
  call.insert(call.end(), {"--axis", "0,0,1"});
  const RunResult done = run(folder, call);
  ASSERT_EQ(done.code, 0) << done.err;
  const std::string text = readText(folder.path("part.ngc"));
  EXPECT_EQ(linesWith(text, "G93"), 0U);
  EXPECT_EQ(linesWith(text, " A"), 0U);
  const RunResult judged = endOf(startProgram(PCL_SPIRAL_VERIFY_PROGRAM,
                                              {"cap.xyz", "part.ngc", "--machine", machines + "/three_axes.yaml", "--tool-radius", "8",
                                               "--scallop", "0.2", "--max-gouge", "0.05", "--max-uncut", "1"},
                                              folder),
                                 folder);
  EXPECT_EQ(judged.code, 0) << judged.err << judged.out;
  call.insert(call.end(), {"--tilt", "10"});
  const RunResult both = run(folder, call);
  EXPECT_EQ(both.code, 2);
  expectHas(both.err, "--tilt changes the tool axis along the path, and --axis keeps it; leave one of the two out");
}

} // namespace program_test
