// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Base of filters that say why they failed.
 */
#pragma once

#include <pcl_spiral/common/status.h>

#include <pcl/console/print.h>
#include <pcl/filters/filter_indices.h>

#include <utility>

namespace pcl_spiral {

/** A pcl::FilterIndices with a status. After a null cloud neither the output nor the status of the last filter stays. */
template <typename PointT>
class StatusFilter : public pcl::FilterIndices<PointT> {
public:
  /** Clears the last result. A null pointer is an error at once. */
  void setInputCloud(const typename pcl::PointCloud<PointT>::ConstPtr& cloud) override
  {
    status_ = cloud ? Status() : missingCloud();
    forgetResult();
    this->removed_indices_->clear();
    pcl::FilterIndices<PointT>::setInputCloud(cloud);
  }

  /** As in pcl::Filter, but the output is also empty if there is no cloud. Through a pointer to pcl::Filter, pcl::Filter::filter
   *  leaves the output unchanged in that case and does not call this filter. */
  void filter(pcl::PointCloud<PointT>& output)
  {
    if (hasCloud())
      pcl::FilterIndices<PointT>::filter(output);
    else
      output.clear();
  }
  /** \copydoc filter */
  void filter(pcl::Indices& indices)
  {
    if (hasCloud())
      pcl::FilterIndices<PointT>::filter(indices);
    else
      indices.clear();
  }

  /** Status of the last call of filter. */
  const Status& getStatus() const { return status_; }

  /** If true, filter prints nothing to the console when it fails; false by default. The status is the same. */
  void setQuiet(bool quiet) { quiet_ = quiet; }
  bool getQuiet() const { return quiet_; } ///< The value of setQuiet.

protected:
  explicit StatusFilter(bool extract_removed_indices) : pcl::FilterIndices<PointT>(extract_removed_indices) {}

  virtual void forgetResult() = 0; ///< Clears the figures of the last filter.

  /** Splits the indices into those to keep and those to remove. */
  virtual Status choose(pcl::Indices& kept, pcl::Indices& removed) = 0;

  using pcl::FilterIndices<PointT>::applyFilter;
  /** What pcl::FilterIndices calls. */
  void applyFilter(pcl::Indices& indices) override
  {
    forgetResult();
    pcl::Indices kept, removed;
    status_ = choose(kept, removed);
    if (!status_.ok()) {
      reportFailure();
      kept.clear();
      removed = *this->indices_;
    }
    else if (this->negative_)
      kept.swap(removed);
    indices = std::move(kept);
    if (this->extract_removed_indices_)
      *this->removed_indices_ = std::move(removed);
  }

private:
  static Status missingCloud() { return {StatusCode::InvalidInput, "the input cloud is missing: call {setInputCloud} with points"}; }

  void reportFailure() const
  {
    if (!quiet_)
      PCL_ERROR("[pcl_spiral::%s::filter] %s\n", this->filter_name_.c_str(), status_.message().c_str());
  }

  /** True if there is a cloud to filter; if not, sets the status. */
  bool hasCloud()
  {
    if (this->input_)
      return true;
    status_ = missingCloud();
    this->removed_indices_->clear();
    reportFailure();
    return false;
  }

  Status status_;
  bool quiet_ = false; ///< of setQuiet
};

} // namespace pcl_spiral
