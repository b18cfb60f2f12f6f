#pragma once
/// \file
/// What the tests of this folder share.

#include "catch.hpp"
#include "particles/particle_reader.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

namespace mdm::test {

/// Writes down what it gets: `diameter` or `diameter*quantity`, separated by spaces.
class Recorder : public ParticleSink {
public:
  std::string text;

  void restart() override { text.clear(); }
  void add(const RootSize &diameter, const Integer &quantity) override {
    text += (text.empty() ? "" : " ") + diameter.text();
    if (quantity != 1)
      text += "*" + to_string(quantity);
  }
  void add(const SizeRange &diameter, const Integer &quantity) override {
    text += (text.empty() ? "" : " ") + std::string(diameter.is_open ? "(" : "[") +
            *exact_decimal(diameter.lo) + "," + *exact_decimal(diameter.hi) + "]";
    if (quantity != 1)
      text += "*" + to_string(quantity);
  }
};

struct Result {
  std::string particles;
  std::optional<ParticleFormat> format;
  std::vector<std::string> notes;
};

/// Reads a whole file called `file`.
inline Result read(const std::string &content, const ParticleOptions &options = {}) {
  Recorder recorder;
  ParticleReader reader("file", recorder, options);
  for (std::size_t begin = 0; begin < content.size();) {
    const std::size_t end = std::min(content.find('\n', begin), content.size());
    reader.line(std::string_view(content).substr(begin, end - begin));
    begin = end + 1;
  }
  reader.end();
  return {recorder.text, reader.format(), reader.notes()};
}

/// The message that refuses a file.
inline std::string refusal(const std::string &content, const ParticleOptions &options = {}) {
  INFO(content.substr(0, 200));
  try {
    read(content, options);
  } catch (const InputError &error) {
    CHECK(is_utf8(error.what()));
    return error.what();
  }
  FAIL("no InputError");
  return {};
}

inline bool contains(const std::string &message, const std::string &part) {
  UNSCOPED_INFO("message: " << message << "\nexpected: " << part);
  return message.find(part) != std::string::npos;
}

/// Each file that lacks its last line or lines is refused, and no message is without a line.
inline void check_truncations(const std::string &content, const ParticleOptions &options) {
  for (std::size_t end = content.find('\n'); end + 1 < content.size(); end = content.find('\n', end + 1))
    CHECK(refusal(content.substr(0, end + 1), options).starts_with("file:"));
}

inline ParticleOptions from(ParticleFormat format) {
  ParticleOptions options;
  options.format = format;
  return options;
}

} // namespace mdm::test
