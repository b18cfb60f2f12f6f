/// \file
/// libFuzzer target: gradations in DIGGS. The input is a file, and the inside of a test.

#include "gradation_property.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string content(reinterpret_cast<const char *>(data), size);
  mdm::fuzz::check_reader([&] { return mdm::read_gradation("<" + content, "fuzz.xml"); });
  const std::string test =
      "<Diggs><ParticleSizeTest gml:id=\"a\"><Grading><particleSize uom=\"mm\">2</particleSize>"
      "<percentPassing>100</percentPassing></Grading>" +
      content + "</ParticleSizeTest></Diggs>";
  mdm::fuzz::check_reader([&] { return mdm::read_gradation(test, "fuzz.xml"); });
  return 0;
}
