#include "checkpoint_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

CheckpointReader::CheckpointReader(std::string name, std::unique_ptr<std::istream> file)
    : name_(std::move(name)), file_(std::move(file)) {
  const std::size_t size = checked_size();
  const std::uint64_t step = word_at(kMagic.size() + kWord);
  if (step > static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max())) {
    refuse(fmt::format("step {} is none", step));
  }
  step_ = static_cast<std::int64_t>(step);
  try {
    read_index(size - kTail);
  } catch (const nlohmann::json::exception& error) {
    refuse(fmt::format("its index is wrong: {}", error.what()));
  }
}

void CheckpointReader::refuse(const std::string& reason) const {
  throw FileError(fmt::format("checkpoint '{}': {}", name_, reason));
}

void CheckpointReader::read(std::size_t place, std::span<char> bytes) const {
  file_->seekg(static_cast<std::streamoff>(place));
  if (!file_->read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
    refuse("cannot be read to its end");
  }
}

std::uint64_t CheckpointReader::word_at(std::size_t place) const {
  std::array<char, kWord> bytes{};
  read(place, bytes);
  return std::bit_cast<std::uint64_t>(bytes);
}

std::uint64_t CheckpointReader::checksum_before(std::size_t end) const {
  constexpr std::size_t kPiece = 1U << 20;
  Checksum checksum;
  std::string piece;
  for (std::size_t place = 0; place < end; place += piece.size()) {
    piece.resize(std::min(kPiece, end - place));
    read(place, piece);
    checksum.add(piece);
  }
  return checksum.value();
}

/// Bytes of the file, after everything but its index is found right.
std::size_t CheckpointReader::checked_size() const {
  file_->seekg(0, std::ios::end);
  const std::streamoff end = file_->tellg();
  const std::string reason = "not a checkpoint, or cut short";
  if (end < static_cast<std::streamoff>(kHead + kTail)) {
    refuse(reason);
  }
  std::string magic(kMagic.size(), '\0');
  read(0, magic);
  if (magic != kMagic) {
    refuse(reason);
  }
  const std::uint64_t version = word_at(kMagic.size());
  if (version != kCheckpointVersion) {
    refuse(fmt::format("its format is version {}; this program reads version {}", version,
                       kCheckpointVersion));
  }
  const auto size = static_cast<std::size_t>(end);
  if (checksum_before(size - kWord) != word_at(size - kWord)) {
    refuse("damaged: its checksum is wrong");
  }
  return size;
}

/// Of the file up to `end`: the index, and the columns before it.
void CheckpointReader::read_index(std::size_t end) {
  const std::uint64_t length = word_at(end);
  if (length > end - kHead) {
    refuse("its index is longer than the file");
  }
  std::string text(length, '\0');
  read(end - length, text);
  const Json index = Json::parse(text);
  label_.case_text = index.at("case").get<std::string>();
  label_.note = index.at("note").get<std::string>();
  label_.own_functions = index.value("own functions", label_.own_functions);
  std::size_t place = kHead;
  std::size_t left = end - length - kHead;
  for (const Json& entry : index.at("columns")) {
    const auto name = entry.at("name").get<std::string>();
    const auto type = entry.at("type").get<std::string>();
    const Json& length_of_column = entry.at("length");
    if (!length_of_column.is_number_unsigned()) {
      refuse(fmt::format("the length of column '{}' is none", name));
    }
    const auto count = length_of_column.get<std::uint64_t>();
    if (count > left / size_of(type)) {
      refuse(fmt::format("column '{}' is longer than the file", name));
    }
    if (!columns_.emplace(name, Column{type, place, count}).second) {
      refuse(fmt::format("column '{}' is there twice", name));
    }
    place += count * size_of(type);
    left -= count * size_of(type);
  }
  if (left != 0) {
    refuse(fmt::format("{} bytes belong to no column", left));
  }
}

const CheckpointReader::Column& CheckpointReader::find(std::string_view name,
                                                       std::string_view type) const {
  const auto column = columns_.find(name);
  if (column == columns_.end()) {
    refuse(fmt::format("has no column '{}'", name));
  }
  if (column->second.type != type) {
    refuse(fmt::format("column '{}' holds {}; expected {}", name, column->second.type, type));
  }
  return column->second;
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
  std::int64_t step = 0;
  std::memcpy(&step, head.data() + kMagic.size() + kWord, kWord);
  return step;
}

}  // namespace rgimp
