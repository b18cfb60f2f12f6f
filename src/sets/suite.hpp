#pragma once
/// \file
/// Suites of gradations that a description and a seed make.

#include <mdm/gradation/gradation.hpp>

#include <cstdint>
#include <memory>
#include <string_view>

namespace mdm {

struct SuiteDescription;

/// Gradations without end, a line each: what line n holds depends on the description, the seed and n alone,
/// and is the same on every machine. Random numbers are Philox's; where a distribution is no fraction, its
/// shares are rounded by decided comparisons.
class Suite {
public:
  /// \param description  JSON, as the schema mdm-suite-1 has it
  /// \param file         its name in messages
  /// \throws InputError if it is anything else, or asks for what cannot be
  Suite(std::string_view description, std::string_view file);

  /// Line n, n >= 1, with the id `ID-n`. Cost: some 4 us with random masses, some 20 us a class with those of
  /// a curve. For several threads at a time.
  Gradation line(std::uint64_t n, std::uint64_t seed) const;

private:
  std::shared_ptr<const SuiteDescription> description_;
};

} // namespace mdm
