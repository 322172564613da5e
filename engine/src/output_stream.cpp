#include "output_stream.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "rgimp/error.hpp"

namespace rgimp {

OutputStream::OutputStream(std::filesystem::path path, Start start)
    : path_(std::move(path)), file_(std::fopen(path_.c_str(), start == Start::empty ? "w" : "a")) {
  if (!file_) {
    fail();
  }
}

void OutputStream::write(std::string_view text) {
  // An empty column may have no address, which fwrite must not be given.
  if (text.empty()) {
    return;
  }
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) {
    fail();
  }
}

void OutputStream::flush() {
  if (std::fflush(file_.get()) != 0) {
    fail();
  }
}

void OutputStream::close() {
  if (std::fclose(file_.release()) != 0) {
    fail();
  }
}

void OutputStream::fail() const {
  const std::string reason = std::generic_category().message(errno);
  throw FileError(fmt::format("cannot write '{}': {}", path_.string(), reason));
}

}  // namespace rgimp
