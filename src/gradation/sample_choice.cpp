#include "gradation/sample_choice.hpp"

#include "text/option_name.hpp"
#include "text/short_list.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

[[noreturn]] void refuse(const std::vector<SampleNames> &samples, const Source &source,
                         const std::string &why) {
  ShortList names;
  for (const SampleNames &sample : samples)
    names.add(sample.names.front());
  source.refuse(samples.front().line,
                fmt::format("{}: {}; choose one by {}", why, names.text(), option("specimen-id")));
}

} // namespace

std::size_t chosen_sample(const std::vector<SampleNames> &samples, const std::optional<std::string> &wanted,
                          const Source &source) {
  assert(!samples.empty());
  if (!wanted) {
    if (samples.size() > 1)
      refuse(samples, source, fmt::format("there are {} specimens", samples.size()));
    return 0;
  }
  std::size_t most_names = 0;
  for (const SampleNames &sample : samples)
    most_names = std::max(most_names, sample.names.size());
  for (std::size_t kind = 0; kind < most_names; ++kind) {
    const auto is_it = [&](const SampleNames &s) {
      return kind < s.names.size() && s.names[kind] == *wanted;
    };
    if (std::count_if(samples.begin(), samples.end(), is_it) == 1)
      return static_cast<std::size_t>(std::find_if(samples.begin(), samples.end(), is_it) - samples.begin());
  }
  refuse(samples, source, fmt::format("{} does not name one specimen of", in_quotes(*wanted)));
}

} // namespace mdm
