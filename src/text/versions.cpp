#include "text/versions.hpp"

#include "text/json_writer.hpp"

#include <boost/version.hpp>
#include <fmt/core.h>
#include <gmp.h>
#include <mpfr.h>
#include <nlohmann/json.hpp>
#ifdef MDM_HAS_ARB
#if __has_include(<flint/arb.h>)
#include <flint/arb.h>
#else
#include <arb.h>
#endif
#endif
#ifdef MDM_READS_XML
#include <pugixml.hpp>
#endif
#ifdef MDM_READS_WORKBOOKS
#include <zip.h>
#endif

namespace mdm {
namespace {

std::string boost_version() {
  return fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100);
}

std::string json_version() {
  return fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                     NLOHMANN_JSON_VERSION_PATCH);
}

std::string fmt_version() {
  return fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100);
}

#ifdef MDM_READS_XML
std::string pugixml_version() {
  return fmt::format("{}.{}.{}", PUGIXML_VERSION / 1000, PUGIXML_VERSION / 10 % 100, PUGIXML_VERSION % 10);
}
#endif

} // namespace

const std::vector<std::pair<std::string, std::string>> &versions() {
  static const std::vector<std::pair<std::string, std::string>> list = {
    {"mdm", MDM_VERSION},
    {"gmp", gmp_version},
    {"mpfr", mpfr_get_version()},
#ifdef MDM_HAS_ARB
    {"flint", FLINT_VERSION},
#if __FLINT_RELEASE < 30000
    {"arb", arb_version},
#endif
#endif
    {"boost", boost_version()},
    {"fmt", fmt_version()},
    {"nlohmann-json", json_version()},
#ifdef MDM_READS_XML
    {"pugixml", pugixml_version()},
#endif
#ifdef MDM_READS_WORKBOOKS
    {"libzip", LIBZIP_VERSION},
#endif
  };
  return list;
}

const std::string &versions_json() {
  static const std::string object = [] {
    JsonWriter json;
    json.begin_object();
    for (const auto &[library, version] : versions())
      json.key(library).string(version);
    json.end_object();
    return json.take();
  }();
  return object;
}

} // namespace mdm
