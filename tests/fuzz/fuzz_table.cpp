/// \file
/// libFuzzer target: tables as laboratories have them. The first byte chooses the options and the cells'
/// delimiter.

#include "gradation_property.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  if (size == 0)
    return 0;
  const std::string content(reinterpret_cast<const char *>(data + 1), size - 1);
  const std::string delimiter(1, "\t;,\n"[data[0] % 4]);
  mdm::Reading reading;
  if ((data[0] & 4) != 0)
    reading.round = 1 + data[0] % 17;
  if ((data[0] & 8) != 0)
    reading.columns = "1,2";
  if ((data[0] & 16) != 0)
    reading.kind = "cumulative";
  if ((data[0] & 32) != 0)
    reading.unit = "um";
  if ((data[0] & 64) != 0)
    reading.skip = data[0] % 3;
  mdm::fuzz::check_reader([&] { return mdm::read_gradation(content, "fuzz.csv", reading); });
  const std::string table =
      "Siebweite [mm]" + delimiter + "Rückstand [g]" + delimiter + "% passing\n" + content;
  mdm::fuzz::check_reader([&] { return mdm::read_gradation(table, "fuzz.csv", reading); });
  mdm::fuzz::check_reader([&] { return mdm::read_gradation("\xFF\xFE" + content, "fuzz.csv", reading); });
  return 0;
}
