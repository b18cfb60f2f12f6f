#include "judge/shipped_files.hpp"

#include <mdm/judge/specification.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// The comment lines with which a text begins.
std::vector<std::string> comments_above(std::string_view text) {
  std::vector<std::string> comments;
  while (text.starts_with('#')) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(1, end - 1);
    while (line.starts_with(' '))
      line.remove_prefix(1);
    while (line.ends_with('\r') || line.ends_with(' '))
      line.remove_suffix(1);
    if (!line.empty())
      comments.emplace_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return comments;
}

} // namespace

Specification read_specification(std::string_view content, const std::string &file) {
  const Envelope e = read_envelope(content, file);
  if (const std::optional<std::string> why = contradiction(e))
    throw InputError(file + ": no curve keeps these limits: " + *why + ": correct one of them");
  Specification s{e.id, comments_above(content), {}, e.notes};
  for (std::size_t i = 0; i < e.sizes.size(); ++i)
    s.sieves.push_back({e.sizes[i] * in_mm(e.unit), e.passing_min[i], e.passing_max[i]});
  return s;
}

std::vector<std::string> shipped_specifications() {
  std::vector<std::string> names;
  for (const ShippedFile &file : shipped_files())
    names.emplace_back(file.name);
  return names;
}

std::optional<Specification> shipped_specification(std::string_view name) {
  for (const ShippedFile &file : shipped_files())
    if (file.name == name)
      return read_specification(file.content, std::string(name) + ".csv");
  return std::nullopt;
}

Envelope envelope_of(const Specification &specification) {
  Envelope e{specification.id, SizeUnit::mm, {}, {}, {}, {}};
  for (const PassingLimits &limits : specification.sieves) {
    e.sizes.push_back(limits.size);
    e.passing_min.push_back(limits.least);
    e.passing_max.push_back(limits.most);
  }
  return e;
}

} // namespace mdm
