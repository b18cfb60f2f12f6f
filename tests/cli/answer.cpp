#include "answer.hpp"

#include <algorithm>

namespace cli_test {

Rational rational(const Json &text) {
  std::string digits = text.get<std::string>();
  std::string::size_type point = digits.find('.');
  if (point == std::string::npos)
    return Rational(digits);
  const std::size_t places = digits.size() - point - 1;
  digits.erase(point, 1);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1)); // 0... would be octal
  return Rational(Integer(digits), boost::multiprecision::pow(Integer(10), static_cast<unsigned>(places)));
}

Rational cube(const Rational &x) {
  return x * x * x;
}

std::string quantities(const Json &answer) {
  std::string text;
  for (const Json &c : answer.at("classes"))
    text += (text.empty() ? "" : " ") + c.at("quantity").get<std::string>();
  return text;
}

Json solve_json(Arguments arguments, int exit_code, const std::string &standard_input) {
  arguments.insert(arguments.begin(), "solve");
  arguments.insert(arguments.end(), {"--format", "json"});
  const Outcome outcome = mdm(arguments, standard_input);
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == exit_code);
  CHECK(outcome.err.empty());
  REQUIRE(Json::accept(outcome.out));
  return Json::parse(outcome.out);
}

void check_match(const Json &answer) {
  INFO(answer.dump());
  CHECK(answer.at("schema") == "mdm-answer-1");
  CHECK(answer.at("id").is_string());
  CHECK(answer.at("tolerance").is_null());
  CHECK(answer.at("notes").is_array());
  CHECK(answer.at("versions").contains("mdm"));
  const Rational s = rational(answer.at("scale").at("chosen"));
  Rational above = 0, up_to = -1, upper_before = -1;
  Integer particles = 0;
  for (const Json &c : answer.at("classes")) {
    const Rational lower = rational(c.at("lower")), upper = rational(c.at("upper")),
                   mass = rational(c.at("mass"));
    CHECK(lower < upper);
    CHECK(lower >= upper_before);
    upper_before = upper;
    const Integer q(c.at("quantity").get<std::string>());
    particles += q;
    if (q == 0) {
      CHECK(mass == 0);
      CHECK(c.at("size").is_null());
      continue;
    }
    const Rational lo = rational(c.at("size").at(0)), hi = rational(c.at("size").at(1)),
                   volume = s * mass / q;
    CHECK(lower < lo);
    CHECK(hi <= upper);
    CHECK((lo == hi ? cube(lo) == volume : (cube(lo) <= volume && volume < cube(hi))));
    above = std::max<Rational>(above, q * cube(lower) / mass);
    const Rational end = q * cube(upper) / mass;
    up_to = up_to < 0 ? end : std::min<Rational>(up_to, end);
  }
  CHECK(answer.at("particles") == particles.str());
  CHECK(rational(answer.at("scale").at("above")) == above);
  CHECK(rational(answer.at("scale").at("up_to")) == up_to);
  CHECK(above < s);
  CHECK(s <= up_to);
  CHECK(rational(answer.at("solids_volume").at(0)) < rational(answer.at("solids_volume").at(1)));
}

} // namespace cli_test
