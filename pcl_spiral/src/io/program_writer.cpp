#include <pcl_spiral/io/program_writer.h>

namespace pcl_spiral {

void
writeProgram(const std::string& file, const MachineProgram& program, Dialect dialect,
             const ProgramHeader& header)
{
  switch (dialect) {
  case Dialect::LinuxCNC:
    return writeLinuxCNC(file, program, header);
  case Dialect::Fanuc:
    return writeFanuc(file, program, header, false);
  case Dialect::FanucVectors:
    return writeFanuc(file, program, header, true);
  case Dialect::Siemens:
    return writeSiemens(file, program, header);
  case Dialect::Heidenhain:
    return writeHeidenhain(file, program, header);
  }
}

} // namespace pcl_spiral
