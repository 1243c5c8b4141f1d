// What a program that was built without OpenVDB says of its files.
#include "input/grid_readers.h"

namespace isoscope {

ScalarGrid read_vdb(FileScanner& in) {
  in.fail("is an OpenVDB file, and this program was built without its reader",
          "Convert it to NRRD, or build Isoscope with -D ISOSCOPE_OPENVDB=ON (package libopenvdb-dev).",
          ErrorCode::unsupported);
}

} // namespace isoscope
