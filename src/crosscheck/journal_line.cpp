#include "crosscheck/journal_line.hpp"

#include <mdm/gradation/write_gradation.hpp>

#include <fmt/core.h>

namespace mdm {

std::string digest(const Gradation &g) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : gradation_json(g))
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

std::optional<std::string> asked_digest(const OtherAnswer &answer) {
  const auto has = [&](const char *label) { return answer.labels.count(label) > 0; };
  if (!has(journal_label::solver) || !has(journal_label::line) || !has(journal_label::gradation))
    return std::nullopt;
  return answer.labels.at(journal_label::gradation);
}

} // namespace mdm
