// SPDX-License-Identifier: BSD-3-Clause
#include "disc_thinning.h"

namespace pcl_spiral {

std::vector<std::uint8_t>
thinToDistance(const PointBlocks& blocks, const std::vector<float>& distance)
{
  std::vector<std::uint8_t> kept(blocks.size(), 0);
  std::vector<std::uint32_t> kept_of_block(blocks.size()); // in the range of each block
  std::vector<std::uint32_t> kept_count(blocks.blockCount(), 0);
  for (std::size_t b = 0; b < blocks.blockCount(); ++b)
    for (std::size_t i = blocks.blockBegin(b); i < blocks.blockEnd(b); ++i) {
      const Eigen::Vector3f& p = blocks.point(i);
      const float limit = distance[i] * distance[i];
      bool keep = true;
      const auto look = [&](std::size_t block) {
        const std::size_t begin = blocks.blockBegin(block);
        for (std::uint32_t k = 0; keep && k < kept_count[block]; ++k)
          keep = !((blocks.point(kept_of_block[begin + k]) - p).squaredNorm() < limit);
      };
      if (limit > 0.0f) {
        look(b);
        Box place;
        place.extend(p.data());
        if (keep)
          blocks.forBlocksNear(place, limit, [&](std::size_t block) {
            if (keep && block <= b)
              look(block);
          });
      }
      kept[i] = keep;
      if (keep)
        kept_of_block[blocks.blockBegin(b) + kept_count[b]++] = static_cast<std::uint32_t>(i);
    }
  return kept;
}

} // namespace pcl_spiral
