// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <libxml/tree.h>

#include <algorithm>
#include <memory>

#include "tb/report/html.h"
#include "tb/signoff/signoff_report.h"

namespace racebeam {

namespace {

const xmlChar* xml(const std::string& text) {
  return reinterpret_cast<const xmlChar*>(text.c_str());
}

void set(xmlNodePtr node, const char* name, const std::string& value) {
  xmlNewProp(node, xml(name), xml(value));
}

/// Bytes that XML cannot hold are replaced.
std::string plain(const std::string& text) {
  std::string all;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    all += byte >= 0x7f || (byte < 0x20 && c != '\n' && c != '\t') ? '?' : c;
  }
  return all;
}

std::string lines(const std::vector<std::string>& all) {
  std::string text;
  for (const std::string& one : all) text += one + "\n";
  return text;
}

void add_case(xmlNodePtr suite, const CheckResult& result, const std::string& name) {
  xmlNodePtr node = xmlNewChild(suite, nullptr, xml("testcase"), nullptr);
  set(node, "classname", "racebeam." + plain(result.check));
  set(node, "name", plain(name));
  set(node, "time", fmt::format("{:.3f}", result.seconds));
  if (result.verdict == CheckResult::Good) return;
  const std::string kind = result.verdict == CheckResult::Bad ? "failure" : "error";
  xmlNodePtr what = xmlNewTextChild(node, nullptr, xml(kind), xml(plain(lines(result.faults))));
  set(what, "message", plain(result.summary));
}

}  // namespace

std::string signoff_junit(const SignoffReport& report) {
  std::vector<std::string> checks;
  for (const CheckResult& result : report.results)
    if (std::find(checks.begin(), checks.end(), result.check) == checks.end())
      checks.push_back(result.check);
  const std::unique_ptr<xmlDoc, void (*)(xmlDocPtr)> document(xmlNewDoc(xml("1.0")), xmlFreeDoc);
  xmlNodePtr root = xmlNewDocNode(document.get(), nullptr, xml("testsuites"), nullptr);
  xmlDocSetRootElement(document.get(), root);
  set(root, "name", "racebeam signoff");
  for (const std::string& check : checks) {
    xmlNodePtr suite = xmlNewChild(root, nullptr, xml("testsuite"), nullptr);
    int tests = 0, failures = 0, errors = 0;
    double seconds = 0;
    for (const CheckResult& result : report.results) {
      if (result.check != check) continue;
      add_case(suite, result, report.name(result));
      ++tests;
      failures += result.verdict == CheckResult::Bad;
      errors += result.verdict == CheckResult::Undecided;
      seconds += result.seconds;
    }
    set(suite, "name", plain(check));
    set(suite, "tests", std::to_string(tests));
    set(suite, "failures", std::to_string(failures));
    set(suite, "errors", std::to_string(errors));
    set(suite, "time", fmt::format("{:.3f}", seconds));
  }
  xmlChar* text = nullptr;
  int size = 0;
  xmlDocDumpFormatMemoryEnc(document.get(), &text, &size, "UTF-8", 1);
  const std::string all(reinterpret_cast<const char*>(text), static_cast<std::size_t>(size));
  xmlFree(text);
  return all;
}

}  // namespace racebeam
