#include "text/json_tree.hpp"

#include "text/json_cursor.hpp"
#include "text/source.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

using Json = nlohmann::json;

/// Takes the parser's events. The names of the functions are nlohmann's.
class Builder : public nlohmann::json_sax<Json> {
public:
  explicit Builder(std::string_view text) : text_(text) {}

  Json root;

  const char **reached() { return &reached_; }

  bool null() override { return put(nullptr); }
  bool boolean(bool value) override { return put(value); }
  /// A 0 with a sign is -0.
  bool number_integer(number_integer_t value) override {
    return put(value == 0 ? "-0" : std::to_string(value));
  }
  bool number_unsigned(number_unsigned_t value) override { return put(std::to_string(value)); }
  bool number_float(number_float_t, const string_t &text) override {
    // nlohmann puts the locale's decimal point where the text has `.`.
    std::string number = text;
    const std::size_t point = number.find_first_not_of("+-0123456789eE");
    if (point != std::string::npos)
      number[point] = '.';
    return put(std::move(number));
  }
  bool string(string_t &text) override { return put(std::move(text)); }
  bool binary(binary_t &) override { return false; }
  bool start_object(std::size_t) override { return open(Json::object()); }
  bool start_array(std::size_t) override { return open(Json::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t &name) override {
    Json &object = *open_.back();
    if (object.contains(name))
      refuse("key " + in_quotes(name) + " is there twice: leave one");
    slot_ = &object[name];
    return true;
  }
  bool parse_error(std::size_t position, const std::string &token,
                   const nlohmann::json::exception &error) override {
    constexpr int number_overflow = 406; // nlohmann's number of that exception
    if (error.id == number_overflow)
      refuse(in_quotes(token) + " is too large for a JSON number: write it as a string");
    refuse(fmt::format("this is not JSON at byte {}, {}: check quotes, commas and brackets", position,
                       in_quotes(token)));
  }

private:
  [[noreturn]] void refuse(const std::string &what) const {
    throw JsonError(line_number(text_, static_cast<std::size_t>(reached_ - text_.data())), what);
  }
  Json *place(Json value) {
    if (open_.empty()) {
      root = std::move(value);
      return &root;
    }
    if (open_.back()->is_array()) {
      open_.back()->push_back(std::move(value));
      return &open_.back()->back();
    }
    *slot_ = std::move(value);
    return slot_;
  }
  bool put(Json value) {
    place(std::move(value));
    return true;
  }
  bool open(Json value) {
    constexpr std::size_t max_depth = 64;
    if (open_.size() == max_depth)
      refuse(fmt::format("values are nested deeper than {}: is it the right file?", max_depth));
    open_.push_back(place(std::move(value)));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  const char *reached_ = text_.data();
  std::vector<Json *> open_; ///< arrays and objects around the place that is read
  Json *slot_ = nullptr;     ///< of the last key
};

} // namespace

nlohmann::json json_tree(std::string_view text) {
  Builder builder(text);
  Json::sax_parse(JsonCursor(text.data(), builder.reached()),
                  JsonCursor(text.data() + text.size(), builder.reached()), &builder);
  return std::move(builder.root);
}

} // namespace mdm
