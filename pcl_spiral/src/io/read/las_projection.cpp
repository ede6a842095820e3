// SPDX-License-Identifier: BSD-3-Clause
#include "las_projection.h"

#include "field_layout.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <string>

namespace pcl_spiral {
namespace {

// "LAS Specification 1.4 - R15", ASPRS 2019: sections 2.6 (variable length records), 2.7 (extended ones), 3 (coordinate systems).
// Numbers of keys: "GeoTIFF Format Specification 1.0", 1995, section 6.

constexpr std::size_t record_header = 54, extended_header = 60; ///< bytes
constexpr unsigned keys_record = 34735, text_record = 2112;
constexpr unsigned model_key = 1024, geographic_key = 2048, projected_key = 3072;
constexpr unsigned geographic_model = 2, user_defined = 32767;

/** An unsigned number; 0 beyond the end. */
template <typename T>
std::size_t
numberAt(std::string_view bytes, std::size_t at)
{
  if (at > bytes.size() || bytes.size() - at < sizeof(T))
    return 0;
  return static_cast<std::size_t>(std::min(loadAs<T>(bytes.data() + at), 1e15)); // more than any file has
}

LasCoordinates
byKeys(std::string_view keys)
{
  std::size_t model = 0;
  bool geographic = false, projected = false;
  const std::size_t count = std::min(numberAt<std::uint16_t>(keys, 6), keys.size() / 8);
  for (std::size_t at = 8; at < 8 * (count + 1); at += 8) {
    const std::size_t key = numberAt<std::uint16_t>(keys, at), value = numberAt<std::uint16_t>(keys, at + 6);
    if (key == model_key)
      model = value;
    geographic = geographic || (key == geographic_key && value != 0);
    projected = projected || (key == projected_key && value != 0);
  }
  if (model == geographic_model)
    return LasCoordinates::Degrees;
  if (model != 0 && model != user_defined)
    return LasCoordinates::Metric;
  return projected ? LasCoordinates::Metric : geographic ? LasCoordinates::Degrees : LasCoordinates::Unknown;
}

/** Well-known text of OGC, version 1 or 2: a projected system has a geographic one in it. */
LasCoordinates
byText(std::string_view text)
{
  std::string plain;
  for (const char c : text)
    if (!std::isspace(static_cast<unsigned char>(c)) && c != '\0')
      plain += c == '(' ? '[' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  const auto has = [&plain](const char* word) { return plain.find(word) != std::string::npos; };
  if (has("PROJCS[") || has("PROJCRS[") || has("PROJECTEDCRS[") || has("GEOCCS["))
    return LasCoordinates::Metric;
  if (has("GEOGCS[") || has("GEOGCRS[") || has("GEOGRAPHICCRS[") || has("CS[ELLIPSOIDAL"))
    return LasCoordinates::Degrees;
  return LasCoordinates::Unknown;
}

/** What the variable length records say. */
struct LasRecords {
  LasCoordinates keys = LasCoordinates::Unknown, text = LasCoordinates::Unknown;

  /** Reads \p count records from byte \p at. */
  void read(std::string_view bytes, std::size_t at, std::size_t count, bool extended)
  {
    const std::size_t header = extended ? extended_header : record_header;
    for (std::size_t i = 0; i < count && at <= bytes.size() && bytes.size() - at >= header; ++i) {
      const std::size_t size = extended ? numberAt<std::uint64_t>(bytes, at + 20) : numberAt<std::uint16_t>(bytes, at + 20);
      const std::string_view body = bytes.substr(at + header, size);
      if (bytes.substr(at + 2, 15) == "LASF_Projection") {
        const std::size_t id = numberAt<std::uint16_t>(bytes, at + 18);
        if (id == keys_record)
          keys = byKeys(body);
        else if (id == text_record)
          text = byText(body);
      }
      at += header + size;
    }
  }
};

} // namespace

LasCoordinates
lasCoordinates(std::string_view bytes)
{
  constexpr std::size_t text_counts = 1U << 4; // bit of the global encoding
  LasRecords records;
  records.read(bytes, numberAt<std::uint16_t>(bytes, 94), numberAt<std::uint32_t>(bytes, 100), false);
  if (numberAt<std::uint8_t>(bytes, 25) == 4 && numberAt<std::uint16_t>(bytes, 94) >= 247)
    records.read(bytes, numberAt<std::uint64_t>(bytes, 235), numberAt<std::uint32_t>(bytes, 243), true);
  const bool text_first = (numberAt<std::uint16_t>(bytes, 6) & text_counts) != 0;
  const LasCoordinates first = text_first ? records.text : records.keys, second = text_first ? records.keys : records.text;
  return first != LasCoordinates::Unknown ? first : second;
}

} // namespace pcl_spiral
