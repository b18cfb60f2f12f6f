// libFuzzer: the input is a gradation, a line `---` and a certificate.

#include <mdm/checker.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string input(reinterpret_cast<const char *>(data), size);
  const std::string separator = "---\n";
  const std::size_t at = input.find(separator);
  if (at == std::string::npos)
    return 0;
  const mdm::checker::Verdict verdict = mdm::checker::check(
      {"gradation", input.substr(0, at)}, {"certificate", input.substr(at + separator.size())});
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
