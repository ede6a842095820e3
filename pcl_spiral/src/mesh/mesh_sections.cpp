// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_spiral/mesh/mesh_sections.h>

#include "section_passes.h"

#include <pcl_spiral/common/impl/thread_limit.h>

#include <pcl/console/print.h>

namespace pcl_spiral {

void
MeshSections::setInputMesh(const pcl::PolygonMesh::ConstPtr& mesh)
{
  input_ = mesh;
  given_mesh_.reset();
}

void
MeshSections::setInputMesh(const SurfaceMesh::ConstPtr& mesh)
{
  given_mesh_ = mesh;
  input_.reset();
}

Status
MeshSections::run(DrivePasses& passes)
{
  if (const Status status = checkThreads(number_of_threads_); !status.ok())
    return status;
  if (const Status status = checkSettings(settings_); !status.ok())
    return status;
  if (!given_mesh_ && !input_)
    return {StatusCode::InvalidInput, "there is no mesh: call {setInputMesh}"};
  const ThreadLimit limit(number_of_threads_);
  if (progress_ && !progress_(0.0, "mesh"))
    return {StatusCode::Cancelled, "cancelled"};
  surface_mesh_ = given_mesh_;
  if (!surface_mesh_)
    if (const Status status = SurfaceMesh::make(*input_, mesh_settings_, surface_mesh_); !status.ok())
      return status;
  return sectionPasses(*surface_mesh_, settings_, partOf(progress_, 0.4, 1.0), passes, report_);
}

void
MeshSections::compute(DrivePasses& passes)
{
  passes.clear();
  report_ = SectionReport();
  surface_mesh_.reset();
  status_ = Status::unfinished();
  status_ = run(passes);
  if (status_.ok())
    return;
  passes.clear();
  if (!quiet_ && status_.code() != StatusCode::Cancelled)
    PCL_ERROR("[pcl_spiral::MeshSections::compute] %s\n", status_.message().c_str());
}

} // namespace pcl_spiral
