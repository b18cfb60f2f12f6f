#include "answer/generated_sizes.hpp"

#include "answer/json_values.hpp"
#include "text/long_text.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

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

/// Takes sizes one after the other.
class SizeWriter {
public:
  SizeWriter() = default;
  virtual ~SizeWriter() = default;
  SizeWriter(const SizeWriter &) = delete;
  SizeWriter &operator=(const SizeWriter &) = delete;

  virtual void begin_class(std::size_t) {}
  virtual void bounds(std::string_view lo, std::string_view hi) = 0;
  /// True if the form has a place for fractions.
  virtual bool takes_fractions() const { return false; }
  virtual void fraction(const Rational &) {}

  void size(const Enclosure &x) { bounds(x.lower_text(), x.upper_text()); }
  void size(const ShortSize &x) {
    lo_.clear();
    hi_.clear();
    append_decimal(lo_, x.lo, x.places);
    append_decimal(hi_, x.lo + 1, x.places);
    bounds(lo_, hi_);
  }

private:
  std::string lo_, hi_;
};

class CsvSizes : public SizeWriter {
public:
  explicit CsvSizes(LongText &out) : out_(out) {}
  void begin_class(std::size_t j) override { number_ = j + 1; }
  void bounds(std::string_view lo, std::string_view hi) override { out_.add("{},{},{}\n", number_, lo, hi); }

private:
  LongText &out_;
  std::size_t number_ = 0;
};

class JsonSizes : public SizeWriter {
public:
  explicit JsonSizes(JsonWriter &json) : json_(json) {}
  void bounds(std::string_view lo, std::string_view hi) override { json_.bounds(lo, hi); }
  bool takes_fractions() const override { return true; }
  void fraction(const Rational &x) override { write(json_, x); }

private:
  JsonWriter &json_;
};

/// The particles of the match, if there is a complete one.
ParticlesOf match_particles(const GeneratedSet &set) {
  return set.match && set.match->complete ? set.match_particles() : nullptr;
}

/// The sizes of class j, of the match's `particles` if there are.
void write_class(const GeneratedSet &set, std::size_t j, const ParticlesOf &particles, const Draws &draws,
                 SizeWriter &out) {
  const Integer count = set.quantity(j).value_or(0);
  if (count == 0)
    return;
  out.begin_class(j);
  const auto q = static_cast<std::uint64_t>(count);
  if (particles) {
    particles(j, [&out](const Enclosure &size, const Integer &n) {
      for (auto left = static_cast<std::uint64_t>(n); left > 0; --left)
        out.size(size);
    });
    return;
  }
  const ClassSizes sizes(set.classes[j], set.wanted.dimension, set.digits);
  for (std::uint64_t i = 0; i < q; ++i) {
    if (out.takes_fractions() && sizes.has_fractions())
      out.fraction(*sizes.exact(draws(j, i, count)));
    else if (const std::optional<ShortSize> quick = sizes.quick(draws.bits(j, i, q)))
      out.size(*quick);
    else
      out.size(sizes.at(draws(j, i, count)));
  }
}

void write_classes(const GeneratedSet &set, const Draws &draws, SizeWriter &out) {
  const ParticlesOf particles = match_particles(set);
  for (std::size_t j = 0; j < set.classes.size(); ++j)
    write_class(set, j, particles, draws, out);
}

} // namespace

void write_sizes_csv(const GeneratedSet &set, const Draws &draws, const Sink &sink) {
  LongText out(sink);
  const std::string unit = set.unit.empty() ? "" : "_" + set.unit;
  out.add("class,size_lo{0},size_hi{0}\n", unit);
  CsvSizes rows(out);
  write_classes(set, draws, rows);
  out.finish();
}

void write_sizes_json(const GeneratedSet &set, const Draws &draws, JsonWriter &json) {
  json.begin_array();
  JsonSizes sizes(json);
  write_classes(set, draws, sizes);
  json.end_array();
}

} // namespace mdm
