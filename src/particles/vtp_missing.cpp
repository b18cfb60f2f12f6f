// VTK's XML in a program that was built without pugixml.

#include "particles/line_reader.hpp"

namespace mdm {

std::unique_ptr<LineReader> read_vtp(ParticleSource &source) {
  source.refuse("this mdm was built without pugixml and reads no XML: write legacy VTK in ASCII, or build it "
                "with Debian's libpugixml-dev");
}

} // namespace mdm
