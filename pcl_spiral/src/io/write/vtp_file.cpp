// SPDX-License-Identifier: BSD-3-Clause
#include "io/write/vtp_file.h"

#include "io/byte_file.h"
#include "io/quiet_vtk.h"
#include <pcl_spiral/io/file_error.h>

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

namespace pcl_spiral {

void
writePolyData(const std::string& file, vtkPolyData* data)
{
  const QuietVtk quiet;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->WriteToOutputStringOn();
  writer->SetInputData(data);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToNone();
  if (writer->Write() != 1 || writer->GetErrorCode() != vtkErrorCode::NoError)
    throw FileError(file, Diagnostic("cannot be written: ", std::string(vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()))));
  ByteFile out(file); // VTK's own file writer does not report errors at closing
  out.write(writer->GetOutputString());
  out.close();
}

} // namespace pcl_spiral
