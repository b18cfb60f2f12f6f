#include "answers.hpp"

#include "json_text.hpp"
#include "law.hpp"
#include "verify.hpp"

#include <algorithm>

namespace mdm::checker {
namespace {

/// A decimal or p/q.
mpq_class rational(const std::string &text, std::string_view place) {
  constexpr std::size_t most_digits = 200'000;
  const std::size_t slash = text.find('/');
  const mpq_class p = read_decimal(text.substr(0, slash), place, most_digits);
  if (slash == std::string::npos)
    return p;
  const mpq_class q = read_decimal(text.substr(slash + 1), place, most_digits);
  demand_form(q > 0, place, "is no fraction: give what mdm batch wrote", text);
  return p / q;
}

mpz_class integer(const std::string &text, std::string_view place) {
  const mpq_class value = rational(text, place);
  demand_form(value.get_den() == 1, place, "is no integer: give what mdm batch wrote", text);
  return value.get_num();
}

/// A line of JSON.
class JsonAnswer : JsonText {
public:
  using JsonText::JsonText;

  Answer read() {
    Answer answer;
    AnswerQuestion question;
    object([&](const std::string &key) {
      if (key == "status")
        question.status = string();
      else if (key == "particles")
        question.particles = optional_integer();
      else if (key == "lower_bound")
        question.lower_bound = optional_integer();
      else if (key == "classes")
        sequence('[', ']', [&] { answer.classes.push_back(read_class(answer)); });
      else if (key == "tolerance")
        read_tolerance(question);
      else if (key == "question")
        question.words = string();
      else if (key == "unit" && !take_null())
        answer.unit = string();
      else if (key != "unit")
        skip();
    });
    demand_form(peek() == '\0', rest_, "follows the JSON object: give one object a line", rest_);
    answer.question = std::move(question);
    return answer;
  }

private:
  bool take_null() {
    const bool is_null = peek() == 'n';
    if (is_null)
      skip();
    return is_null;
  }
  mpq_class fraction() { return rational(string(), rest_); }
  std::optional<mpz_class> optional_integer() {
    return take_null() ? std::nullopt : std::optional(integer(string(), rest_));
  }

  AnswerClass read_class(Answer &answer) {
    AnswerClass c;
    std::optional<std::pair<mpq_class, mpq_class>> powers;
    object([&](const std::string &key) {
      if (key == "lower")
        c.lower = fraction();
      else if (key == "upper")
        c.upper = fraction();
      else if (key == "lower_power")
        powers.emplace(fraction(), 0);
      else if (key == "upper_power" && powers)
        powers->second = fraction();
      else if (key == "quantity")
        c.quantity = optional_integer().value_or(0);
      else if (key == "size" && !take_null())
        sequence('[', ']', [&] { (c.lo ? c.hi : c.lo) = fraction(); });
      else if (key != "size")
        skip();
    });
    if (powers) {
      std::tie(c.lower, c.upper) = *powers;
      answer.has_powers = true;
    }
    return c;
  }

  void read_tolerance(AnswerQuestion &question) {
    if (take_null())
      return;
    question.is_tolerant = true;
    const auto add = [&](const std::string &words) {
      question.tolerances += (question.tolerances.empty() ? "within " : "; within ") + words;
    };
    object([&](const std::string &key) {
      if (key == "asked")
        sequence('[', ']', [&] { add(string()); });
      else if (key == "band" && !take_null())
        add("the band " + printable(string()));
      else if (key == "retained" || key == "passing")
        (key == "retained" ? question.retained : question.passing) = ranges();
      else if (key == "total" && !take_null())
        question.total = fraction();
      else if (key != "band" && key != "total")
        skip();
    });
  }

  ShareRanges ranges() {
    ShareRanges result;
    sequence('[', ']', [&] {
      std::vector<mpq_class> bounds;
      sequence('[', ']', [&] { bounds.push_back(fraction()); });
      demand_form(bounds.size() == 2, rest_, "a range of shares needs two bounds: give what mdm batch wrote");
      result.emplace_back(bounds[0], bounds[1]);
    });
    return result;
  }
};

constexpr const char *csv_columns = "id,class,lower,upper,share_percent,quantity,size_lo,size_hi";
constexpr const char *tolerant_columns = "id,class,lower,upper,match_share_percent,quantity,size_lo,size_hi";

/// The unit of the header of answers in CSV, empty where it names none; nothing of another line. The shares
/// are not compared: a table may say that they are those of the matches.
std::optional<std::string> unit_of_header(const std::string &line) {
  for (const std::string unit : {"", "mm", "um", "m"}) {
    const std::string ending = unit.empty() ? "" : "_" + unit;
    std::string names = line;
    for (std::size_t at = 0; !ending.empty() && (at = names.find(ending + ",", at)) != std::string::npos;)
      names.erase(at, ending.size());
    if (names.ends_with(ending))
      names.erase(names.size() - ending.size());
    if (names.starts_with(csv_columns) || names.starts_with(tolerant_columns))
      return unit;
  }
  return std::nullopt;
}

/// What batch calls the answer of a line: its id, or else its number; nothing of a line that is no object.
std::optional<std::string> id_of(const Input &line, std::uint64_t number) {
  class Id : JsonText {
  public:
    using JsonText::JsonText;
    std::optional<std::string> read() {
      std::optional<std::string> id;
      object([&](const std::string &key) {
        if (key == "id")
          id = peek() == '"' ? string() : std::string(number());
        else
          skip();
      });
      return id;
    }
  };
  try {
    return Id(line.text).read().value_or(std::to_string(number));
  } catch (const Malformed &) {
    return std::nullopt;
  }
}

bool is_gradation(const Input &line) {
  try {
    read_gradation(line.text);
    return true;
  } catch (const Malformed &) {
    return false;
  }
}

/// Column 1 is the class, from 1.
std::vector<std::string> csv_row(const Input &line) {
  std::vector<std::string> fields = csv_fields(line.text, ',');
  demand_form(fields.size() == 8, line.text, "is no row of answers in CSV: give what mdm batch wrote",
              line.text);
  return fields;
}

/// Takes a row; rows without a quantity are of an answer without particles.
void take_csv_class(const Input &line, Answer &answer) {
  const std::vector<std::string> fields = csv_row(line);
  const bool has_none = fields[5].empty();
  demand_form(answer.classes.empty() || has_none == answer.has_no_particles, line.text,
              "has a quantity where other rows of its answer have none, or none where they have one",
              line.text);
  answer.has_no_particles = has_none;
  const auto optional = [&](std::size_t i) {
    return fields[i].empty() ? std::nullopt : std::optional(rational(fields[i], line.text));
  };
  answer.classes.push_back({rational(fields[2], line.text), rational(fields[3], line.text),
                            has_none ? mpz_class(0) : integer(fields[5], line.text), optional(6),
                            optional(7)});
}

/// The options of a certificate that are no tolerances, in the words of an answer.
std::string options_in_words(const Certificate &c, const std::string &unit) {
  std::string words;
  const auto add = [&](std::string_view part, const Numbers &numbers) {
    if (numbers.empty())
      return;
    words += words.empty() ? "" : "; ";
    auto number = numbers.begin();
    for (const char ch : part)
      words += ch == '#' ? std::string((number++)->text) : ch == '@' ? unit : std::string{ch};
  };
  add("at least # particles", c.at_least);
  const bool one = !c.min_per_class.empty() && c.min_per_class[0].value == 1;
  add(one ? "at least # particle in each class" : "at least # particles in each class", c.min_per_class);
  add("at least the solids of a cylinder # @ x # @ at void ratio #", c.cylinder);
  add("at least the solids of a box # @ x # @ x # @ at void ratio #", c.box);
  add("at least a solids volume of # @^3", c.solids_volume);
  if (!is_power(c))
    add("law " + law_by_values(c, unit), c.law);
  else if (c.law[0].value != 3)
    add("law x^(#)", c.law);
  add("pan counted as size # @", c.pan_size);
  add("classes below # @ left out", c.cut_below);
  add("sizes multiplied by #", c.size_factor);
  return words;
}

/// The same bounds in all classes; of what passes the last one, which is everything, nothing is asked.
bool same_bounds(const ShareRanges &answer, const ShareRanges &proof, std::size_t classes) {
  const auto of = [&](std::size_t j) {
    return answer.empty() ? std::pair<mpq_class, mpq_class>(0, 1) : answer[j];
  };
  if (!answer.empty() && answer.size() != proof.size())
    return false;
  for (std::size_t j = 0; j < classes; ++j)
    if (of(j) != proof[j])
      return false;
  return true;
}

std::string difference_of_tolerance(const AnswerQuestion &answer, const Gradation &gradation,
                                    const Certificate &c) {
  if (answer.is_tolerant == c.tree.empty())
    return c.tree.empty() ? "the proof is of an exact match" : "the proof is of a match within a tolerance";
  if (!answer.is_tolerant)
    return {};
  ShareRanges retained, passing;
  for (const BoundsOnShares &b : bounds_on_shares(gradation, c)) {
    retained.emplace_back(b.least_retained, b.most_retained);
    passing.emplace_back(b.least_passing, b.most_passing);
  }
  if (!same_bounds(answer.retained, retained, retained.size()))
    return "the proof has another tolerance of what is retained";
  if (!same_bounds(answer.passing, passing, passing.size() - 1))
    return "the proof has another tolerance of what passes";
  const mpq_class total = c.total.empty() ? mpq_class(2) : mpq_class(c.total[0].value / 100);
  return answer.total.value_or(2) == total ? "" : "the proof has another total tolerance";
}

std::string difference_of_claim(const AnswerQuestion &answer, const Certificate &c) {
  const bool none = c.bound.empty(), has_sample = !c.particles.empty();
  const mpz_class bound = integer_of(c.bound), N = integer_of(c.particles);
  // With a bound of 2 or more there is none of few particles (--at-most, which an answer does not repeat).
  const mpz_class lower_bound = answer.lower_bound.value_or(0);
  if (answer.status == "none")
    return !answer.particles && (none || (lower_bound >= 2 && lower_bound <= bound))
               ? ""
               : "the answer is that there is no match";
  if (answer.status == "optimal")
    return has_sample && bound == N && answer.particles == N
               ? ""
               : "the answer is that " + answer.particles.value_or(0).get_str() +
                     " particles are the smallest match";
  const bool is_open = answer.status == "feasible" || answer.status == "unknown";
  if (!is_open || none || lower_bound > bound)
    return "the answer has the status " + quoted(answer.status) + " and the lower bound " +
           lower_bound.get_str();
  return !answer.particles || !has_sample || *answer.particles == N
             ? ""
             : "the answer has " + answer.particles->get_str() + " particles";
}

std::string difference_of_question(const AnswerQuestion &answer, const Gradation &gradation,
                                   const Certificate &c) {
  if (std::string what = difference_of_claim(answer, c); !what.empty())
    return what;
  if (std::string what = difference_of_tolerance(answer, gradation, c); !what.empty())
    return what;
  const std::string options = options_in_words(c, gradation.unit());
  const bool both = !answer.tolerances.empty() && !options.empty();
  return answer.words == answer.tolerances + (both ? "; " : "") + options
             ? ""
             : "the answer is to " + quoted(answer.words) + ", the proof to " + quoted(options);
}

/// Of the classes' openings, quantities and sizes.
std::string difference_of_classes(const Answer &answer, const Gradation &gradation, const Certificate &c) {
  const Rationals &x = gradation.openings;
  if (answer.classes.size() + 1 != x.size())
    return "the answer has " + std::to_string(answer.classes.size()) + " classes";
  auto witness = c.classes.begin();
  for (std::size_t j = 0; j < answer.classes.size(); ++j) {
    const AnswerClass &of = answer.classes[j];
    const std::string name = "class " + std::to_string(j + 1) + " has ";
    if ((gradation.root == 1 || answer.has_powers) && (of.lower != x[j] || of.upper != x[j + 1]))
      return name + "other openings";
    if (answer.has_no_particles)
      continue;
    const bool has_particles = witness != c.classes.end() && witness->index == j + 1;
    if (of.quantity != (has_particles ? witness->quantity : mpz_class(0)))
      return name + of.quantity.get_str() + " particles";
    if (has_particles ? of.lo != witness->lo || of.hi != witness->hi : of.lo.has_value())
      return name + "particles of another size";
    witness += has_particles ? 1 : 0;
  }
  return {};
}

} // namespace

std::optional<Input> Answers::next_line() {
  std::optional<Input> line = lines_.next();
  while (line && line->text.find_first_not_of(" \t\r") == std::string::npos)
    line = lines_.next();
  return line;
}

SharedAnswer Answers::next() {
  if (later_)
    return std::exchange(later_, nullptr);
  std::optional<Input> line = row_ ? std::exchange(row_, std::nullopt) : next_line();
  if (const auto unit = line && lines_.number() == 1 ? unit_of_header(line->text) : std::nullopt) {
    is_csv_ = true;
    unit_ = *unit;
    line = next_line();
  }
  if (!line)
    return nullptr;
  try {
    if (!is_csv_) {
      auto answer = std::make_shared<Answer>(JsonAnswer(line->text).read());
      answer->place = printable(line->name);
      return answer;
    }
    auto answer = std::make_shared<Answer>();
    answer->place = printable(line->name);
    answer->id = csv_row(*line)[0];
    answer->unit = unit_;
    do
      take_csv_class(*line, *answer);
    while ((line = next_line()) && csv_row(*line)[1] != "1");
    row_ = std::move(line);
    return answer;
  } catch (const Malformed &error) {
    throw Broken(printable(line->name) + ": " + error.what());
  }
}

SharedAnswer Answers::of(const Input &line, std::uint64_t number) {
  SharedAnswer answer = next();
  if (!answer && !is_csv_)
    throw Broken(printable(name()) + ": no answer of " + printable(line.name) +
                 ": give the answers of this suite");
  if (!answer || !is_csv_ || (answer->id == id_of(line, number) && is_gradation(line)))
    return answer;
  later_ = std::move(answer);
  return nullptr;
}

std::string difference(const Answer &answer, std::string_view gradation_text,
                       std::string_view certificate_text) {
  Gradation gradation = read_gradation(gradation_text);
  const Certificate certificate = read_certificate(certificate_text);
  apply_question(gradation, certificate);
  if (!answer.unit.empty() && answer.unit != gradation.unit())
    return "the answer has lengths in " + quoted(answer.unit) + ", the gradation in " + gradation.unit();
  if (answer.question)
    if (std::string what = difference_of_question(*answer.question, gradation, certificate); !what.empty())
      return what;
  const bool has_no_sample = answer.question && !answer.question->particles;
  return has_no_sample ? "" : difference_of_classes(answer, gradation, certificate);
}

} // namespace mdm::checker
