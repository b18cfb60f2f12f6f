// Workbooks where the programs are WebAssembly: there is no libzip.

#include "gradation/workbook.hpp"

namespace mdm {
namespace {

[[noreturn]] void refuse(const Source &source) {
  source.refuse(
      1, "this is a workbook (.xlsx), which is not read in a browser or in JavaScript: open it in your "
         "spreadsheet "
         "program and save its sheet as CSV, or copy the table's cells and paste them as text; mdm of the "
         "command line reads it as it is");
}

} // namespace

Cells read_workbook(std::string_view, const std::optional<std::string> &, const Source &source) {
  refuse(source);
}

std::vector<std::string> written_sheets(std::string_view, const Source &source) {
  refuse(source);
}

} // namespace mdm
