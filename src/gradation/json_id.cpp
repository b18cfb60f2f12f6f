#include <mdm/gradation/read_gradation.hpp>

#include <nlohmann/json.hpp>

namespace mdm {
namespace {

/// Stops at the id of the outermost object.
class IdFinder : public nlohmann::json_sax<nlohmann::json> {
public:
  std::optional<std::string> id;

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
    at_id_ = depth_ == 1 && name == "id";
    return true;
  }
  bool parse_error(std::size_t, const std::string &, const nlohmann::json::exception &) override {
    return false;
  }

private:
  bool value(const std::string &text) {
    if (at_id_ && depth_ == 1)
      id = text;
    return !id;
  }
  bool enter() {
    ++depth_;
    return true;
  }
  bool leave() {
    --depth_;
    return true;
  }

  std::size_t depth_ = 0;
  bool at_id_ = false;
};

} // namespace

std::optional<std::string> json_gradation_id(std::string_view content) {
  IdFinder finder;
  nlohmann::json::sax_parse(content, &finder);
  return finder.id;
}

} // namespace mdm
