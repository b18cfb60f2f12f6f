#include "report/allowed_error.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {

AllowedError allowed_error(const Gradation &g, const std::vector<AskedTolerance> &asked,
                           const std::optional<Envelope> &band, const Rational &size_factor) {
  AllowedError allowed;
  if (!asked.empty() || band)
    allowed.most = 1;
  std::vector<AskedTolerance> others;
  std::vector<std::string> words;
  for (const AskedTolerance &t : asked) {
    words.push_back(to_string(t));
    if (t.kind == AskedTolerance::Kind::retained)
      allowed.most = std::min(allowed.most, Rational(t.percent / 100));
    else
      others.push_back(t);
  }
  if (band)
    words.push_back("the band " + printable(band->id));
  if (others.empty() && !band)
    return allowed;
  allowed.bounds = tolerance_of(g, others, band, size_factor);
  allowed.within = fmt::format("{}", fmt::join(words, ", "));
  return allowed;
}

} // namespace mdm
