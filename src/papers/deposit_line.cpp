#include "papers/deposit_line.hpp"

#include "text/json_tree.hpp"
#include "text/json_writer.hpp"

#include <mdm/number/decimal.hpp>

#include <charconv>

namespace mdm {
namespace {

std::uint64_t count(const nlohmann::json &value) {
  const auto &text = value.get_ref<const std::string &>();
  std::uint64_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc() || end != text.data() + text.size())
    throw InputError(no_deposit_line);
  return n;
}

DepositFacts facts(const nlohmann::json &line) {
  DepositFacts f;
  f.discs = count(line.at("discs"));
  const Rational lo = parse_decimal(line.at("packing_fraction").at(0).get<std::string>()),
                 hi = parse_decimal(line.at("packing_fraction").at(1).get<std::string>());
  if (f.discs == 0 || hi < lo)
    throw InputError(no_deposit_line);
  f.fraction = {lo, hi};
  f.contacts = count(line.at("contacts"));
  f.outer_supports = count(line.at("outer_supports"));
  for (const nlohmann::json &some : line.at("coordination"))
    f.coordination[static_cast<std::uint32_t>(count(some.at(0)))] = count(some.at(1));
  const nlohmann::json &cells = line.at("cells");
  f.cells = {count(cells.at(0)), count(cells.at(1)), count(cells.at(2)), count(cells.at(3))};
  return f;
}

/// What `value` makes of a line.
template <class Value>
auto read(std::string_view text, Value value) {
  try {
    return value(json_tree(text));
  } catch (const nlohmann::json::exception &) {
    throw InputError(no_deposit_line);
  } catch (const InputError &) {
    throw InputError(no_deposit_line);
  }
}

} // namespace

std::string deposit_line(const KeptDeposit &deposit) {
  const DepositFacts &f = deposit.facts;
  JsonWriter json;
  json.begin_object().key("deposit").string(deposit.key).key("discs").number(f.discs);
  json.key("packing_fraction").bounds(to_decimal(f.fraction.lo), to_decimal(f.fraction.hi));
  json.key("contacts").number(f.contacts).key("outer_supports").number(f.outer_supports);
  json.key("coordination").begin_array();
  for (const auto &[contacts, discs] : f.coordination)
    json.begin_array().number(contacts).number(discs).end_array();
  json.end_array().key("cells").begin_array();
  for (const std::uint64_t n : {f.cells.triangles, f.cells.quadrangles, f.cells.pentagons, f.cells.larger})
    json.number(n);
  json.end_array().end_object();
  return json.take();
}

std::string terms_line(const std::string &terms) {
  return JsonWriter().begin_object().key("terms").string(terms).end_object().take();
}

std::string read_terms_line(std::string_view text) {
  return read(text, [](const nlohmann::json &line) { return line.at("terms").get<std::string>(); });
}

KeptDeposit read_deposit_line(std::string_view text) {
  return read(text, [](const nlohmann::json &line) {
    return KeptDeposit{line.at("deposit").get<std::string>(), facts(line)};
  });
}

} // namespace mdm
