#include "setter_names.h"

#include <array>
#include <utility>

namespace {

/** Longer names stand before names that they begin with. */
constexpr std::array<std::pair<const char*, const char*>, 23> words{{
    {"setThinning", "--thin"},
    {"setLargestPart", "--largest"},
    {"setViewPoint", "--view-point"},
    {"setFlipNormals", "--flip-normals"},
    {"setOutlierRemoval", "--outliers"},
    {"setGapHandling", "--gaps"},
    {"setBoundaryMode", "--boundaries"},
    {"setLineMethod", "--lines"},
    {"setCenter", "--center"},
    {"clearCenter", "without --center"},
    {"setMethod", "--method"},
    {"setToolRadius", "--tool-radius"},
    {"setScallopHeight", "--scallop"},
    {"setChordError", "--chord-error"},
    {"setCylinder", "--column-axis and --column-centre"},
    {"MaterialRemoval", "--verify"},
    {"StrayRemoval", "--leave-out-strays"},
    {"Scale it to mm", "Say its unit (--units m), or scale it to mm"},
    {"in another unit than mm?", "in another unit than mm (--units)?"},
    {"setNumberOfThreads", "--threads"},
    {"ReadOptions::columns", "--columns"},
    {"ReadOptions::origin", "--origin X,Y,Z"},
    {"ReadOptions::unit", "--units m, --units inch"},
}};

} // namespace

std::string
inOptions(std::string message)
{
  for (const auto& [setter, option] : words) {
    const std::string name = setter, word = option;
    for (std::size_t at = message.find(name); at != std::string::npos; at = message.find(name, at + word.size()))
      message.replace(at, name.size(), word);
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
