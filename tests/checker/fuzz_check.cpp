// libFuzzer: the input is a gradation, a line `---` and a certificate; or a gradation, a sample and its
// certificate, with such a line between them.

#include <mdm/checker.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string input(reinterpret_cast<const char *>(data), size);
  const std::string separator = "---\n";
  const std::size_t at = input.find(separator);
  if (at == std::string::npos)
    return 0;
  const std::string gradation = input.substr(0, at), rest = input.substr(at + separator.size());
  const std::size_t second = rest.find("\n" + separator);
  mdm::checker::Verdict verdict;
  if (second == std::string::npos) {
    verdict = mdm::checker::check({"gradation", gradation}, {"certificate", rest});
  } else {
    bool is_read = false;
    const std::string sample = rest.substr(0, second + 1);
    verdict = mdm::checker::check_sample(
        {"gradation", gradation}, "sample",
        [&]() -> std::string_view { return std::exchange(is_read, true) ? std::string_view() : sample; },
        {"certificate", rest.substr(second + 1 + separator.size())});
  }
  const bool one_line = verdict.line.find('\n') == std::string::npos &&
                        verdict.line.empty() == (verdict.code == mdm::checker::Verdict::malformed) &&
                        verdict.reason.empty() == (verdict.code == mdm::checker::Verdict::accepted);
  const bool known = verdict.code == mdm::checker::Verdict::accepted ||
                     verdict.code == mdm::checker::Verdict::refused ||
                     verdict.code == mdm::checker::Verdict::malformed;
  if (!one_line || !known)
    std::abort();
  return 0;
}
