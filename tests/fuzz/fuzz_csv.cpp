/// \file
/// libFuzzer target: gradations as CSV.

#include "gradation_property.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string content(reinterpret_cast<const char *>(data), size);
  mdm::fuzz::check_reader([&content] { return mdm::read_gradation(content, "fuzz.csv"); });
  return 0;
}
