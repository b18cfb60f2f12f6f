// The workbooks of a program that was built without libzip and pugixml.

#include "gradation/workbook.hpp"

namespace mdm {
namespace {

[[noreturn]] void refuse(const Source &source) {
  source.refuse(
      1, "this mdm was built without libzip and pugixml and reads no workbooks: save the sheet as CSV, or "
         "build it with Debian's libzip-dev and libpugixml-dev");
}

} // namespace

Cells read_workbook(std::string_view, const std::optional<std::string> &, const Source &source) {
  refuse(source);
}

std::vector<std::string> written_sheets(std::string_view, const Source &source) {
  refuse(source);
}

} // namespace mdm
