#include "text/json_member.hpp"

#include <nlohmann/json.hpp>

namespace mdm {
namespace {

/// Stops at a member of the outermost object. The names of the functions are nlohmann's.
class MemberFinder : public nlohmann::json_sax<nlohmann::json> {
public:
  explicit MemberFinder(std::string_view key) : key_(key) {}

  std::optional<std::string> found;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  /// A 0 with a sign is -0.
  bool number_integer(number_integer_t n) override { return value(n == 0 ? "-0" : std::to_string(n)); }
  bool number_unsigned(number_unsigned_t n) override { return value(std::to_string(n)); }
  bool number_float(number_float_t, const string_t &text) override { return value(text); }
  bool string(string_t &text) override { return value(text); }
  bool binary(binary_t &) override { return true; }
  bool start_object(std::size_t) override { return enter(); }
  bool start_array(std::size_t) override { return enter(); }
  bool end_object() override { return leave(); }
  bool end_array() override { return leave(); }
  bool key(string_t &name) override {
    at_key_ = depth_ == 1 && name == key_;
    return true;
  }
  bool parse_error(std::size_t, const std::string &, const nlohmann::json::exception &) override {
    return false;
  }

private:
  bool value(const std::string &text) {
    if (at_key_ && depth_ == 1)
      found = text;
    return !found;
  }
  bool enter() {
    ++depth_;
    return true;
  }
  bool leave() {
    --depth_;
    return true;
  }

  std::string_view key_;
  std::size_t depth_ = 0;
  bool at_key_ = false;
};

} // namespace

std::optional<std::string> json_member(std::string_view content, std::string_view key) {
  MemberFinder finder(key);
  nlohmann::json::sax_parse(content, &finder);
  return finder.found;
}

} // namespace mdm
