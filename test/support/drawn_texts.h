// SPDX-License-Identifier: BSD-3-Clause
/** \file
 *  The words that VTK draws, those of colour bars too, and where.
 */
#pragma once

#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkVersion.h>
#include <vtkViewport.h>

#include <Eigen/Geometry>

#include <string>
#include <utility>
#include <vector>

namespace pcl_spiral::test {

struct DrawnText {
  std::string words;
  int font_size;
  Eigen::AlignedBox2d box, view; ///< pixels from the lower left corner of the view that draws it
};

/** A text that notes what it draws. */
class NotedText : public vtkTextActor {
public:
  vtkTypeMacro(NotedText, vtkTextActor);
  static NotedText* New() { VTK_STANDARD_NEW_BODY(NotedText); }

  static std::vector<DrawnText>& drawn()
  {
    static std::vector<DrawnText> texts;
    return texts;
  }
  int RenderOverlay(vtkViewport* view) override
  {
    double box[4];
    GetBoundingBox(view, box);
    const int* const corner = GetPositionCoordinate()->GetComputedViewportValue(view);
    const Eigen::Vector2d place(corner[0], corner[1]), size(view->GetSize()[0], view->GetSize()[1]);
    drawn().push_back({GetInput() ? GetInput() : "",
                       GetTextProperty()->GetFontSize(),
                       {place + Eigen::Vector2d(box[0], box[2]), place + Eigen::Vector2d(box[1], box[3])},
                       {Eigen::Vector2d::Zero(), size}});
    return Superclass::RenderOverlay(view);
  }
};

/** Makes them in place of every text. */
class NotedTexts : public vtkObjectFactory {
public:
  vtkTypeMacro(NotedTexts, vtkObjectFactory);
  static NotedTexts* New() { VTK_STANDARD_NEW_BODY(NotedTexts); }
  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "texts that note what they draw"; }

  /** Those drawn by \p draw. */
  template <typename Draw>
  static std::vector<DrawnText> during(const Draw& draw)
  {
    vtkObjectFactory::SetAllEnableFlags(0, "vtkTextActor"); // other factories come first
    const vtkNew<NotedTexts> factory;
    vtkObjectFactory::RegisterFactory(factory);
    NotedText::drawn().clear();
    draw();
    vtkObjectFactory::UnRegisterFactory(factory);
    vtkObjectFactory::SetAllEnableFlags(1, "vtkTextActor");
    return std::exchange(NotedText::drawn(), {});
  }

private:
  static vtkObject* make() { return NotedText::New(); }
  NotedTexts() { RegisterOverride("vtkTextActor", "NotedText", "notes what it draws", 1, make); }
};

} // namespace pcl_spiral::test
