#pragma once
/// \file
/// Discs for the tests of packings, and the judge of packings.

#include "catch.hpp"
#include "files.hpp"
#include "packing/deposit.hpp"
#include "packing/packing_writer.hpp"

#include <mdm/text/error.hpp>

#include <cstdlib>
#include <string>

namespace packing_test {

/// n diameters from 1 to `ratio`, uniform by volume (areas of discs), by a linear congruential generator.
inline mdm::DiscSizes discs(std::size_t n, std::uint64_t ratio, std::uint64_t seed = 1) {
  mdm::DiscSizes d;
  std::uint64_t state = seed;
  constexpr std::uint64_t steps = 1000000;
  for (std::size_t i = 0; i < n; ++i) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    const std::uint64_t u = (state >> 33) % steps;
    // 1 / (1 - u (1 - 1/ratio)), in millionths.
    d.sizes.push_back({steps * steps * ratio / (steps * ratio - u * (ratio - 1)), 6});
  }
  return d;
}

inline std::string file_text(const mdm::Packing &p) {
  std::string text;
  mdm::write_packing(p, [&text](std::string_view part) { text += part; });
  return text;
}

/// What an action is refused with; empty if it is not.
template <class Action>
std::string refusal(const Action &action) {
  try {
    action();
    return "";
  } catch (const mdm::InputError &e) {
    return e.what();
  }
}

inline bool has(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

/// Refuses packings that the independent checker refuses.
class Judge {
public:
  void add(const mdm::Packing &p) { files_ += " " + folder_.write(std::to_string(n_++), file_text(p)); }
  bool accepts() const {
    const std::string command =
        "/usr/bin/python3 '" MDM_SOURCE_DIR "/tests/packing/check_packing.py'" + files_;
    return n_ > 0 && std::system((command + " > " + (folder_ / "verdict")).c_str()) == 0;
  }

private:
  mdm_test::TemporaryFolder folder_;
  std::string files_;
  int n_ = 0;
};

} // namespace packing_test
