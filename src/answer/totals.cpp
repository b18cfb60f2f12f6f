#include "answer/totals.hpp"

#include "text/json_tree.hpp"
#include "text/json_writer.hpp"

#include <charconv>

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

[[noreturn]] void refuse_totals(const std::string &what) {
  throw InputError(what + ": give what mdm batch --shard wrote, or solve the shard again");
}

const TotalsJson &totals_member(const TotalsJson &object, const std::string &key) {
  if (!object.is_object() || !object.contains(key))
    refuse_totals(key + " is missing");
  return object[key];
}

std::string totals_text(const TotalsJson &object, const std::string &key) {
  const TotalsJson &value = totals_member(object, key);
  if (!value.is_string())
    refuse_totals(key + " is no string");
  return value.get<std::string>();
}

std::uint64_t totals_number(const TotalsJson &object, const std::string &key) {
  const std::string text = totals_text(object, key);
  std::uint64_t n = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc{} || end != text.data() + text.size())
    refuse_totals(key + ": " + in_quotes(text) + " is no number");
  return n;
}

FileTotals file_totals(const TotalsJson &object) {
  return {totals_number(object, "bytes"), totals_text(object, "sha256")};
}

NamedFileTotals named_file(const TotalsJson &object) {
  return {file_totals(object), totals_text(object, "file")};
}

Totals totals_of(const TotalsJson &json) {
  if (totals_text(json, "schema") != totals_schema)
    refuse_totals("schema: " + in_quotes(totals_text(json, "schema")) + " is not " +
                  std::string(totals_schema));
  Totals t;
  const TotalsJson &shard = totals_member(json, "shard");
  t.shard = totals_number(shard, "number");
  t.shards = totals_number(shard, "of");
  if (t.shard < 1 || t.shard > t.shards)
    refuse_totals("shard: its number is not from 1 to their number");
  t.question = totals_text(json, "question");
  if (json.contains("suite"))
    t.suite = file_totals(json["suite"]);
  t.lines = totals_number(json, "lines");
  t.errors = totals_number(json, "errors");
  const std::uint64_t exit = totals_number(json, "exit");
  if (exit > 3)
    refuse_totals("exit: it is not from 0 to 3");
  t.exit = static_cast<int>(exit);
  t.answers = named_file(totals_member(json, "answers"));
  if (json.contains("proofs") || json.contains("index")) {
    t.proofs = named_file(totals_member(json, "proofs"));
    t.index = named_file(totals_member(json, "index"));
  }
  const TotalsJson &versions = totals_member(json, "versions");
  for (const auto &[library, version] : versions.items())
    t.versions[library] = totals_text(versions, library);
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
    json.end_object();
  }
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
    throw InputError(printable(std::string(name)) + ": " + e.what());
  }
}

} // namespace mdm
