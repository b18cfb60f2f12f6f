#include <mdm/match/question.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {

Gradation asked_gradation(Gradation g, const Question &question) {
  if (question.pan_size)
    g = g.with_pan_size(*question.pan_size);
  if (question.cut_below)
    g = g.cut_below(*question.cut_below);
  if (question.size_factor != 1)
    g = g.scaled(question.size_factor);
  return g;
}

namespace {

std::string length_in_words(const Rational &length, SizeUnit unit) {
  return to_decimal(length) + " " + std::string(name(unit));
}

std::string in_words(const Solids &solids, SizeUnit unit) {
  const auto length = [unit](const Rational &l) { return length_in_words(l, unit); };
  if (const Cylinder *c = std::get_if<Cylinder>(&solids))
    return fmt::format("the solids of a cylinder {} x {} at void ratio {}", length(c->diameter),
                       length(c->height), to_decimal(c->void_ratio));
  if (const Box *b = std::get_if<Box>(&solids))
    return fmt::format("the solids of a box {} x {} x {} at void ratio {}", length(b->a), length(b->b),
                       length(b->c), to_decimal(b->void_ratio));
  return fmt::format("a solids volume of {}^3", length(std::get<SolidsVolume>(solids).volume));
}

} // namespace

std::string in_words(const Question &q, SizeUnit unit) {
  std::string words;
  const auto add = [&words](const std::string &part) { words += (words.empty() ? "" : "; ") + part; };
  for (const AskedTolerance &tolerance : q.tolerances)
    add("within " + to_string(tolerance));
  if (q.band)
    add("within the band " + printable(q.band->id));
  if (q.at_least > 1)
    add("at least " + to_string(q.at_least) + " particles");
  if (q.min_per_class > (q.is_tolerant() ? 0 : 1))
    add("at least " + to_string(q.min_per_class) + (q.min_per_class == 1 ? " particle" : " particles") +
        " in each class");
  if (q.solids)
    add("at least " + in_words(*q.solids, unit));
  if (!q.law.is_sphere())
    add("law " + q.law.formula(unit));
  if (q.pan_size)
    add("pan counted as size " + length_in_words(*q.pan_size, unit));
  if (q.cut_below)
    add("classes below " + length_in_words(*q.cut_below, unit) + " left out");
  if (q.size_factor != 1)
    add("sizes multiplied by " + to_decimal(q.size_factor));
  return words;
}

} // namespace mdm
