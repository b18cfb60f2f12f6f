#include "ask/inverse.hpp"

#include "ask/option_values.hpp"
#include "sets/beta_curve.hpp"
#include "soil/indices.hpp"
#include "text/file_names.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

constexpr unsigned index_digits = 40;
constexpr const char *usual_range = "0.1:20";

/// Of the shapes without a span.
std::vector<Rational> usual_spans() {
  std::vector<Rational> spans;
  for (unsigned i = 1; i < 20; ++i)
    spans.push_back(ratio(i, 20));
  for (const int percent : {97, 98, 99})
    spans.push_back(ratio(percent, 100));
  return spans;
}

std::vector<Rational> asked_spans(const std::string &text) {
  std::vector<Rational> spans = number_list("span", text);
  if (spans.back() >= 1)
    throw InputError(option("span") + ": " + to_decimal(spans.back()) +
                     " is not below 1: then d_min would be 0");
  return spans;
}

Interval range_of_parameters(const std::string &text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos)
    throw InputError(option("within") + ": " + in_quotes(text) + " is not FROM:TO: write for example " +
                     usual_range);
  const Rational from = positive("within", text.substr(0, colon)),
                 to = positive("within", text.substr(colon + 1));
  if (from >= to || from < BetaCurve::least_parameter() || to > BetaCurve::largest_parameter())
    throw InputError(option("within") + ": " + in_quotes(text) +
                     ": a and b must be from 0.001 to 1000, and FROM below TO");
  return {from, to};
}

Interval enclosed(const Available<PowerProduct> &index, const std::string &file) {
  if (!index)
    throw file_error(file, index.why().reason + ": C_u and C_c are needed for a fit");
  const Enclosure e = enclose(index->real(), index_digits);
  return {e.lower(), e.upper()};
}

/// The curve of the file: its C_u and C_c, and without --span that between its sieves.
void add_fit(InverseTask &task, const GenerateTexts &asked, const ReadCurve &read) {
  const std::string &file = *asked.fit;
  Gradation g = read_gradation(read(file), shown_name(file), asked.reading.reading());
  task.notes = g.notes();
  in_file(file, [&] {
    if (asked.pan_size)
      g = g.with_pan_size(length("pan-size", *asked.pan_size).in(g));
  });
  const GradingCurve curve(g);
  task.c_u = enclosed(uniformity(curve), file);
  task.c_c = enclosed(curvature(curve), file);
  task.what = fmt::format("the C_u = {} and C_c = {} of {}", rounded(uniformity(curve)->real(), 6),
                          rounded(curvature(curve)->real(), 6), shown_name(file));
  if (asked.span)
    return;
  const Rational least = curve.sizes()[curve.finest()], most = curve.sizes()[curve.coarsest() + 1];
  if (least == 0)
    throw file_error(file, fmt::format("the finest class begins at 0, and the span would be 1: give {} or {}",
                                       option("span"), option("pan-size")));
  task.spans = {Rational((most - least) / (most + least))};
  task.notes.push_back(fmt::format("the span is that from {} to {} mm, the sieves around all mass",
                                   to_decimal(least), to_decimal(most)));
}

void check_alone(const GenerateTexts &c) {
  if (c.fit && (c.c_u || c.c_c))
    throw InputError(option("fit") + ": the file has C_u and C_c: leave out " + option("cu") + " and " +
                     option("cc"));
  if (!c.fit && !(c.c_u && c.c_c))
    throw InputError(option("cu") + " and " + option("cc") + " belong together, or give " + option("fit") +
                     " FILE");
  if (!c.fit && (c.pan_size || c.reading.is_given()))
    throw InputError(option("pan-size") + " and the options of reading need " + option("fit"));
  if (c.accessible || c.a || c.b || c.beta || c.curve || c.d_min || c.d_max || c.ratio || c.between ||
      c.classes || c.classing || c.min_per_class || c.largest_share || c.at_least || c.at_most ||
      c.dimension || c.method || c.match_digits || c.time_limit || c.seed || c.points || c.table ||
      c.digits || c.sizes || c.spread || c.quantiles)
    throw InputError(option("cu") + ", " + option("cc") + " and " + option("fit") +
                     " ask for shapes and make no set: only " + option("span") + ", " + option("within") +
                     " and those of the report go with them");
}

} // namespace

bool asks_for_shapes(const GenerateTexts &c) {
  return c.c_u || c.c_c || c.fit || c.within;
}

InverseTask inverse_task(const GenerateTexts &c, const ReadCurve &read) {
  check_alone(c);
  InverseTask task;
  task.within = range_of_parameters(c.within.value_or(usual_range));
  task.spans = c.span ? asked_spans(*c.span) : usual_spans();
  if (c.fit) {
    add_fit(task, c, read);
    return task;
  }
  task.c_u = positive("cu", *c.c_u);
  task.c_c = positive("cc", *c.c_c);
  if (task.c_u.lo < 1)
    throw InputError(option("cu") + ": " + in_quotes(*c.c_u) + " is below 1, and d_60 is not below d_10");
  task.what = fmt::format("C_u = {} and C_c = {}", to_decimal(task.c_u.lo), to_decimal(task.c_c.lo));
  return task;
}

} // namespace mdm
