/// \file
/// libFuzzer target: gradations as JSON, as files and as lines of a suite.

#include "gradation_property.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string content(reinterpret_cast<const char *>(data), size);
  mdm::fuzz::check_reader([&content] { return mdm::read_gradation("{" + content, "fuzz.json"); });
  mdm::fuzz::check_reader([&content] { return mdm::read_json_gradation(content, "fuzz.jsonl:1", "1"); });
  mdm::json_gradation_id(content);
  return 0;
}
