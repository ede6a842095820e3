// SPDX-License-Identifier: BSD-3-Clause
#include "io/byte_file.h"
#include "io/fixed_point.h"

#include <pcl_spiral/io/toolpath_writer.h>

#include <algorithm>

namespace pcl_spiral {

const char* const toolpath_csv_header = "turn,arc_length,cc_x,cc_y,cc_z,normal_x,normal_y,normal_z,tip_x,tip_y,tip_z,"
                                        "axis_x,axis_y,axis_z,feed,over_gap,lift";

namespace {

constexpr std::size_t rows_a_block = 2048;
constexpr std::size_t usual_row = 192;     ///< bytes
constexpr std::size_t blocks_a_round = 32; ///< bounds the memory to 12 MB; the same for any number of threads

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

} // namespace

void
writeToolpathCSV(const std::string& file, const pcl::PointCloud<ToolpathPoint>& path, const ToolpathMotion& motion)
{
  ByteFile out(file);
  out.write(std::string(toolpath_csv_header) + "\n");
  std::vector<std::string> blocks(blocks_a_round);
  for (std::size_t begin = 0; begin < path.size(); begin += rows_a_block * blocks_a_round) {
#pragma omp parallel for schedule(dynamic)
    for (std::size_t b = 0; b < blocks_a_round; ++b) {
      const std::size_t first = begin + b * rows_a_block;
      const std::size_t last = std::min(first + rows_a_block, path.size());
      constexpr std::size_t room = 16 * (fixed_point_room + 1) + 2; // and the mark of a gap
      std::size_t size = 0;
      for (std::size_t i = first; i < last; ++i) {
        if (blocks[b].size() < size + room)
          blocks[b].resize(2 * size + room + usual_row * (last - first));
        char* const row = blocks[b].data() + size;
        size += static_cast<std::size_t>(writeRow(row, path[i], i, motion) - row);
      }
      blocks[b].resize(size);
    }
    for (const std::string& block : blocks)
      out.write(block);
  }
  out.close();
}

} // namespace pcl_spiral
