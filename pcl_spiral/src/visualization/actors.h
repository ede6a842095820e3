// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  Surfaces, lines and colour scales as they are drawn.
 */
#pragma once

#include "sheet.h"

#include <pcl_spiral/core/polyline.h>

#include <vtkActor.h>
#include <vtkPolyData.h>

namespace pcl_spiral {

constexpr Color surface_color{0.80, 0.83, 0.87};

/** The surface in one colour, lit from the viewer's side. */
vtkSmartPointer<vtkActor> surfaceActor(vtkPolyData* surface, const Color& color);

/** The surface coloured by the values of its points. */
vtkSmartPointer<vtkActor> coloredSurface(vtkPolyData* surface, vtkScalarsToColors* colors);

/** Lines in one colour, drawn over the surface below them. */
vtkSmartPointer<vtkActor> lineActor(const std::vector<Polyline>& lines, bool closed, const Color& color, float width);

/** In the middle of colorScale. */
constexpr Color middle_color{0.128, 0.567, 0.551};

/** From dark blue through green to yellow. */
vtkSmartPointer<vtkScalarsToColors> colorScale(double low, double high);

/** From blue, at minus \p reach, through pale yellow to red. */
vtkSmartPointer<vtkScalarsToColors> divergingScale(double reach);

} // namespace pcl_spiral
