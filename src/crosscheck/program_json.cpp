#include "crosscheck/program_text.hpp"
#include "text/json_writer.hpp"
#include "text/versions.hpp"

#include <mdm/number/integer.hpp>

namespace mdm {
namespace {

void write_variable(JsonWriter &json, const ProgramVariable &v) {
  json.begin_object().key("name").plain(v.name).key("type").plain(v.is_integer ? "integer" : "real");
  json.key("least").plain(to_string(v.least)).end_object();
}

void write_program_row(JsonWriter &json, const ProgramRow &row, const IntegerProgram &program) {
  json.begin_object().key("name").plain(row.name).key("terms").begin_array();
  for (const auto &[v, coefficient] : row.terms)
    json.begin_array().plain(program.variables[v].name).plain(to_string(coefficient)).end_array();
  json.end_array()
      .key("sense")
      .plain(row.is_strict ? ">" : ">=")
      .key("constant")
      .plain(to_string(row.constant));
  json.key("where");
  if (row.where)
    json.plain(program.variables[*row.where].name);
  else
    json.null();
  json.end_object();
}

} // namespace

std::string program_json(const IntegerProgram &program) {
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-problem-1").key("id").string(program.id);
  json.key("minimise").begin_array();
  for (std::size_t j = 0; j < program.counts; ++j)
    json.plain(program.variables[j].name);
  json.end_array().key("variables").begin_array();
  for (const ProgramVariable &v : program.variables)
    write_variable(json, v);
  json.end_array().key("rows").begin_array();
  for (const ProgramRow &row : program.rows)
    write_program_row(json, row, program);
  json.end_array().key("comments").strings(program.comments);
  return json.key("versions").raw(versions_json()).end_object().take();
}

} // namespace mdm
