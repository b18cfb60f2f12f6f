#include "generated_sizes.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

/// What is streamed is handed on in parts of some such length.
constexpr std::size_t part = std::size_t{1} << 16;

/// As decimal_string.
void append_decimal(std::string &text, std::uint64_t n, unsigned places) {
  for (; places > 0 && n % 10 == 0; --places)
    n /= 10;
  const fmt::format_int digits(n);
  if (places == 0) {
    text.append(digits.data(), digits.size());
    return;
  }
  const std::size_t before = digits.size() > places ? digits.size() - places : 0;
  if (before == 0)
    text.append("0.").append(places - digits.size(), '0');
  else
    text.append(digits.data(), before) += '.';
  text.append(digits.data() + before, digits.size() - before);
}

/// How a size is written: `begin` lo `between` hi `end`.
struct Frame {
  std::string begin, between, end;

  void append(std::string &text, const ShortSize &size) const {
    text += begin;
    append_decimal(text, size.lo, size.places);
    text += between;
    append_decimal(text, size.lo + 1, size.places);
    text += end;
  }
  void append(std::string &text, const Enclosure &size) const {
    text.append(begin).append(size.lower_text()).append(between).append(size.upper_text()).append(end);
  }
};

/// Text on its way to a sink.
class Stream {
public:
  explicit Stream(const Sink &sink) : sink_(sink) {}
  ~Stream() = default;
  Stream(const Stream &) = delete;
  Stream &operator=(const Stream &) = delete;

  std::string &text() { return text_; }
  void pass_on() {
    if (text_.size() > part)
      finish();
  }
  void finish() {
    sink_(text_);
    text_.clear();
  }

private:
  const Sink &sink_;
  std::string text_;
};

/// The particles of the match, if there is a complete one.
ParticlesOf match_particles(const GeneratedSet &set) {
  return set.match && set.match->complete ? set.match_particles() : nullptr;
}

/// The sizes of class j, of the match's `particles` if there are; `exact` where fractions are to be written
/// as such.
void write_class(const GeneratedSet &set, std::size_t j, const ParticlesOf &particles, const Draws &draws,
                 const Frame &frame, bool exact, Stream &out) {
  const Integer count = set.quantity(j).value_or(0);
  if (count == 0)
    return;
  const auto q = static_cast<std::uint64_t>(count);
  if (particles) {
    particles(j, [&](const Enclosure &size, const Integer &n) {
      for (auto left = static_cast<std::uint64_t>(n); left > 0; --left) {
        frame.append(out.text(), size);
        out.pass_on();
      }
    });
    return;
  }
  const ClassSizes sizes(set.classes[j], set.wanted.dimension, set.digits);
  for (std::uint64_t i = 0; i < q; ++i) {
    if (exact && sizes.has_fractions())
      out.text() += ",\"" + to_string(*sizes.exact(draws(j, i, count))) + "\"";
    else if (const std::optional<ShortSize> quick = sizes.quick(draws.bits(j, i, q)))
      frame.append(out.text(), *quick);
    else
      frame.append(out.text(), sizes.at(draws(j, i, count)));
    out.pass_on();
  }
}

} // namespace

void write_sizes_csv(const GeneratedSet &set, const Draws &draws, const Sink &sink) {
  Stream out(sink);
  out.text() = "class,size_lo,size_hi\n";
  const ParticlesOf particles = match_particles(set);
  for (std::size_t j = 0; j < set.classes.size(); ++j)
    write_class(set, j, particles, draws, {std::to_string(j + 1) + ",", ",", "\n"}, false, out);
  out.finish();
}

void write_sizes_json(const GeneratedSet &set, const Draws &draws, const Sink &sink) {
  // Each size comes with a comma before it, but the first.
  bool first = true;
  const Sink without_first = [&](std::string_view text) {
    if (first && !text.empty()) {
      text.remove_prefix(1);
      first = false;
    }
    sink(text);
  };
  Stream out(without_first);
  const ParticlesOf particles = match_particles(set);
  for (std::size_t j = 0; j < set.classes.size(); ++j)
    write_class(set, j, particles, draws, {",[\"", "\",\"", "\"]"}, true, out);
  out.finish();
}

} // namespace mdm
