#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>

#include "case_templates.hpp"
#include "format.hpp"
#include "rgimp/error.hpp"
#include "verbs.hpp"

namespace rgimp::cli {

namespace {

namespace fs = std::filesystem;

enum class ExistingFile { refuse, replace };

struct NewArguments {
  std::optional<std::string> name;
  std::optional<fs::path> file;  // none: named after the template
  ExistingFile existing = ExistingFile::refuse;
  bool is_for_list = false;
};

const CaseTemplate& find_template(const std::string& name) {
  const auto templates = case_templates();
  const auto found = std::find_if(templates.begin(), templates.end(),
                                  [&](const CaseTemplate& one) { return one.name == name; });
  if (found == templates.end()) {
    std::string names;
    for (const CaseTemplate& one : templates) {
      names += fmt::format("{}{}", names.empty() ? "" : ", ", one.name);
    }
    throw CaseError(fmt::format("no template \"{}\"; there are: {}", name, names));
  }
  return *found;
}

/// "single_flaw.toml", as the examples are named.
fs::path file_name(const CaseTemplate& one) {
  std::string name(one.name);
  std::replace(name.begin(), name.end(), '-', '_');
  return name + ".toml";
}

[[noreturn]] void fail(const fs::path& file, int system_error) {
  throw FileError(fmt::format("cannot write '{}': {}", file.string(),
                              std::generic_category().message(system_error)));
}

/// A new file with this text; none is left where it cannot be written.
void write_new_file(const fs::path& file, std::string_view text) {
  std::FILE* stream = std::fopen(file.c_str(), "wx");  // fails where there is one already
  if (stream == nullptr) {
    if (errno == EEXIST) {
      throw CaseError(fmt::format(
          "'{}' exists: choose another name (-o), or replace it with --force", file.string()));
    }
    fail(file, errno);
  }
  const bool is_written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  if (std::fclose(stream) != 0 || !is_written) {
    const int reason = errno;
    std::error_code ignored;
    fs::remove(file, ignored);
    fail(file, reason);
  }
}

/// The old file stays until the new one is whole.
void replace_file(const fs::path& file, std::string_view text) {
  fs::path temporary = file;
  temporary += ".tmp";
  std::error_code error;
  fs::remove(temporary, error);
  write_new_file(temporary, text);
  fs::rename(temporary, file, error);
  if (error) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    fail(file, error.value());
  }
}

void list_templates() {
  for (const CaseTemplate& one : case_templates()) {
    fmt::print("{:<19} {}\n", one.name, one.title);
  }
}

void write_template(const NewArguments& arguments) {
  const CaseTemplate& one = find_template(*arguments.name);
  const fs::path file = arguments.file.value_or(file_name(one));
  if (arguments.existing == ExistingFile::replace) {
    replace_file(file, one.text);
  } else {
    write_new_file(file, one.text);
  }
  const std::string name = printable(file.string());
  fmt::print("{}: {}\nNext: rgimp check {}\n", name, one.title, name);
}

}  // namespace

void add_new(CLI::App& app) {
  CLI::App* command = app.add_subcommand("new", "Write a commented case file to start from");
  const auto arguments = std::make_shared<NewArguments>();
  CLI::Option* name =
      command->add_option("TEMPLATE", arguments->name, "One of those of --list")->type_name("NAME");
  command
      ->add_option("-o,--output", arguments->file,
                   "The case file, by default in this directory and named after the template")
      ->type_name("FILE.toml");
  command->add_flag_callback(
      "--force", [arguments] { arguments->existing = ExistingFile::replace; },
      "Replace a file that exists");
  command
      ->add_flag_callback(
          "--list", [arguments] { arguments->is_for_list = true; },
          "List the templates, a line each")
      ->excludes(name);
  command->footer(
      "Examples:\n"
      "  rgimp new --list\n"
      "  rgimp new single-flaw\n"
      "  rgimp new brazilian-disk -o disk.toml");
  command->callback([arguments] {
    if (arguments->is_for_list) {
      list_templates();
    } else if (arguments->name) {
      write_template(*arguments);
    } else {
      throw CLI::RequiredError("TEMPLATE or --list");
    }
  });
}

}  // namespace rgimp::cli
