#include "field_layout.h"
#include "point_table.h"
#include "quiet_vtk.h"
#include "text_scan.h"

#include <pcl_spiral/io/file_error.h>

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>

namespace pcl_spiral {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;

/** VTK's reader takes a file that is cut off for a smaller one: the count is checked here. */
void
checkComplete(const std::string& file, std::string_view bytes)
{
  const std::string_view start = trimmed(bytes.substr(0, 256));
  const bool text =
      start.substr(0, 5) == "solid" && bytes.substr(0, 1024).find('\0') == std::string_view::npos;
  if (text) {
    if (bytes.find("endsolid") == std::string_view::npos)
      throw FileError(file, "is cut off: 'endsolid' is missing; copy or export it again");
    return;
  }
  if (bytes.size() < header_bytes)
    throw FileError(file,
                    "is neither an ascii nor a binary STL file (" + std::to_string(bytes.size()) + " bytes)");
  const auto triangles = static_cast<std::size_t>(loadAs<std::uint32_t>(bytes.data() + 80));
  if (triangles == 0)
    throw FileError(file, "byte 80: the header says that there are no triangles");
  if (bytes.size() < header_bytes + triangles * triangle_bytes)
    throw FileError(file, "is cut off at byte " + std::to_string(bytes.size()) + ": its " +
                              std::to_string(triangles) + " triangles need " +
                              std::to_string(header_bytes + triangles * triangle_bytes) +
                              "; copy or export it again");
}

} // namespace

PointTable
readStlTable(const std::string& file, std::string_view bytes)
{
  checkComplete(file, bytes);
  const QuietVtk quiet;
  vtkNew<vtkSTLReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPoints* const points = reader->GetOutput()->GetPoints();
  if (!points || points->GetNumberOfPoints() == 0)
    throw FileError(file, "is not a readable STL file; export it again");
  PointTable table(3);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      table[c].push_back(points->GetPoint(i)[c]);
  return table;
}

} // namespace pcl_spiral
