#include "answer/made_suite.hpp"

#include "answer/string_members.hpp"

namespace mdm {

void write_made_suite(JsonWriter &json, const MadeSuite &suite) {
  json.begin_object().key("description").plain(suite.description).key("seed").number(suite.seed);
  json.key("from").number(suite.from).key("to").number(suite.to).end_object();
}

MadeSuite made_suite_of(const nlohmann::json &json) {
  return {text_member(json, "description"), number_member(json, "seed"), number_member(json, "from"),
          number_member(json, "to")};
}

std::string made_shard_json(const MadeShard &shard) {
  JsonWriter json;
  json.begin_object().key("schema").plain(made_shard_schema);
  write_made_suite(json.key("suite"), shard.suite);
  json.key("shard").begin_object().key("number").number(shard.shard).key("of").number(shard.shards);
  json.end_object().key("lines").number(shard.lines).end_object();
  return json.take();
}

bool begins_made_shard(std::string_view line) {
  return line.starts_with(R"({"schema":"mdm-shard-)");
}

MadeShard read_made_shard(std::string_view line) {
  const nlohmann::json json = json_tree(line);
  if (text_member(json, "schema") != made_shard_schema)
    throw InputError("schema: " + in_quotes(text_member(json, "schema")) + " is not " +
                     std::string(made_shard_schema));
  const nlohmann::json &shard = member_of(json, "shard");
  return {made_suite_of(member_of(json, "suite")), number_member(shard, "number"), number_member(shard, "of"),
          number_member(json, "lines")};
}

} // namespace mdm
