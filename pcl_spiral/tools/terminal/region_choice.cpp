// SPDX-License-Identifier: BSD-3-Clause
#include "region_choice.h"

#include "scan_places.h"

#include "common/formatted_text.h"
#include "common/shell_word.h"
#include <pcl_spiral/io/polygon_reader.h>

using namespace pcl_spiral;

namespace {

std::string
optionText(const Eigen::Vector3d& place)
{
  return formatted("--part-at %.10g,%.10g,%.10g", place.x(), place.y(), place.z());
}

std::string
textOfRegion(const PartOptions& part)
{
  std::string text = part.region.empty() ? "" : "--region " + shellFile(part.region);
  if (part.part_at)
    text += (text.empty() ? "" : " ") + optionText(*part.part_at);
  return text;
}

} // namespace

const char* const part_at_help =
    "a place on the part, in the coordinates of the file: of several separate parts use the nearest one; given several times, each of "
    "these parts is a region with its own path: --part-at 120,80,15";
const char* const region_help =
    "cut only the points over and under this polygon, inside the crop; given several times, each is a region with its own path, in this "
    "order, the tool lifted between them: --region left.txt --region right.txt";

std::vector<Option>
regionOptions(PartOptions& choice, RegionChoice& regions)
{
  std::vector<Option> options{
      {"part-at", "X,Y,Z", part_at_help, [&regions](const std::string& value) { regions.places.push_back(placeValue("part-at", value)); },
       true},
      {"region", "FILE", region_help, [&regions](const std::string& value) { regions.polygons.push_back(value); }, true}};
  for (const Option& option : placeOptions(choice))
    if (option.name != "part-at")
      options.push_back(option);
  return options;
}

std::vector<InputName>
polygonFiles(const PartOptions& choice, const RegionChoice& regions)
{
  std::vector<InputName> files = polygonFiles(choice);
  for (const std::string& file : regions.polygons)
    files.push_back({"a region", file});
  return files;
}

std::vector<NamedRegion>
regionsOf(const PartOptions& choice, const RegionChoice& regions, const ReadOptions& asked)
{
  const ReadOptions read = readAsScan(asked);
  std::vector<NamedRegion> found;
  const auto add = [&](const std::string& polygon, const std::optional<Eigen::Vector3d>& place) {
    found.push_back({choice, ""});
    found.back().part.region = polygon;
    found.back().part.part_at = place;
  };
  std::vector<bool> is_used(regions.places.size(), regions.polygons.empty());
  for (const std::string& polygon : regions.polygons) {
    const Prism prism = readPolygon(polygon, read);
    const std::size_t before = found.size();
    for (std::size_t i = 0; i < regions.places.size(); ++i)
      if (prism.contains(placeInScan(regions.places[i], read))) {
        add(polygon, regions.places[i]);
        is_used[i] = true;
      }
    if (found.size() == before)
      add(polygon, std::nullopt);
  }
  for (std::size_t i = 0; i < regions.places.size(); ++i)
    if (!is_used[i])
      throw UsageError(
          Diagnostic(optionText(regions.places[i]), ": this place is in no --region; leave it out, or give a region round it"));
  for (std::size_t i = 0; regions.polygons.empty() && i < regions.places.size(); ++i)
    add("", regions.places[i]);
  if (found.empty())
    add("", std::nullopt);
  for (std::size_t i = 0; found.size() > 1 && i < found.size(); ++i)
    found[i].name = formatted("region %zu (", i + 1) + textOfRegion(found[i].part) + ")";
  return found;
}

std::vector<PlanRegion>
planRegions(const std::vector<NamedRegion>& regions, const ReadOptions& asked)
{
  std::vector<PlanRegion> planned;
  for (const NamedRegion& region : regions) {
    const PartChoice choice = choiceOf({region.part.part_at, "", region.part.region, {}, region.part.clusters}, asked);
    planned.push_back({choice.region, choice.part_at, region.name});
  }
  return planned;
}
