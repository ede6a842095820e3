// SPDX-License-Identifier: BSD-3-Clause
#include "run_table.h"

#include <cmath>
#include <cstdio>

namespace pcl_spiral::benchmarks {

namespace {

/** A number, or NaN if there is none. */
double
number(const Json& json, const char* key)
{
  return json.contains(key) && json.at(key).is_number() ? json.at(key).get<double>() : std::nan("");
}

std::string
word(const Json& json, const char* key)
{
  return json.at(key).get<std::string>();
}

std::string
format(const char* pattern, double value)
{
  if (std::isnan(value))
    return "-";
  char text[40];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

void
printStages(const Json& ours)
{
  const double whole = number(ours, "seconds");
  std::printf("| stage | s | %% | MB at its end | most until then |\n|---|---|---|---|---|\n");
  for (const Json& stage : ours.at("stages"))
    std::printf("| %s | %.3f | %.1f | %.0f | %.0f |\n", word(stage, "name").c_str(), number(stage, "seconds"),
                100.0 * number(stage, "seconds") / whole, number(stage, "resident_mb"), number(stage, "peak_mb"));
}

} // namespace

void
printRun(const Json& run)
{
  const Json& ours = run.at("ours");
  std::printf("\n%s, h %g, %s file order, %.0f threads\n\n", word(run, "case").c_str(), number(run, "scallop"), word(run, "order").c_str(),
              number(run, "threads"));
  printStages(ours);
  std::printf("\n%.0f radial lines, %.0f turns, %.0f path points; CSV's CRC-32 %s\n", number(ours, "radial_lines"), number(ours, "turns"),
              number(ours, "path_points"), word(ours, "csv_crc").c_str());
  if (run.contains("pcl"))
    std::printf("PCL: normals %.2f s, boundary points %.2f s, peak %.0f MB; processor time ours %.2f s, PCL's %.2f s\n",
                number(run["pcl"], "normals"), number(run["pcl"], "boundary"), number(run["pcl"], "peak_mb"),
                number(ours, "processor_seconds"), number(run["pcl"], "processor_seconds"));
  std::fflush(stdout);
}

void
printTable(const Json& runs)
{
  std::printf(
      "\n| case | h | order | threads | ours, s | PCL pair, s | ratio | of processor time | peak MB | B a cloud point | path points "
      "| deviation max | rms | longest move / allowed | length / least |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Json& run : runs) {
    if (run.contains("error")) {
      std::printf("| %s | %g | %s | %.0f | %s |\n", word(run, "case").c_str(), number(run, "scallop"), word(run, "order").c_str(),
                  number(run, "threads"), word(run, "error").c_str());
      continue;
    }
    const Json& ours = run.at("ours");
    const Json pcl = run.contains("pcl") ? run.at("pcl") : Json::object();
    const double work = number(ours, "processor_seconds") / number(pcl, "processor_seconds");
    std::printf("| %s | %g | %s | %.0f | %.2f | %s | %s | %s | %.0f | %.0f | %.0f | %.5f | %.5f | %.3f | %s |\n", word(run, "case").c_str(),
                number(run, "scallop"), word(run, "order").c_str(), number(run, "threads"), number(ours, "seconds"),
                format("%.2f", number(pcl, "seconds")).c_str(), format("%.2f", number(run, "ratio")).c_str(), format("%.2f", work).c_str(),
                number(ours, "peak_mb"), number(ours, "bytes_a_cloud_point"), number(ours, "path_points"), number(ours, "deviation_max"),
                number(ours, "deviation_rms"), number(ours, "longest_move") / number(ours, "largest_allowed_step"),
                format("%.4f", number(ours, "length_ratio")).c_str());
  }
}

} // namespace pcl_spiral::benchmarks
