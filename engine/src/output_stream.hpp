#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

namespace rgimp {

/// A file being written. Every call throws FileError where the system
/// refuses, with the file and the system's reason in the message.
class OutputStream {
 public:
  /// With what an existing file holds: nothing of it, or all.
  enum class Start { empty, at_end };

  explicit OutputStream(std::filesystem::path path, Start start = Start::empty);

  void write(std::string_view text);
  /// Hands everything written so far to the system, so that it outlives this process.
  void flush();
  /// Nothing may be written afterwards.
  void close();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Closer> file_;
};

}  // namespace rgimp
