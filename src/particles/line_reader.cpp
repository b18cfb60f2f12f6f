#include "particles/line_reader.hpp"

#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

namespace mdm {

ParticleSource::ParticleSource(std::string file, ParticleSink &sink, const ParticleOptions &options)
    : file_(std::move(file)), sink_(sink), options_(options) {
  set_defaults(SizeMeaning::diameter, options.target);
}

void ParticleSource::refuse(const std::string &what) const {
  throw InputError(fmt::format("{}:{}: {}", printable(file_), std::max<std::uint64_t>(line_, 1), what));
}

void ParticleSource::set_defaults(SizeMeaning meaning, SizeUnit unit) {
  meaning_ = options_.meaning.value_or(meaning);
  unit_ = options_.unit.value_or(unit);
  length_ = (stated_ ? stated_->in_mm : in_mm(unit_)) / in_mm(options_.target);
  factor_ = length_ * (meaning_ == SizeMeaning::radius ? 2 : 1);
}

void ParticleSource::take_unit(const StatedUnit &unit, std::string_view words) {
  if (options_.unit && in_mm(*options_.unit) != unit.in_mm)
    refuse(fmt::format("the file says {}, which is lengths in {}, and {} was given: leave that out", words,
                       unit.name, name(*options_.unit)));
  if (any_ && (!stated_ || stated_->in_mm != unit.in_mm))
    refuse(fmt::format("the file says {} below particles in {}: give particles of one unit", words,
                       stated_ ? stated_->name : name(unit_)));
  stated_ = unit;
  set_defaults(meaning_, unit_);
}

RootSize ParticleSource::diameter(std::string_view text, char point, const ReadSize &read) const {
  const char *const what = meaning_ == SizeMeaning::radius ? "radius" : "diameter";
  RootSize size;
  try {
    size = read(text, point);
  } catch (const InputError &error) {
    refuse(fmt::format("{} {}", what, error.what()));
  }
  if (size.power <= 0)
    refuse(fmt::format("{} {} is not above 0: a particle has a size", what, in_quotes(text)));
  if (factor_ != 1)
    size.power *= power(factor_, size.degree);
  return size;
}

void ParticleSource::particle(std::string_view text, const Integer &quantity, char point,
                              const ReadSize &read) {
  sink_.add(diameter(text, point, read), quantity);
  count(quantity);
}

void ParticleSource::particle_at(const SphereSample::Place &place, std::string_view size, char point,
                                 const ReadSize &read) {
  check_place(place);
  if (!sink_.wants_places() || is_tilted_) {
    particle(size, 1, point, read);
    return;
  }
  const RootSize x = diameter(size, point, read);
  try {
    sink_.add_at(place, length_, x);
  } catch (const InputError &error) {
    refuse(std::string("coordinate ") + error.what());
  }
  any_ = true;
  if (stated_count_)
    ++count_;
}

void ParticleSource::leave_out_places() {
  const std::string left_out =
      "The box is tilted: the places are left out, as boxes have sides along the axes here.";
  if (sink_.wants_places() && std::find(notes_.begin(), notes_.end(), left_out) == notes_.end())
    note(left_out);
  is_tilted_ = true;
}

void ParticleSource::check_number(std::string_view word) const {
  if (!is_number(word))
    refuse(fmt::format("{} is not a number: is the file damaged?", in_quotes(word)));
}

void ParticleSource::check_place(const SphereSample::Place &place) const {
  for (const std::string_view word : place) {
    const std::size_t comma = word.find(',');
    const bool is_decimal = comma == std::string_view::npos
                                ? is_number(word)
                                : is_number(std::string(word).replace(comma, 1, "."));
    if (!is_decimal)
      refuse(fmt::format("coordinate {} is not a finite number: a particle has a place; is the file damaged, "
                         "or did the simulation fail?",
                         in_quotes(word)));
  }
}

Rational ParticleSource::number(const char *what, std::string_view text, char point) const {
  try {
    return parse_decimal(text, point);
  } catch (const InputError &error) {
    refuse(fmt::format("{} {}", what, error.what()));
  }
}

void ParticleSource::check_agree(std::string_view radius, std::string_view diameter) const {
  if (2 * number("radius", radius) != number("diameter", diameter))
    refuse(fmt::format("radius {} is not half of diameter {}: leave one of the two columns out, or say by "
                       "{} or {} which counts",
                       in_quotes(radius), in_quotes(diameter), option("radius"), option("diameter")));
}

void ParticleSource::take_id(std::string_view id) {
  const std::optional<std::uint64_t> number = parse_count(id);
  if (!number)
    refuse(fmt::format("id {} is not a whole number from 0 on: is the file damaged?", in_quotes(id)));
  if (!ids_.insert(*number))
    refuse(fmt::format("id {} is there a second time: each particle has an id of its own; was one written "
                       "twice, and is another one lost?",
                       *number));
}

void ParticleSource::take_material(const std::string &name) {
  try {
    sink_.set_material(name);
  } catch (const InputError &error) {
    refuse(error.what());
  }
}

void ParticleSource::take_class(std::string_view number) {
  if (const std::optional<std::uint64_t> n = parse_count(number))
    sink_.set_class(*n);
}

std::size_t ParticleSource::column(const std::vector<std::string> &names, std::string_view name,
                                   const char *example) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end() || std::count(found, names.end(), name) > 1)
    refuse(fmt::format("there is not one column {}: write {}", name, example));
  return static_cast<std::size_t>(found - names.begin());
}

void ParticleSource::set_box(const std::array<std::array<std::string, 2>, 3> &bounds,
                             const std::array<bool, 3> &periodic) {
  is_tilted_ = false;
  if (!sink_.wants_places())
    return;
  ParticleBox box;
  box.periodic = periodic;
  try {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.sides.low[axis] = parse_decimal(bounds[axis][0]) * length_;
      box.sides.high[axis] = parse_decimal(bounds[axis][1]) * length_;
    }
  } catch (const InputError &error) {
    refuse(std::string("bound of the box ") + error.what());
  }
  if (box.sides.is_empty())
    refuse("the box is empty: give each axis a lower bound and a greater upper one");
  sink_.set_box(box);
}

void ParticleSource::particle_between(std::string_view lo, std::string_view hi, std::string_view lower,
                                      const Integer &quantity, char point) {
  SizeRange size;
  try {
    size.lo = parse_decimal(lo, point);
    size.hi = parse_decimal(hi, point);
    size.is_open = !lower.empty() && size.lo <= parse_decimal(lower, point);
  } catch (const InputError &error) {
    refuse(std::string("size ") + error.what());
  }
  if (size.lo < 0 || size.hi < size.lo || size.hi == 0)
    refuse(fmt::format("a size between {} and {} is none: the first is above 0 and at most the second",
                       in_quotes(lo), in_quotes(hi)));
  size.lo *= factor_;
  size.hi *= factor_;
  sink_.add(size, quantity);
  count(quantity);
}

void ParticleSource::begin_timestep(const Integer &number) {
  sink_.begin_timestep(number);
  ids_.clear();
  any_ = false;
  is_tilted_ = false;
  count_ = 0;
}

void ParticleSource::take_title(std::string_view line) {
  constexpr std::string_view begin = "Particles of ", end = ", by exactmdm; ";
  const std::size_t words = std::min(line.find_first_not_of("#/ "), line.size());
  const std::size_t last = line.find(end);
  if (words == 0 || !line.substr(words).starts_with(begin) || last == std::string_view::npos)
    return;
  // `: 141 in 5`
  const std::size_t colon = line.rfind(": ", last);
  const std::string_view count = line.substr(std::min(colon, line.size() - 2) + 2);
  stated_count_ = parse_natural(count.substr(0, count.find(' ')));
}

void ParticleSource::check_count() const {
  if (stated_count_ && *stated_count_ != count_)
    refuse(fmt::format("the file's title says {} particles, and there are {}: is the file cut off? else put "
                       "the number in its "
                       "title right",
                       to_string(*stated_count_), to_string(count_)));
}

std::string ParticleSource::size_note() const {
  const std::string otherwise = stated_ ? ", as the file says"
                                : options_.says_otherwise.empty()
                                    ? ""
                                    : "; " + options_.says_otherwise + " otherwise";
  return fmt::format("The sizes were taken as {} in {}{}.",
                     meaning_ == SizeMeaning::radius ? "radii" : "diameters",
                     stated_ ? stated_->name : name(unit_), otherwise);
}

void ParticleSource::check_some() const {
  if (!any_)
    refuse("there are no particles: the file ends before the first");
}

std::string_view take_word(std::string_view &rest) {
  const auto is_other = [](char c) { return !is_blank(c); };
  const auto begin = std::find_if(rest.begin(), rest.end(), is_other);
  const auto end = std::find_if(begin, rest.end(), is_blank);
  const std::string_view word =
      rest.substr(static_cast<std::size_t>(begin - rest.begin()), static_cast<std::size_t>(end - begin));
  rest.remove_prefix(static_cast<std::size_t>(end - rest.begin()));
  return word;
}

void split_words(std::string_view line, std::vector<std::string_view> &words) {
  words.clear();
  for (std::string_view word = take_word(line); !word.empty() && words.size() <= max_fields;
       word = take_word(line))
    words.push_back(word);
}

bool is_number(std::string_view text) {
  std::size_t at = 0;
  const auto skip_sign = [&] { at += at < text.size() && (text[at] == '+' || text[at] == '-') ? 1U : 0U; };
  const auto skip_digits = [&] {
    const std::size_t begin = at;
    while (at < text.size() && is_digit(text[at]))
      ++at;
    return at - begin;
  };
  skip_sign();
  std::size_t digits = skip_digits();
  if (at < text.size() && text[at] == '.') {
    ++at;
    digits += skip_digits();
  }
  if (digits == 0)
    return false;
  if (at < text.size() && lower(text[at]) == 'e') {
    ++at;
    skip_sign();
    if (skip_digits() == 0)
      return false;
  }
  return at == text.size();
}

bool is_zero_number(std::string_view text) {
  return is_number(text) &&
         text.substr(0, text.find_first_of("eE")).find_first_of("123456789") == std::string_view::npos;
}

std::optional<std::uint64_t> parse_count(std::string_view text) {
  std::uint64_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc{} || end != text.data() + text.size() || n > (std::uint64_t{1} << 62))
    return std::nullopt;
  return n;
}

} // namespace mdm
