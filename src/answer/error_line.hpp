#pragma once
/// \file
/// What stands in the place of an answer where a line of a file cannot be read.

#include "text/json_writer.hpp"

namespace mdm {

/// {"id": ..., "status": "error", "error": ...} with a newline.
inline std::string error_line(const std::string &id, const std::string &message) {
  JsonWriter json;
  json.begin_object()
      .key("id")
      .string(id)
      .key("status")
      .plain("error")
      .key("error")
      .string(message)
      .end_object();
  return json.take() + "\n";
}

} // namespace mdm
