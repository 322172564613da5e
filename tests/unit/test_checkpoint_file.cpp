#include <catch2/catch.hpp>
#include <cstring>
#include <memory>
#include <sstream>
#include <utility>

#include "checkpoint_file.hpp"
#include "input_file.hpp"
#include "rgimp/error.hpp"
#include "temporary_directory.hpp"

namespace {

using namespace rgimp;

const std::vector<double> kReals{1.5, -0.0, 5e-324};
const std::vector<std::uint32_t> kIds{7, 8};

std::string small_checkpoint() {
  const TemporaryDirectory directory;
  CheckpointWriter writer(directory / "checkpoint", 42);
  writer("reals", kReals);
  writer("ids", kIds);
  writer("none", std::vector<std::uint8_t>());
  writer("count", std::int64_t{-3});
  writer.finish({"the case", "the note"});
  return read_bytes(directory / "checkpoint");
}

CheckpointReader reader_of(std::string bytes) {
  return {"file", std::make_unique<std::istringstream>(std::move(bytes))};
}

/// The same with another index, and a checksum that fits.
std::string with_index(const std::string& from, const std::string& to) {
  std::string bytes = small_checkpoint();
  const std::size_t place = bytes.find(from);
  REQUIRE(place != std::string::npos);
  bytes.replace(place, from.size(), to);
  const std::size_t words = bytes.size() - 16;
  std::uint64_t length = 0;
  std::memcpy(&length, bytes.data() + words, 8);
  length += to.size() - from.size();
  std::memcpy(bytes.data() + words, &length, 8);
  const std::uint64_t checksum = checksum_of(std::string_view(bytes).substr(0, words + 8));
  std::memcpy(bytes.data() + words + 8, &checksum, 8);
  return bytes;
}

std::string refusal(const std::string& bytes) {
  try {
    const CheckpointReader reader = reader_of(bytes);
    std::vector<std::uint32_t> ids;
    reader("ids", ids);
  } catch (const FileError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a checkpoint gives back every bit, its step and its texts") {
  const CheckpointReader reader = reader_of(small_checkpoint());
  CHECK(reader.step() == 42);
  CHECK(reader.label().case_text == "the case");
  CHECK(reader.label().note == "the note");
  std::vector<double> reals;
  reader("reals", reals);
  REQUIRE(reals.size() == kReals.size());
  CHECK(std::memcmp(reals.data(), kReals.data(), sizeof(double) * kReals.size()) == 0);
  std::vector<std::uint32_t> ids;
  reader("ids", ids);
  CHECK(ids == kIds);
  std::vector<std::uint8_t> none{1};
  reader("none", none);
  CHECK(none.empty());
  std::int64_t count = 0;
  reader("count", count);
  CHECK(count == -3);
}

TEST_CASE("a checkpoint cut anywhere is refused") {
  const std::string bytes = small_checkpoint();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    INFO("cut to " << size << " of " << bytes.size() << " bytes");
    REQUIRE(refusal(bytes.substr(0, size)).starts_with("checkpoint 'file': "));
  }
  CHECK(refusal(bytes + "x") == "checkpoint 'file': damaged: its checksum is wrong");
  CHECK(refusal(bytes) == "accepted");
}

TEST_CASE("a checkpoint with any one bit flipped is refused") {
  const std::string bytes = small_checkpoint();
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string flipped = bytes;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    INFO("bit " << bit);
    REQUIRE(refusal(flipped).starts_with("checkpoint 'file': "));
  }
}

TEST_CASE("a checkpoint whose index asks for more than there is, is refused") {
  const std::string start = "checkpoint 'file': ";
  CHECK(refusal(with_index("\"length\":3", "\"length\":4")) ==
        start + "column 'count' is longer than the file");
  CHECK(refusal(with_index("\"length\":3", "\"length\":99999999999999999999")) ==
        start + "the length of column 'reals' is none");
  CHECK(refusal(with_index("\"length\":3", "\"length\":-1")) ==
        start + "the length of column 'reals' is none");
  CHECK(refusal(with_index("\"length\":3", "\"length\":2305843009213693953")) ==
        start + "column 'reals' is longer than the file");
  CHECK(refusal(with_index("\"length\":3", "\"length\":2")) ==
        start + "8 bytes belong to no column");
  CHECK(refusal(with_index("\"ids\"", "\"reals\"")) == start + "column 'reals' is there twice");
  CHECK(refusal(with_index("\"ids\"", "\"eyes\"")) == start + "has no column 'ids'");
  CHECK(refusal(with_index("\"uint32\"", "\"int32\"")) ==
        start + "column 'ids' holds int32; expected uint32");
  CHECK_THAT(refusal(with_index("\"note\"", "\"nose\"")), Catch::Contains("its index is wrong"));
  CHECK_THAT(refusal(with_index("\"columns\":[", "\"columns\":7,\"x\":[")),
             Catch::Contains("its index is wrong"));
}

TEST_CASE("a column is read as what it is") {
  const CheckpointReader reader = reader_of(small_checkpoint());
  std::vector<double> ids;
  CHECK_THROWS_WITH(reader("ids", ids), Catch::Contains("holds uint32; expected float64"));
  double real = 0.0;
  CHECK_THROWS_WITH(reader("reals", real), Catch::Contains("is not a single number"));
}

TEST_CASE("other files are no checkpoints") {
  CHECK(refusal("") == "checkpoint 'file': not a checkpoint, or cut short");
  CHECK(refusal(std::string(1000, 'x')) == "checkpoint 'file': not a checkpoint, or cut short");
  std::string newer = small_checkpoint();
  newer[16] = 2;
  CHECK(refusal(newer) ==
        "checkpoint 'file': its format is version 2; this program reads version 1");
  const TemporaryDirectory directory;
  CHECK_THROWS_AS(read_bytes(directory / "missing"), FileError);
  CHECK_THROWS_AS(read_bytes(directory.path()), FileError);
  CHECK(claimed_step(directory / "missing") == std::nullopt);
  write_text(directory / "short", "RGIMP");
  CHECK(claimed_step(directory / "short") == std::nullopt);
  write_text(directory / "whole", small_checkpoint());
  CHECK(claimed_step(directory / "whole") == 42);
}
