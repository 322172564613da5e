#include "checkpoint_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "rgimp/error.hpp"

namespace rgimp {

static_assert(std::endian::native == std::endian::little);

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kMagic = "RGIMPcheckpoint\n";
constexpr std::size_t kWord = sizeof(std::uint64_t);
constexpr std::size_t kHead = kMagic.size() + 2 * kWord;
constexpr std::size_t kTail = 2 * kWord;

std::string word(std::uint64_t value) {
  std::string bytes(kWord, '\0');
  std::memcpy(bytes.data(), &value, kWord);
  return bytes;
}

std::uint64_t word_at(std::string_view bytes, std::size_t place) {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes.data() + place, kWord);
  return value;
}

std::size_t size_of(std::string_view type) {
  return type == "uint8" ? 1 : type == "int32" || type == "uint32" ? 4 : 8;
}

}  // namespace

struct CheckpointWriter::Index {
  Json columns = Json::array();
};

CheckpointWriter::CheckpointWriter(const std::filesystem::path& target, std::int64_t step)
    : file_(target), stream_(file_.temporary()), index_(std::make_unique<Index>()) {
  write(kMagic);
  write(word(kCheckpointVersion));
  write(word(static_cast<std::uint64_t>(step)));
}

CheckpointWriter::~CheckpointWriter() = default;

void CheckpointWriter::write(std::string_view bytes) {
  stream_.write(bytes);
  checksum_.add(bytes);
}

void CheckpointWriter::add(std::string_view name, std::string_view type, std::size_t length,
                           std::string_view bytes) {
  write(bytes);
  index_->columns.push_back({{"name", name}, {"type", type}, {"length", length}});
}

void CheckpointWriter::finish(const CheckpointLabel& label) {
  const Json index{{"case", label.case_text},
                   {"note", label.note},
                   {"own functions", label.own_functions},
                   {"columns", index_->columns}};
  const std::string text = index.dump();
  write(text);
  write(word(text.size()));
  stream_.write(word(checksum_.value()));
  stream_.close();
  file_.commit();
}

CheckpointReader::CheckpointReader(std::string name, std::string bytes)
    : name_(std::move(name)), bytes_(std::move(bytes)) {
  const std::string_view body = checked_body();
  const std::uint64_t step = word_at(bytes_, kMagic.size() + kWord);
  if (step > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max())) {
    refuse(fmt::format("step {} is none", step));
  }
  step_ = static_cast<std::int64_t>(step);
  try {
    read_index(body);
  } catch (const nlohmann::json::exception& error) {
    refuse(fmt::format("its index is wrong: {}", error.what()));
  }
}

void CheckpointReader::refuse(const std::string& reason) const {
  throw FileError(fmt::format("checkpoint '{}': {}", name_, reason));
}

/// Columns and index, after everything else is found right.
std::string_view CheckpointReader::checked_body() const {
  const std::string_view all = bytes_;
  if (all.size() < kHead + kTail || !all.starts_with(kMagic)) {
    refuse("not a checkpoint, or cut short");
  }
  const std::uint64_t version = word_at(all, kMagic.size());
  if (version != kCheckpointVersion) {
    refuse(fmt::format("its format is version {}; this program reads version {}", version,
                       kCheckpointVersion));
  }
  if (checksum_of(all.substr(0, all.size() - kWord)) != word_at(all, all.size() - kWord)) {
    refuse("damaged: its checksum is wrong");
  }
  return all.substr(kHead, all.size() - kHead - kTail);
}

void CheckpointReader::read_index(std::string_view body) {
  const std::uint64_t length = word_at(bytes_, bytes_.size() - kTail);
  if (length > body.size()) {
    refuse("its index is longer than the file");
  }
  std::string_view left = body.substr(0, body.size() - length);
  const Json index = Json::parse(body.substr(left.size()));
  label_.case_text = index.at("case").get<std::string>();
  label_.note = index.at("note").get<std::string>();
  label_.own_functions = index.value("own functions", label_.own_functions);
  for (const Json& entry : index.at("columns")) {
    const auto name = entry.at("name").get<std::string>();
    const auto type = entry.at("type").get<std::string>();
    const Json& length_of_column = entry.at("length");
    if (!length_of_column.is_number_unsigned()) {
      refuse(fmt::format("the length of column '{}' is none", name));
    }
    const auto count = length_of_column.get<std::uint64_t>();
    if (count > left.size() / size_of(type)) {
      refuse(fmt::format("column '{}' is longer than the file", name));
    }
    const std::size_t bytes = count * size_of(type);
    if (!columns_.emplace(name, Column{type, left.substr(0, bytes)}).second) {
      refuse(fmt::format("column '{}' is there twice", name));
    }
    left.remove_prefix(bytes);
  }
  if (!left.empty()) {
    refuse(fmt::format("{} bytes belong to no column", left.size()));
  }
}

std::string_view CheckpointReader::find(std::string_view name, std::string_view type,
                                        std::size_t size) const {
  const auto column = columns_.find(name);
  if (column == columns_.end()) {
    refuse(fmt::format("has no column '{}'", name));
  }
  if (column->second.type != type || column->second.bytes.size() % size != 0) {
    refuse(fmt::format("column '{}' holds {}; expected {}", name, column->second.type, type));
  }
  return column->second.bytes;
}

void CheckpointReader::copy(std::string_view bytes, void* target) {
  if (!bytes.empty()) {
    std::memcpy(target, bytes.data(), bytes.size());
  }
}

std::optional<std::int64_t> claimed_step(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) {
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  std::string head(kHead, '\0');
  if (!file.read(head.data(), static_cast<std::streamsize>(head.size())) ||
      !head.starts_with(kMagic)) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(word_at(head, kMagic.size() + kWord));
}

}  // namespace rgimp
