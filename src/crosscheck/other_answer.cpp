// Answers of other solvers as they write them: JSON Lines in several forms, and CSV. What comes in is a
// line; what goes out are counts, sizes where they are stated, an id and labels, or the reason why there
// are none. Nothing is judged here: a line that cannot be read is an answer that failed, with its id where
// that is known, and the run goes on.

#include "crosscheck/other_answer.hpp"

#include "answer/answer_reader.hpp"
#include "answer/string_members.hpp"
#include "crosscheck/batch_rows.hpp"
#include "number/long_decimal.hpp"
#include "particles/particle_format.hpp"
#include "text/json_tree.hpp"
#include "text/json_writer.hpp"
#include "text/lines.hpp"
#include "text/source.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace mdm {
namespace {

using Json = nlohmann::json;

/// Also `15.0`, as programs write that compute in floating point.
Integer quantity(std::string_view text) {
  try {
    const Rational value = parse_long_decimal(text);
    if (denominator(value) == 1 && value >= 0)
      return numerator(value);
  } catch (const InputError &) { // said below
  }
  throw InputError("quantity " + in_quotes(text) + " is not a whole number from 0 on");
}

StatedSize stated_size(std::string_view lo, std::string_view hi) {
  StatedSize size{parse_long_decimal(lo), parse_long_decimal(hi)};
  if (size.lo > size.hi)
    throw InputError("size " + in_quotes(lo) + " to " + in_quotes(hi) + " is upside down");
  return size;
}

/// `-` stands for the size of no particles.
std::optional<StatedSize> csv_size(std::string_view word) {
  return word == "-" ? std::nullopt : std::optional(stated_size(word, word));
}

const std::string &text_of(const Json &value, const char *what) {
  if (!value.is_string())
    throw InputError(std::string(what) + " is " +
                     in_quotes(value.dump(-1, ' ', true, Json::error_handler_t::replace)) +
                     ": write a number");
  return value.get_ref<const std::string &>();
}

std::optional<StatedSize> json_size(const Json &value) {
  if (value.is_null())
    return std::nullopt;
  if (value.is_array() && value.size() == 2)
    return stated_size(text_of(value[0], "size"), text_of(value[1], "size"));
  const std::string &text = text_of(value, "size");
  return stated_size(text, text);
}

const Json &array_of(const Json &object, const char *key) {
  if (!object.at(key).is_array())
    throw InputError(fmt::format("{} is no array", key));
  return object.at(key);
}

/// The text of a key, or nothing.
std::string text_or_empty(const Json &object, const char *key) {
  return object.contains(key) && object.at(key).is_string() ? object.at(key).get<std::string>() : "";
}

/// What an answer says of its number of particles is held against its quantities.
void compare_number(const Integer &stated, OtherAnswer &answer) {
  const Integer all = std::accumulate(answer.quantities.begin(), answer.quantities.end(), Integer(0));
  if (stated != all && !answer.quantities.empty())
    answer.contradiction =
        fmt::format("the answer says that it has {} particles, and its quantities are {} together",
                    to_string(stated), to_string(all));
}

void take_classes(const Json &object, OtherAnswer &answer) {
  StatedParticles stated = AnswerReader(object).particles();
  for (StatedParticles::Class &c : stated.classes) {
    answer.quantities.push_back(std::move(c.quantity));
    answer.sizes.push_back(c.size ? std::optional(StatedSize{c.size->first, c.size->second}) : std::nullopt);
    answer.classes.push_back(c.bounds);
  }
  answer.unit_mm = in_mm(stated.unit);
  if (stated.particles)
    compare_number(*stated.particles, answer);
}

/// \throws InputError for a status without particles, beside which there are quantities
void check_status(const Json &object) {
  const std::string status = text_or_empty(object, "status");
  const std::optional<AnswerVerdict> named = answer_verdict_named(status);
  if (status == "none" || named == AnswerVerdict::infeasible || named == AnswerVerdict::no_answer)
    throw InputError(
        fmt::format("the answer has the status {} and quantities: leave one of them out", in_quotes(status)));
}

/// The particles of the simple form.
void take_particles(const Json &object, OtherAnswer &answer) {
  if (has_member(object, "quantities")) {
    for (const Json &q : array_of(object, "quantities"))
      answer.quantities.push_back(quantity(text_of(q, "quantity")));
    if (has_member(object, "sizes"))
      for (const Json &x : array_of(object, "sizes"))
        answer.sizes.push_back(json_size(x));
    const std::string stated = text_or_empty(object, "particles");
    if (!stated.empty() && !answer.quantities.empty())
      compare_number(quantity(stated), answer);
  }
  if (!has_member(object, "unit"))
    return;
  const std::string &unit = text_of(object.at("unit"), "unit");
  const std::optional<SizeUnit> known = parse_size_unit(unit);
  if (!known)
    throw InputError("unit " + in_quotes(unit) + " is unknown: use \"mm\", \"um\", \"m\" or \"in\"");
  answer.unit_mm = in_mm(*known);
}

/// Why an object has no quantities.
void take_failure(const Json &object, OtherAnswer &answer) {
  const std::string status = text_or_empty(object, "status");
  const std::string error = text_or_empty(object, "error");
  const std::optional<AnswerVerdict> named = answer_verdict_named(status);
  answer.reason = text_or_empty(object, "reason");
  if (named == AnswerVerdict::crashed || named == AnswerVerdict::timeout || named == AnswerVerdict::garbage ||
      named == AnswerVerdict::infeasible || named == AnswerVerdict::gave_up) {
    answer.failure = named;
    return;
  }
  if (status == "gave up") {
    answer.failure = AnswerVerdict::gave_up;
    return;
  }
  const bool says_so = object.contains("status") || object.contains("error") ||
                       object.contains("quantities") || object.contains("classes");
  answer.failure = says_so ? AnswerVerdict::no_answer : AnswerVerdict::garbage;
  if (!error.empty())
    answer.reason = error;
  else if (!says_so)
    answer.reason = "there is neither \"quantities\" nor \"classes\"";
  else if (answer.reason.empty())
    answer.reason = status.empty() ? "there are no quantities" : "status " + status;
}

void take_labels(const Json &object, OtherAnswer &answer) {
  static constexpr std::array<std::string_view, 8> own = {"id",      "quantities", "sizes",  "unit",
                                                          "classes", "status",     "reason", "error"};
  for (const auto &[key, value] : object.items())
    if (value.is_string() && std::find(own.begin(), own.end(), key) == own.end())
      answer.labels[key] = value.get<std::string>();
}

constexpr std::string_view sizes_prefix = "sizes_";

/// Calls use(word) for each word of a text, separated by spaces and tabs.
template <class Use>
void for_each_word(std::string_view text, Use use) {
  for (std::string_view rest = trimmed(text); !rest.empty(); rest = trimmed(rest)) {
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
    use(word);
    rest.remove_prefix(word.size());
  }
}

/// `answer` without particles; its id and labels stay.
OtherAnswer failed_with(OtherAnswer answer, AnswerVerdict failure, std::string reason) {
  OtherAnswer failed = failed_answer(std::move(answer.id), failure, std::move(reason));
  failed.has_id = answer.has_id;
  failed.labels = std::move(answer.labels);
  return failed;
}

/// A CSV file of answers after its header.
class Table {
public:
  Table(std::vector<std::string> header, const Source &source, std::size_t line)
      : header_(std::move(header)) {
    id_ = column("id", source, line);
    quantities_ = column("quantities", source, line);
    for (std::size_t i = 0; i < header_.size(); ++i) {
      if (header_[i].empty() || std::count(header_.begin(), header_.end(), header_[i]) > 1)
        source.refuse(line, "column " + in_quotes(header_[i]) + " is " +
                                (header_[i].empty() ? "without a name" : "there twice") +
                                ": give every column a name of its own");
      if (!header_[i].starts_with(sizes_prefix))
        continue;
      const std::optional<SizeUnit> unit =
          parse_size_unit(std::string_view(header_[i]).substr(sizes_prefix.size()));
      if (!unit || sizes_)
        source.refuse(line, "column " + in_quotes(header_[i]) +
                                (unit ? " is a second one with sizes: give one"
                                      : " has an unknown unit: use sizes_mm, sizes_um, sizes_m or sizes_in"));
      sizes_ = i;
      unit_mm_ = in_mm(*unit);
    }
  }

  /// \throws InputError if it cannot be read; what of the answer's id and labels is known is there then
  void read(std::string_view line, OtherAnswer &answer) const {
    std::vector<std::string> fields;
    if (!split_fields(line, ',', fields))
      throw InputError("a quoted field does not end with a quote before the next comma");
    if (fields.size() > id_) {
      answer.id = fields[id_];
      answer.has_id = !answer.id.empty();
    }
    if (fields.size() != header_.size())
      throw InputError(
          fmt::format("the row has {} fields, the header has {}", fields.size(), header_.size()));
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (i != id_ && i != quantities_ && i != sizes_)
        answer.labels[header_[i]] = fields[i];
    for_each_word(fields[quantities_],
                  [&answer](std::string_view word) { answer.quantities.push_back(quantity(word)); });
    answer.unit_mm = unit_mm_;
    if (sizes_)
      for_each_word(fields[*sizes_],
                    [&answer](std::string_view word) { answer.sizes.push_back(csv_size(word)); });
    if (answer.quantities.empty())
      answer = failed_with(std::move(answer), AnswerVerdict::no_answer, "there are no quantities");
  }

private:
  std::size_t column(std::string_view name, const Source &source, std::size_t line) const {
    const auto found = std::find(header_.begin(), header_.end(), name);
    if (found == header_.end())
      source.refuse(line, fmt::format("the header has no column {}: begin with a line such as "
                                      "'id,quantities' or 'id,sizes_mm,quantities'",
                                      name));
    return static_cast<std::size_t>(found - header_.begin());
  }

  std::vector<std::string> header_;
  std::size_t id_ = 0, quantities_ = 0;
  std::optional<std::size_t> sizes_;
  Rational unit_mm_ = 1;
};

} // namespace

OtherAnswer failed_answer(std::string id, AnswerVerdict failure, std::string reason) {
  OtherAnswer answer;
  answer.id = std::move(id);
  answer.has_id = !answer.id.empty();
  answer.failure = failure;
  answer.reason = std::move(reason);
  return answer;
}

OtherAnswer json_answer(std::string_view text) {
  OtherAnswer answer;
  try {
    const Json object = json_tree(text);
    if (!object.is_object())
      throw InputError("the answer is no JSON object");
    answer.id = text_or_empty(object, "id");
    answer.has_id = object.contains("id") && object.at("id").is_string();
    take_labels(object, answer);
    if (has_member(object, "classes"))
      take_classes(object, answer);
    else
      take_particles(object, answer);
    if (answer.quantities.empty())
      take_failure(object, answer);
    else
      check_status(object);
    return answer;
  } catch (const InputError &e) {
    if (const std::optional<std::string> id = answer.has_id ? std::nullopt : json_gradation_id(text)) {
      answer.id = *id;
      answer.has_id = true;
    }
    return failed_with(std::move(answer), AnswerVerdict::garbage, e.what());
  }
}

std::string answer_line(const OtherAnswer &answer,
                        const std::vector<std::pair<std::string, std::string>> &more) {
  JsonWriter json;
  json.begin_object();
  for (const auto &[key, value] : more)
    json.key(key).string(value);
  json.key("id").string(answer.id);
  if (answer.failure) {
    json.key("status").plain(name(*answer.failure)).key("reason").string(answer.reason).end_object();
    return json.take();
  }
  json.key("quantities").begin_array();
  for (const Integer &q : answer.quantities)
    json.plain(to_string(q));
  json.end_array().key("sizes").begin_array();
  for (const std::optional<StatedSize> &x : answer.sizes) {
    if (x)
      json.bounds(to_decimal(Rational(x->lo * answer.unit_mm)), to_decimal(Rational(x->hi * answer.unit_mm)));
    else
      json.null();
  }
  json.end_array().key("unit").plain("mm").end_object();
  return json.take();
}

std::vector<OtherAnswer> read_answers(std::string_view content, const std::string &file) {
  const Source source(file);
  content = without_byte_order_mark(content);
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  const bool json = first != std::string_view::npos && content[first] == '{';
  if (is_batch_header(trimmed(content.substr(0, content.find('\n')))))
    return read_batch_rows(content, file);
  std::vector<OtherAnswer> answers;
  std::optional<Table> table;
  Lines lines(content);
  while (lines.next()) {
    const std::string_view line = trimmed(lines.text());
    if (line.find('\r') != std::string_view::npos)
      source.refuse(lines.number(),
                    "a carriage return (CR) is there that no line feed (LF) follows: end lines "
                    "with LF or CR LF");
    const bool is_sieve = line.size() > 1 && line[0] == '#' && is_digit(line[1]);
    if (line.empty() || (!json && line.front() == '#' && !is_sieve))
      continue;
    if (json) {
      answers.push_back(json_answer(line));
    } else if (!table) {
      std::vector<std::string> header;
      if (!split_fields(line, ',', header))
        source.refuse(lines.number(),
                      "a quoted field of the header does not end with a quote before the next comma");
      table.emplace(std::move(header), source, lines.number());
      continue;
    } else {
      OtherAnswer &answer = answers.emplace_back();
      try {
        if (is_sieve)
          throw InputError(
              "a line that begins with # and a digit may be a comment or an id: write '# ' before "
              "a comment, and quotes around an id");
        table->read(line, answer);
      } catch (const InputError &e) {
        answer = failed_with(std::move(answer), AnswerVerdict::garbage, e.what());
      }
    }
    OtherAnswer &answer = answers.back();
    if (answer.failure == AnswerVerdict::garbage)
      answer.reason = fmt::format("{}:{}: {}", printable(file), lines.number(), answer.reason);
  }
  if (!json && !table)
    source.refuse(
        std::max(lines.number(), std::size_t{1}),
        "there is no header: begin with a line such as 'id,quantities' or 'id,sizes_mm,quantities'");
  return answers;
}

} // namespace mdm
