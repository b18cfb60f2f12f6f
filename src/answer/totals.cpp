#include "answer/totals.hpp"

#include "answer/string_members.hpp"
#include "text/json_writer.hpp"

namespace mdm {
namespace {

using TotalsJson = nlohmann::json;

void write_file_totals(JsonWriter &json, const FileTotals &file) {
  json.key("bytes").number(file.bytes).key("sha256").plain(file.sha256);
}

void write_named_file(JsonWriter &json, const NamedFileTotals &file) {
  json.begin_object().key("file").string(file.name);
  write_file_totals(json, file);
  json.end_object();
}

FileTotals file_totals(const TotalsJson &object) {
  return {number_member(object, "bytes"), text_member(object, "sha256")};
}

LineSum line_sum(const TotalsJson &object) {
  const std::string text = text_member(object, "sum");
  const std::optional<LineSum> sum = LineSum::parse(text);
  if (!sum)
    throw InputError("sum: " + in_quotes(text) + " is no sum of SHA-256");
  return *sum;
}

NamedFileTotals named_file(const TotalsJson &object) {
  return {file_totals(object), text_member(object, "file")};
}

Totals totals_of(const TotalsJson &json) {
  if (text_member(json, "schema") != totals_schema)
    throw InputError("schema: " + in_quotes(text_member(json, "schema")) + " is not " +
                     std::string(totals_schema));
  Totals t;
  const TotalsJson &shard = member_of(json, "shard");
  t.shard = number_member(shard, "number");
  t.shards = number_member(shard, "of");
  if (t.shard < 1 || t.shard > t.shards)
    throw InputError("shard: its number is not from 1 to their number");
  t.question = text_member(json, "question");
  if (json.contains("suite"))
    t.suite = SuiteTotals{file_totals(json["suite"]), line_sum(json["suite"])};
  if (json.contains("made"))
    t.made = made_suite_of(json["made"]);
  if (json.contains("alone"))
    t.alone = file_totals(json["alone"]);
  t.sum = line_sum(json);
  t.lines = number_member(json, "lines");
  t.errors = number_member(json, "errors");
  const std::uint64_t exit = number_member(json, "exit");
  if (exit > 3)
    throw InputError("exit: it is not from 0 to 3");
  t.exit = static_cast<int>(exit);
  t.answers = named_file(member_of(json, "answers"));
  if (json.contains("proofs") || json.contains("index")) {
    t.proofs = named_file(member_of(json, "proofs"));
    t.index = named_file(member_of(json, "index"));
  }
  const TotalsJson &versions = member_of(json, "versions");
  for (const auto &[library, version] : versions.items())
    t.versions[library] = text_member(versions, library);
  return t;
}

} // namespace

std::string totals_json(const Totals &t) {
  JsonWriter json;
  json.begin_object().key("schema").plain(totals_schema);
  json.key("shard").begin_object().key("number").number(t.shard).key("of").number(t.shards).end_object();
  json.key("question").string(t.question);
  if (t.suite) {
    json.key("suite").begin_object();
    write_file_totals(json, *t.suite);
    json.key("sum").plain(t.suite->sum.text()).end_object();
  }
  if (t.made)
    write_made_suite(json.key("made"), *t.made);
  if (t.alone) {
    json.key("alone").begin_object();
    write_file_totals(json, *t.alone);
    json.end_object();
  }
  json.key("sum").plain(t.sum.text());
  json.key("lines").number(t.lines).key("errors").number(t.errors);
  json.key("exit").number(static_cast<std::uint64_t>(t.exit));
  write_named_file(json.key("answers"), t.answers);
  if (t.proofs && t.index) {
    write_named_file(json.key("proofs"), *t.proofs);
    write_named_file(json.key("index"), *t.index);
  }
  json.key("versions").begin_object();
  for (const auto &[library, version] : t.versions)
    json.key(library).string(version);
  json.end_object().end_object();
  return json.take();
}

Totals read_totals(std::string_view text, std::string_view name) {
  try {
    return totals_of(json_tree(text));
  } catch (const InputError &e) {
    throw InputError(printable(std::string(name)) + ": " + e.what() +
                     ": give what mdm batch --shard wrote, or solve the shard again");
  }
}

} // namespace mdm
