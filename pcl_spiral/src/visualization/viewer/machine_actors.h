// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The machine of a playback on the screen.
 */
#pragma once

#include "machine/machine_bodies.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace pcl_spiral {

/** \p pose as a matrix of VTK. */
vtkSmartPointer<vtkMatrix4x4> matrixOf(const Eigen::Isometry3d& pose);

/** Solids that follow the bodies of a machine. */
class MachineActors {
public:
  explicit MachineActors(const std::vector<MachineSolid>& solids);

  std::vector<vtkSmartPointer<vtkActor>> actors() const;
  void moveTo(const MachineStand& stand);

private:
  struct Part {
    MachineBody body;
    vtkSmartPointer<vtkActor> actor;
  };
  std::vector<Part> parts_;
};

} // namespace pcl_spiral
