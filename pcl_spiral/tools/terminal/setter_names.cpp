// SPDX-License-Identifier: BSD-3-Clause
#include "setter_names.h"

#include <array>
#include <cctype>
#include <utility>

namespace {

/** Each first text is replaced by the second if the program has the first option in it. */
constexpr std::array<std::pair<const char*, const char*>, 81> words{{
    {"FeedMode", "--feed-mode inverse-time"},
    {"setFixedAxis", "--axis"},
    {"setTiltAngle", "--tilt"},
    {"setLeadAngle", "--lead"},
    {"setThinning", "--thin"},
    {"setLargestPart", "--largest"},
    {"setPartAt", "--part-at"},
    {"PartRegion", "--region"},
    {"setClusterHandling with Ride", "--clusters ride"},
    {"setClusterHandling", "--clusters leave-out"},
    {"addKeepOut", "--keep-out"},
    {"setCrop", "--crop"},
    {"setViewPoint", "--view-point"},
    {"setFlipNormals", "--flip-normals"},
    {"setOutlierRemoval", "--outliers"},
    {"setGapHandling", "--gaps"},
    {"BallReach maps the", "--reach FILE maps the"},
    {"setTightHandling refuses", "--tight refuse refuses"},
    {"setTightHandling", "--tight"},
    {"setBoundaryMode", "--boundaries"},
    {"setLineMethod", "--lines"},
    {"setCenter", "--center"},
    {"clearCenter", "without --center"},
    {"setMethod", "--method"},
    {"setPitch", "--pitch"},
    {"setSense", "--sense"},
    {"setStartPoint", "--start"},
    {"setMaxStep", "--max-step"},
    {"setHoleHandling", "--holes"},
    {"setHoleSize", "--hole-size"},
    {"setOneWay", "--one-way"},
    {"setHoleMargin", "--hole-margin"},
    {"setRimOverhang", "--rim"},
    {"setLeastTurnRadius", "--turn-radius"},
    {"setToolRadius", "--tool-radius"},
    {"setCutter", "--tool-radius, --corner-radius, --flank-length and --flank-angle"},
    {"setInputTips", "columns tip_x, tip_y, tip_z of a .csv"},
    {"setScallopHeight", "--scallop"},
    {"setScallop", "--scallop"},
    {"setPlaneDirection", "--direction"},
    {"setPlaneNormal", "--direction"},
    {"setStepOver", "--step-over"},
    {"setPointSpacing", "--point-spacing"},
    {"setAxis", "--axis"},
    {"setAxisMode", "--axis-mode"},
    {"setAxisSmoothing", "--axis-smoothing"},
    {"setMaxAxisRate", "--max-axis-rate"},
    {"setRows", "--rows"},
    {"setCeiling", "--ceiling"},
    {"setMaxRetilt", "--max-retilt"},
    {"setRetiltStep", "--retilt-step"},
    {"setChordError", "--chord-error"},
    {"setReferenceNormal", "--reference"},
    {"setMeasuringError", "--measuring-error"},
    {"setRoughPoints", "--through"},
    {"setHalfWidth", "--half-width"},
    {"setClosed", "--ring"},
    {"setSpot", "--spot and --overlap"},
    {"setStandOff", "--stand-off"},
    {"setLead", "--lead"},
    {"setTilt", "--tilt"},
    {"setCylinder", "--column-axis and --column-centre"},
    {"MaterialRemoval", "--verify"},
    {"StrayRemoval", "--leave-out-strays"},
    {"Scale it to mm", "Give its unit (--units m), or scale it to mm"},
    {"in another unit than mm?", "in another unit than mm (--units)?"},
    {"setSampleSpacing", "--sample-spacing"},
    {"setCreaseAngle", "--crease-angle"},
    {"setMeshSettings, flip", "--flip-normals"},
    {"setNumberOfThreads", "--threads"},
    {"Limits::gouge", "--max-gouge"},
    {"Limits::scallop", "--max-scallop"},
    {"Limits::deviation", "--max-deviation"},
    {"Limits::uncut", "--max-uncut"},
    {"ReadOptions::columns", "--columns"},
    {"ReadOptions::skip_lines", "--skip-lines"},
    {"ReadOptions::origin", "--origin X,Y,Z"},
    {"ReadOptions::unit", "--units m, --units ft, --units us-ft, --units inch"},
    {"ReadOptions::find_origin", "without --origin"},
    {"setSpacing", "--sample-spacing"},
    {"readCloud", "leave --mesh out"},
}};

/** "thin" of "--thin". */
std::string
optionIn(const std::string& words)
{
  const std::size_t begin = words.find("--") + 2;
  return words.substr(begin, words.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", begin) - begin);
}

bool
isNamePart(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '/' || c == '\\';
}

/** Whether the text at \p at is a whole word, not part of a longer word, a path or a file name. */
bool
isWord(const std::string& message, std::size_t at, std::size_t size)
{
  const auto in = [&](std::size_t i) { return i < message.size() && isNamePart(message[i]); };
  const std::size_t end = at + size;
  const bool name_before = at > 0 && (in(at - 1) || message[at - 1] == '.');
  const bool name_behind = in(end) || (end < message.size() && message[end] == '.' && in(end + 1));
  return !name_before && !name_behind;
}

/** Removes the brackets round \p at and the space before them. \return where to go on; without brackets the end of the name. */
std::size_t
dropBrackets(std::string& message, std::size_t at, std::size_t size)
{
  const std::size_t open = message.find_last_of("()", at), close = message.find_first_of("()", at);
  if (open == std::string::npos || close == std::string::npos || message[open] != '(' || message[close] != ')')
    return at + size;
  const std::size_t begin = open > 0 && message[open - 1] == ' ' ? open - 1 : open;
  message.erase(begin, close + 1 - begin);
  return begin;
}

} // namespace

std::string
inOptions(std::string message)
{
  for (const auto& [setter, option] : words) {
    const std::string name = setter, word = option;
    for (std::size_t at = message.find(name); at != std::string::npos; at = message.find(name, at))
      if (!isWord(message, at, name.size()))
        at += name.size();
      else if (hasOption(optionIn(word))) {
        message.replace(at, name.size(), word);
        at += word.size();
      }
      else
        at = dropBrackets(message, at, name.size());
  }
  return message;
}

std::vector<std::string>
inOptions(std::vector<std::string> messages)
{
  for (std::string& message : messages)
    message = inOptions(std::move(message));
  return messages;
}
