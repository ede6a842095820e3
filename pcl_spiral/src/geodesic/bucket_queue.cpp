// SPDX-License-Identifier: BSD-3-Clause
#include "bucket_queue.h"

#include <algorithm>

namespace pcl_spiral {

void
BucketQueue::push(std::uint32_t point, double distance)
{
  // Beyond the last bucket: put into it.
  const double place = std::max(0.0, distance) / width_;
  const double last = static_cast<double>(current_ + buckets_.size() - 1);
  const auto bucket = static_cast<std::size_t>(std::min(place, last));
  buckets_[std::max(bucket, current_) % buckets_.size()].push_back(point);
  ++waiting_;
}

bool
BucketQueue::pop(std::vector<std::uint32_t>& points)
{
  points.clear();
  if (waiting_ == 0)
    return false;
  while (buckets_[current_ % buckets_.size()].empty())
    ++current_;
  points.swap(buckets_[current_ % buckets_.size()]);
  waiting_ -= points.size();
  return true;
}

} // namespace pcl_spiral
