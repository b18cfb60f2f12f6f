#include "report/apollonian_report.hpp"

#include "answer/json_values.hpp"
#include "text/long_text.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

constexpr unsigned length_digits = 12;
/// For people.
constexpr unsigned ratio_digits = 5;

/// Decimals around the covered share.
Enclosure covered(const ApollonianReport &r) {
  const Interval share = r.gasket.covered(r.census);
  const Integer unit = power_of_ten(length_digits);
  Enclosure e;
  e.places = length_digits;
  e.lo = floor(Rational(share.lo * Rational(unit)));
  e.hi = ceil(Rational(share.hi * Rational(unit)));
  return e;
}

/// Circles with curvatures up to T / 2^j.
std::vector<std::uint64_t> cumulative(const ApollonianCensus &census) {
  std::vector<std::uint64_t> n(census.octaves.size() + 1);
  for (std::size_t j = census.octaves.size(); j > 0; --j)
    n[j - 1] = n[j] + census.octaves[j - 1];
  while (!n.empty() && n.back() == 0)
    n.pop_back();
  return n;
}

} // namespace

std::string apollonian_text(const ApollonianReport &r) {
  std::string text =
      fmt::format("Apollonian packing {}: {} circles of radius {} and more\ncovered: {} of the outer "
                  "circle\n\n",
                  r.name, r.census.circles, to_string(r.smallest), covered(r).text());
  const std::vector<std::uint64_t> n = cumulative(r.census);
  TextTable table;
  table.add_column("radius from", '>');
  table.add_column("circles", '>');
  table.add_column("exponent", '>');
  Rational radius = r.smallest;
  for (std::size_t j = 0; j < n.size(); ++j, radius *= 2) {
    table.add_line();
    table.add(approximate(radius, ratio_digits));
    table.add(std::to_string(n[j]));
    table.add(j + 1 < n.size() ? rounded(apollonian_slope(n[j], n[j + 1]), ratio_digits) : "");
  }
  return text + table.text() + "\nthe exponent is the slope of log N over log 1/r from a line to the next\n";
}

std::string apollonian_json(const ApollonianReport &r) {
  const std::vector<std::uint64_t> n = cumulative(r.census);
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-apollonian-1").key("gasket").string(r.name);
  write(json.key("smallest"), r.smallest).key("circles").number(r.census.circles);
  write(json.key("covered"), covered(r)).key("sizes").begin_array();
  Rational radius = r.smallest;
  for (std::size_t j = 0; j < n.size(); ++j, radius *= 2) {
    write(json.begin_object().key("radius"), radius).key("circles").number(n[j]).key("exponent");
    if (j + 1 < n.size())
      write(json, enclose(apollonian_slope(n[j], n[j + 1]), length_digits));
    else
      json.null();
    json.end_object();
  }
  return json.end_array().key("versions").raw(versions_json()).end_object().take();
}

void apollonian_csv(const std::string &name, const ApollonianGasket &gasket, const Rational &most,
                    const Sink &sink) {
  const bool surd = name == "equal";
  LongText text(sink);
  text.add("# Apollonian packing {}: curvature k = p{}, centre ({}), the outer circle's is 0\n"
           "p,q,x,y\n",
           name, surd ? " + q sqrt 3" : "",
           surd ? std::string("x / k, y / (k sqrt 3)")
                : fmt::format("x / ({0} k), y / ({0} k)", gasket.scale()));
  gasket.each(most, [&](const ApollonianCircle &c) { text.add("{},{},{},{}\n", c.p, c.q, c.x, c.y); });
  text.finish();
}

} // namespace mdm
