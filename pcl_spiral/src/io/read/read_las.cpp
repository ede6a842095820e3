// SPDX-License-Identifier: BSD-3-Clause
#include "field_layout.h"
#include "found_degrees.h"
#include "las_projection.h"
#include "point_table.h"

#include <pcl_spiral/io/file_error.h>

#include <algorithm>
#include <array>

namespace pcl_spiral {
namespace {

// An own reader, because Debian has no library for LAS. Header and records: "LAS Specification 1.4 - R15", ASPRS 2019, tables 3 and 7. In
// the point formats 0 to 10 a record begins with x y z as whole numbers, for all versions from 1.0.

constexpr std::size_t least_header = 227; ///< bytes, of versions 1.0 to 1.2
constexpr std::size_t flags_at = 15;      ///< byte in a record, of all formats
constexpr FieldType u1{'U', 1}, u2{'U', 2}, u4{'U', 4}, u8{'U', 8}, i4{'I', 4}, real{'F', 8};

class LasFile {
public:
  LasFile(const std::string& file, std::string_view bytes) : file_(file), bytes_(bytes) { check(); }

  /** Points that are flagged withheld are not read. */
  PointTable read() const
  {
    std::vector<const char*> records;
    records.reserve(count_);
    for (std::size_t i = 0; i < count_; ++i)
      if (const char* const record = bytes_.data() + begin_ + i * size_; (record[flags_at] & withheld_) == 0)
        records.push_back(record);
    if (records.empty())
      throw FileError(file_, Diagnostic("all of its ", count_,
                                        " points are flagged withheld, which means that they are not part of "
                                        "the scan; clear the flags, or export it again"));
    PointTable table(3, std::vector<double>(records.size()));
    for (std::size_t c = 0; c < 3; ++c) {
      const double offset = loadField(bytes_.data() + 155 + 8 * c, real);
      for (std::size_t i = 0; i < records.size(); ++i)
        table[c][i] = scale(c) * loadField(records[i] + 4 * c, i4) + offset;
    }
    requireLengths(table);
    return table;
  }

  std::size_t count() const { return count_; }

private:
  double scale(std::size_t axis) const { return loadField(bytes_.data() + 131 + 8 * axis, real); }

  /** \throw FileError if x and y are degrees, by what the file says or by steps that only degrees need */
  void requireLengths(const PointTable& table) const
  {
    constexpr double degree_step = 1e-6, height_steps = 100.0; // 0.1 m; x and y finer than z
    const LasCoordinates named = lasCoordinates(bytes_);
    if (named == LasCoordinates::Degrees)
      throw FileError(
          file_, Diagnostic("its coordinates, by the geographic coordinate system that it names, ", degreesRemedy(file_, table, true)));
    const double finest = std::max(scale(0), scale(1));
    const bool fine = finest <= degree_step && scale(2) >= height_steps * finest && canBeDegrees(table);
    if (named == LasCoordinates::Unknown && (fine || looksLikeDegrees(table)))
      throw FileError(file_,
                      Diagnostic("names no coordinate system, but its coordinates, by their ranges, ", degreesRemedy(file_, table, false)));
  }

  std::size_t whole(std::size_t at, FieldType type) const
  {
    constexpr double most = 1e15; // more than any file has
    return static_cast<std::size_t>(std::min(loadField(bytes_.data() + at, type), most));
  }

  void check()
  {
    if (bytes_.size() < least_header || bytes_.substr(0, 4) != "LASF")
      throw FileError(file_,
                      Diagnostic("is not a LAS file, or it is cut off in its header: it must begin with LASF and a header of at least ",
                                 least_header, " bytes; copy or export it again"));
    constexpr std::array<std::size_t, 11> least_sizes{20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
    const std::size_t major = whole(24, u1), minor = whole(25, u1), format = whole(104, u1);
    if (format & 0xC0U) // LASzip sets a bit that no format uses
      throw FileError(file_, Diagnostic("its points are compressed; ", conversionRemedy(file_)));
    if (major != 1 || minor > 4 || format >= least_sizes.size())
      throw FileError(file_, Diagnostic("is LAS ", major, ".", minor, " with points of format ", format,
                                        "; versions 1.0 to 1.4 with formats 0 to 10 are read; export it as one of these"));
    withheld_ = format < 6 ? 0x80U : 0x04U; // tables 8 and 16
    begin_ = whole(96, u4);
    size_ = whole(105, u2);
    if (size_ < least_sizes[format])
      throw FileError(file_, Diagnostic("gives ", size_, " bytes for a point of format ", format, ", which has at least ",
                                        least_sizes[format], "; export it again"));
    const bool wide = minor == 4 && bytes_.size() >= 255;
    count_ = wide ? whole(247, u8) : whole(107, u4);
    if (count_ == 0)
      throw FileError(file_, "holds no points");
    if (begin_ > bytes_.size() || (bytes_.size() - begin_) / size_ < count_)
      throw FileError(file_, Diagnostic("ends after ", bytes_.size(), " bytes, but its header gives ", count_, " points of ", size_,
                                        " bytes from byte ", begin_, ": it is cut off; copy or export it again"));
  }

  const std::string& file_;
  std::string_view bytes_;
  std::size_t begin_ = 0, size_ = 0, count_ = 0;
  unsigned withheld_ = 0; ///< bit in the byte of the flags
};

} // namespace

PointTable
readLasTable(const std::string& file, std::string_view bytes, Diagnostics& warnings)
{
  const LasFile las(file, bytes);
  PointTable table = las.read();
  if (const std::size_t withheld = las.count() - table[0].size(); withheld > 0)
    warnings.push_back(Diagnostic(file, ": ", withheld, " of ", las.count(), " points ", (withheld == 1 ? "is" : "are"),
                                  " flagged withheld and ", (withheld == 1 ? "was" : "were"), " left out"));
  return table;
}

} // namespace pcl_spiral
