/// \file
/// libFuzzer target: workbooks. The input is a file, and the rows of the sheet of one.

#include "gradation_property.hpp"

#include <zip.h>

#include <memory>
#include <utility>
#include <vector>

namespace {

/// A zip archive of these files.
std::string archive(const std::vector<std::pair<std::string, std::string>> &files) {
  zip_source_t *const target = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  mdm::fuzz::demand(target != nullptr);
  zip_source_keep(target);
  zip_t *const zip = zip_open_from_source(target, ZIP_TRUNCATE, nullptr);
  mdm::fuzz::demand(zip != nullptr);
  for (const auto &[name, content] : files)
    zip_file_add(zip, name.c_str(), zip_source_buffer(zip, content.data(), content.size(), 0), 0);
  mdm::fuzz::demand(zip_close(zip) == 0);
  zip_stat_t about;
  mdm::fuzz::demand(zip_source_stat(target, &about) == 0 && zip_source_open(target) == 0);
  std::string bytes(about.size, '\0');
  mdm::fuzz::demand(zip_source_read(target, bytes.data(), bytes.size()) >= 0);
  zip_source_close(target);
  zip_source_free(target);
  return bytes;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string content(reinterpret_cast<const char *>(data), size);
  mdm::fuzz::check_reader([&] { return mdm::read_gradation("PK\x03\x04" + content, "fuzz.xlsx"); });
  const std::string book = archive(
      {{"xl/workbook.xml", "<workbook><sheets><sheet name=\"a\" r:id=\"1\"/></sheets></workbook>"},
       {"xl/_rels/workbook.xml.rels", "<R><Relationship Id=\"1\" Type=\"/worksheet\" Target=\"a.xml\"/></R>"},
       {"xl/sharedStrings.xml", "<sst><si><t>Size (mm)</t></si><si><r><t>Mass (g)</t></r></si></sst>"},
       {"xl/a.xml",
        "<worksheet><sheetData><row r=\"1\"><c t=\"s\"><v>0</v></c><c t=\"s\"><v>1</v></c></row>" + content +
            "</sheetData></worksheet>"}});
  mdm::fuzz::check_reader([&] { return mdm::read_gradation(book, "fuzz.xlsx"); });
  return 0;
}
