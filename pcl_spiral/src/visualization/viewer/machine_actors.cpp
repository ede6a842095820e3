// SPDX-License-Identifier: BSD-3-Clause
#include "machine_actors.h"

#include "visualization/actors.h"

#include <vtkCubeSource.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkTubeFilter.h>

namespace pcl_spiral {
namespace {

constexpr int cylinder_sides = 64;
constexpr double head_opacity = 0.45; ///< the part is seen through it
constexpr Color table_color{0.62, 0.66, 0.72}, head_color{0.56, 0.60, 0.67}, ground_color{0.45, 0.47, 0.50}, axis_color{0.20, 0.42, 0.62};

vtkSmartPointer<vtkPolyData>
shapeOf(const MachineSolid& solid)
{
  if (!(solid.radius > 0.0)) {
    vtkNew<vtkCubeSource> box;
    box->SetBounds(solid.a.x(), solid.b.x(), solid.a.y(), solid.b.y(), solid.a.z(), solid.b.z());
    box->Update();
    return box->GetOutput();
  }
  vtkNew<vtkLineSource> line;
  line->SetPoint1(solid.a.x(), solid.a.y(), solid.a.z());
  line->SetPoint2(solid.b.x(), solid.b.y(), solid.b.z());
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputConnection(line->GetOutputPort());
  tube->SetRadius(solid.radius);
  tube->SetNumberOfSides(cylinder_sides);
  tube->CappingOn();
  tube->Update();
  return tube->GetOutput();
}

bool
isOfHead(MachineBody body)
{
  return body == MachineBody::Slide || body == MachineBody::OuterHead || body == MachineBody::Spindle;
}

} // namespace

vtkSmartPointer<vtkMatrix4x4>
matrixOf(const Eigen::Isometry3d& pose)
{
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      matrix->SetElement(r, c, pose.matrix()(r, c));
  return matrix;
}

MachineActors::MachineActors(const std::vector<MachineSolid>& solids)
{
  for (const MachineSolid& solid : solids) {
    const bool head = isOfHead(solid.body);
    const Color& color = solid.is_axis ? axis_color : head ? head_color : solid.body == MachineBody::Ground ? ground_color : table_color;
    parts_.push_back({solid.body, surfaceActor(shapeOf(solid), color)});
    if (head)
      parts_.back().actor->GetProperty()->SetOpacity(head_opacity);
  }
}

std::vector<vtkSmartPointer<vtkActor>>
MachineActors::actors() const
{
  std::vector<vtkSmartPointer<vtkActor>> actors;
  for (const Part& part : parts_)
    actors.push_back(part.actor);
  return actors;
}

void
MachineActors::moveTo(const MachineStand& stand)
{
  for (const Part& part : parts_)
    part.actor->SetUserMatrix(matrixOf(stand.of(part.body)));
}

} // namespace pcl_spiral
