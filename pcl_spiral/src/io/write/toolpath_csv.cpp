// SPDX-License-Identifier: BSD-3-Clause
#include "io/byte_file.h"
#include "io/fixed_point.h"

#include <pcl_spiral/io/toolpath_writer.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <string>

namespace pcl_spiral {

const char* const toolpath_csv_header = "turn,arc_length,cc_x,cc_y,cc_z,normal_x,normal_y,normal_z,tip_x,tip_y,tip_z,"
                                        "axis_x,axis_y,axis_z,feed,over_gap,lift";

namespace {

constexpr std::size_t rows_a_block = 2048;
constexpr std::size_t usual_row = 192; ///< bytes

template <int Decimals>
char*
writeField(char* out, double value)
{
  out = writeFixed<Decimals>(out, value);
  *out++ = ',';
  return out;
}

char*
writeRow(char* out, const ToolpathPoint& point, std::size_t i, const ToolpathMotion& motion)
{
  const Eigen::Vector3d tip = motion.tips.empty() ? toolTip(point, motion.tool_radius) : motion.tips[i];
  out = writeField<6>(out, point.turn);
  out = writeField<6>(out, point.arc_length);
  for (int c = 0; c < 3; ++c)
    out = writeField<6>(out, point.data[c] + motion.origin[c]);
  for (int c = 0; c < 3; ++c)
    out = writeField<9>(out, point.data_n[c]);
  for (int c = 0; c < 3; ++c)
    out = writeField<6>(out, tip[c] + motion.origin[c]);
  for (int c = 0; c < 3; ++c)
    out = writeField<9>(out, point.data_axis[c]);
  out = writeField<3>(out, motion.feed);
  *out++ = point.over_gap != 0 ? '1' : '0';
  *out++ = ',';
  out = writeFixed<6>(out, point.lift);
  *out++ = '\n';
  return out;
}

/** The rows of the points from \p first up to \p last, into \p block. */
void
writeRows(const pcl::PointCloud<ToolpathPoint>& path, const ToolpathMotion& motion, std::size_t first, std::size_t last, std::string& block)
{
  constexpr std::size_t room = 16 * (fixed_point_room + 1) + 2; // and the mark of a gap
  std::size_t size = 0;
  for (std::size_t i = first; i < last; ++i) {
    if (block.size() < size + room)
      block.resize(2 * size + room + usual_row * (last - first));
    char* const row = block.data() + size;
    size += static_cast<std::size_t>(writeRow(row, path[i], i, motion) - row);
  }
  block.resize(size);
}

} // namespace

void
writeToolpathCSV(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path, const ToolpathMotion& motion)
{
  ByteFile out(file);
  out.write(std::string(toolpath_csv_header) + "\n");
  const auto blocks = static_cast<std::int64_t>((path.size() + rows_a_block - 1) / rows_a_block);
  std::exception_ptr failure; // none may leave the loop
#pragma omp parallel
  {
    std::string block;
#pragma omp for ordered schedule(dynamic, 1)
    for (std::int64_t b = 0; b < blocks; ++b) {
      const std::size_t first = static_cast<std::size_t>(b) * rows_a_block;
      writeRows(path, motion, first, std::min(first + rows_a_block, path.size()), block);
#pragma omp ordered
      try { // while one thread writes, others make the next rows
        if (!failure)
          out.write(block);
      }
      catch (...) {
        failure = std::current_exception();
      }
    }
  }
  if (failure)
    std::rethrow_exception(failure);
  out.close();
}

} // namespace pcl_spiral
