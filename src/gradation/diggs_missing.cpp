// DIGGS in a program that was built without pugixml.

#include "gradation/diggs_reader.hpp"

namespace mdm {

Table read_diggs(std::string_view, const Source &source, const std::string &,
                 const std::optional<std::string> &) {
  source.refuse(
      1, "this mdm was built without pugixml and reads no XML: write the gradation as CSV, or build it with "
         "Debian's libpugixml-dev");
}

} // namespace mdm
