/// \file
/// libFuzzer target: gradations in AGS4. The input is what follows the heading of group GRAT, or a file of
/// its own.

#include "gradation_property.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string content(reinterpret_cast<const char *>(data), size);
  mdm::Reading one;
  one.specimen = "A";
  const std::string rows =
      "\"GROUP\",\"GRAT\"\n\"HEADING\",\"LOCA_ID\",\"SPEC_REF\",\"GRAT_SIZE\",\"GRAT_PERP\"\n"
      "\"UNIT\",\"\",\"\",\"mm\",\"%\"\n" +
      content;
  mdm::fuzz::check_reader([&rows] { return mdm::read_gradation(rows, "fuzz.ags"); });
  mdm::fuzz::check_reader([&] { return mdm::read_gradation(rows, "fuzz.ags", one); });
  mdm::fuzz::check_reader([&content] { return mdm::read_gradation("\"GROUP\"" + content, "fuzz.ags"); });
  return 0;
}
