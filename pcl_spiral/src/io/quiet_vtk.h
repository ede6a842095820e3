// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Hides VTK's own messages.
 */
#pragma once

#include <vtkObject.h>

namespace pcl_spiral {

/** While it exists, VTK prints nothing: the caller checks the result and reports errors itself. */
class QuietVtk {
public:
  QuietVtk() : before_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::GlobalWarningDisplayOff(); }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

private:
  int before_;
};

} // namespace pcl_spiral
