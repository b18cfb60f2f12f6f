#include "answer/number_answer.hpp"

#include "text/json_writer.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>

namespace mdm {
namespace {

/// q / N in percent: exact if that is a short decimal, else its first digits.
std::string achieved_percent(const NumberAnswer &a, std::size_t j) {
  constexpr unsigned digits = 7;
  return approximate(Rational(ratio(a.match.quantities[j], a.match.particles) * 100), digits);
}

std::string fraction_text(const Rational &r) {
  const Integer n = numerator(r), d = denominator(r);
  return d == 1 ? to_string(n) : to_string(n) + "/" + to_string(d);
}

std::string asked_words(const NumberAnswer &a) {
  std::string words;
  for (const AskedTolerance &t : a.asked)
    words += (words.empty() ? "" : ", ") + to_string(t);
  return words.empty() ? "exactly" : "within " + words;
}

} // namespace

std::string headline(const NumberAnswer &a) {
  const std::string particles =
      to_string(a.match.particles) + (a.match.particles == 1 ? " particle has" : " particles have");
  const std::string shares = " the shares by number " + asked_words(a);
  return a.match.is_smallest()
             ? particles + shares + "; no smaller set has"
             : particles + " the shares by number exactly; the least set that has them " + asked_words(a) +
                   " has at least " + to_string(a.match.lower_bound) + ", the limit of steps was reached";
}

std::string number_text(const NumberAnswer &a) {
  const std::string unit(name(a.gradation.unit()));
  const std::vector<Rational> target = shares(a.gradation);
  std::vector<std::vector<std::string>> rows = {
      {"above (" + unit + ")", "up to (" + unit + ")", "asked (%)", "has (%)", "quantity"}};
  for (std::size_t j = 0; j < a.gradation.classes(); ++j)
    rows.push_back({a.gradation.opening_text(j), a.gradation.opening_text(j + 1),
                    approximate(Rational(target[j] * 100), 7), achieved_percent(a, j),
                    to_string(a.match.quantities[j])});
  std::string text = a.gradation.id() + ": " + headline(a) +
                     ".\nShares of the number of particles, not of mass; " +
                     "a particle may have any size of its class.\n\n";
  text += text_table(rows, ">");
  for (const std::string &note : a.notes)
    text += "  note: " + note + "\n";
  return text;
}

std::string number_json(const NumberAnswer &a) {
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-number-1").key("id").string(a.gradation.id());
  json.key("status").plain(a.match.is_smallest() ? "optimal" : "feasible");
  json.key("particles").plain(to_string(a.match.particles));
  json.key("lower_bound").plain(to_string(a.match.lower_bound));
  json.key("unit").plain(name(a.gradation.unit())).key("tolerances").begin_array();
  for (const AskedTolerance &t : a.asked)
    json.plain(to_string(t));
  json.end_array().key("classes").begin_array();
  const std::vector<Rational> target = shares(a.gradation);
  for (std::size_t j = 0; j < a.gradation.classes(); ++j)
    json.begin_object()
        .key("lower")
        .plain(a.gradation.opening_text(j))
        .key("upper")
        .plain(a.gradation.opening_text(j + 1))
        .key("share")
        .plain(fraction_text(target[j]))
        .key("achieved")
        .plain(fraction_text(ratio(a.match.quantities[j], a.match.particles)))
        .key("quantity")
        .plain(to_string(a.match.quantities[j]))
        .end_object();
  json.end_array().key("notes").strings(a.notes).key("versions").raw(versions_json());
  return json.end_object().take();
}

std::string number_csv(const NumberAnswer &a) {
  TextBuffer out;
  add(out, "lower_{0},upper_{0},number_share,quantity\n", name(a.gradation.unit()));
  const std::vector<Rational> target = shares(a.gradation);
  for (std::size_t j = 0; j < a.gradation.classes(); ++j)
    add(out, "{},{},{},{}\n", a.gradation.opening_text(j), a.gradation.opening_text(j + 1),
        fraction_text(target[j]), to_string(a.match.quantities[j]));
  return fmt::to_string(out);
}

} // namespace mdm
