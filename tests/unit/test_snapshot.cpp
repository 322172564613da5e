#include <hdf5.h>
#include <sys/resource.h>

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <future>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "rgimp/error.hpp"
#include "snapshot.hpp"
#include "snapshot_reader.hpp"
#include "temporary_directory.hpp"

namespace {

using namespace rgimp;

/// Three particles, one of each failure mode.
ParticleTable three_particles() {
  ParticleTable table;
  table.id = {0, 1, 2};
  table.position = {{{0.1, 0.2, 0.0}, {0.3, 0.4, 0.0}, {0.5, 0.6, -1.0 / 3.0}}};
  table.velocity = {{{1.0, 2.0, 0.0}, {3.0, 4.0, 0.0}, {5.0, 6.0, 7.0}}};
  table.stress = {{{1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, {}, {-1.0, -2.0, -3.0, -4.0, -5.0, -6.0}}};
  table.max_principal_stress = {1e6, 0.0, -0.25};
  table.failed = {FailureMode::tension, FailureMode::intact, FailureMode::shear};
  table.damage = {1.0, 0.25, 1.0};
  table.failure_step = {17, -1, 2000000000};
  return table;
}

/// Reads with plain HDF5 calls: nothing of the writer is trusted.
class Reader {
 public:
  explicit Reader(const std::filesystem::path& path)
      : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
    REQUIRE(file_ >= 0);
  }
  ~Reader() { H5Fclose(file_); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  std::vector<hsize_t> extent(const std::string& name) const {
    const hid_t dataset = open(name);
    const hid_t space = H5Dget_space(dataset);
    std::vector<hsize_t> sizes(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
    H5Sclose(space);
    H5Dclose(dataset);
    return sizes;
  }

  template <typename Number>
  std::vector<Number> read(const std::string& name, hid_t type) const {
    std::size_t count = 1;
    for (const hsize_t size : extent(name)) {
      count *= size;
    }
    std::vector<Number> values(count);
    const hid_t dataset = open(name);
    REQUIRE(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
    H5Dclose(dataset);
    return values;
  }

  std::vector<double> doubles(const std::string& name) const {
    return read<double>(name, H5T_NATIVE_DOUBLE);
  }
  std::vector<int> integers(const std::string& name) const {
    return read<int>(name, H5T_NATIVE_INT);
  }

  std::string text_attribute(const std::string& object, const std::string& name) const {
    const hid_t attribute =
        H5Aopen_by_name(file_, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(attribute >= 0);
    const hid_t type = H5Aget_type(attribute);
    CHECK(H5Tis_variable_str(type) == 0);
    CHECK(H5Tget_cset(type) == H5T_CSET_ASCII);
    std::string text(H5Tget_size(type), '\0');
    REQUIRE(H5Aread(attribute, type, text.data()) >= 0);
    H5Tclose(type);
    H5Aclose(attribute);
    return text;
  }

  std::array<int, 2> version() const {
    std::array<int, 2> numbers{};
    const hid_t attribute = H5Aopen_by_name(file_, "VTKHDF", "Version", H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(H5Aread(attribute, H5T_NATIVE_INT, numbers.data()) >= 0);
    H5Aclose(attribute);
    return numbers;
  }

 private:
  hid_t open(const std::string& name) const {
    const hid_t dataset = H5Dopen2(file_, ("VTKHDF/" + name).c_str(), H5P_DEFAULT);
    REQUIRE(dataset >= 0);
    return dataset;
  }

  hid_t file_;
};

template <typename Row>
std::vector<double> flatten(const std::vector<Row>& rows) {
  std::vector<double> values;
  for (const Row& row : rows) {
    values.insert(values.end(), row.begin(), row.end());
  }
  return values;
}

/// While it lives, files of this process end at a size, as on a full disk.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) {
    REQUIRE(getrlimit(RLIMIT_FSIZE, &before_) == 0);
    const rlimit small{bytes, before_.rlim_max};
    REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  }
  ~SmallFiles() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);
};

}  // namespace

TEST_CASE("a snapshot is named after its step") {
  CHECK(snapshot_name(0) == "step_000000000.vtkhdf");
  CHECK(snapshot_name(222440) == "step_000222440.vtkhdf");
}

TEST_CASE("a snapshot is an unstructured grid of vertices") {
  const TemporaryDirectory directory;
  write_snapshot(directory / "a.vtkhdf", three_particles(), {42, 1.5e-6});
  const Reader reader(directory / "a.vtkhdf");
  CHECK(reader.text_attribute("VTKHDF", "Type") == "UnstructuredGrid");
  CHECK(reader.version() == std::array{1, 0});
  for (const std::string name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"}) {
    CHECK(reader.integers(name) == std::vector{3});
  }
  CHECK(reader.integers("Connectivity") == std::vector{0, 1, 2});
  CHECK(reader.integers("Offsets") == std::vector{0, 1, 2, 3});
  CHECK(reader.integers("Types") == std::vector{1, 1, 1});
  CHECK(reader.integers("FieldData/step") == std::vector{42});
  CHECK(reader.doubles("FieldData/time") == std::vector{1.5e-6});
}

TEST_CASE("a snapshot holds every column of the particles, bit for bit") {
  const TemporaryDirectory directory;
  const ParticleTable table = three_particles();
  write_snapshot(directory / "a.vtkhdf", table, {});
  const Reader reader(directory / "a.vtkhdf");
  CHECK(reader.doubles("Points") == flatten(table.position));
  CHECK(reader.extent("Points") == std::vector<hsize_t>{3, 3});
  CHECK(reader.integers("PointData/id") == std::vector{0, 1, 2});
  CHECK(reader.doubles("PointData/velocity") == flatten(table.velocity));
  CHECK(reader.extent("PointData/velocity") == std::vector<hsize_t>{3, 3});
  CHECK(reader.doubles("PointData/stress") == flatten(table.stress));
  CHECK(reader.extent("PointData/stress") == std::vector<hsize_t>{3, 6});
  CHECK(reader.doubles("PointData/max_principal_stress") == table.max_principal_stress);
  CHECK(reader.integers("PointData/failed") == std::vector{1, 0, 2});
  CHECK(reader.doubles("PointData/damage") == table.damage);
  CHECK(reader.integers("PointData/failure_step") == table.failure_step);
  CHECK(reader.text_attribute("VTKHDF/Points", "units") == "m");
  CHECK(reader.text_attribute("VTKHDF/PointData/velocity", "units") == "m/s");
  CHECK(reader.text_attribute("VTKHDF/PointData/stress", "units") == "Pa");
  CHECK(reader.text_attribute("VTKHDF/PointData/failed", "units") == "1");
}

TEST_CASE("snapshots of equal particles are equal files, whenever they are written") {
  const TemporaryDirectory directory;
  write_snapshot(directory / "one", three_particles(), {5, 0.25});
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 tells the time in seconds
  write_snapshot(directory / "other", three_particles(), {5, 0.25});
  CHECK((read_text(directory / "one") == read_text(directory / "other")));  // no binary output
}

TEST_CASE("a snapshot may lack particles that were taken out, where the case takes them out") {
  const TemporaryDirectory directory;
  ParticleTable table = three_particles();
  table.id = {0, 2, 4};
  write_snapshot(directory / "a", table, {});
  CHECK(read_snapshot(directory / "a", 5, OnExit::remove).id == table.id);
  CHECK_THROWS_AS(read_snapshot(directory / "a", 5), FileError);
  CHECK_THROWS_AS(read_snapshot(directory / "a", 2, OnExit::remove), FileError);
  CHECK_THROWS_WITH(read_snapshot(directory / "a", 4, OnExit::remove),
                    Catch::Contains("id 4 is not there once"));
}

TEST_CASE("threads of one process write and read snapshots side by side") {
  const TemporaryDirectory directory;
  write_snapshot(directory / "alone", three_particles(), {5, 0.25});
  const auto write_and_read = [&](const char* name) {
    for (int repeat = 0; repeat < 50; ++repeat) {
      write_snapshot(directory / name, three_particles(), {5, 0.25});
      if (read_snapshot(directory / name, 3).failure_step != three_particles().failure_step) {
        throw std::logic_error("another snapshot than the one written");
      }
    }
  };
  auto other = std::async(std::launch::async, write_and_read, "other");
  CHECK_NOTHROW(write_and_read("one"));
  CHECK_NOTHROW(other.get());
  CHECK((read_text(directory / "one") == read_text(directory / "alone")));
  CHECK((read_text(directory / "other") == read_text(directory / "alone")));
}

TEST_CASE("a snapshot that cannot be written leaves nothing and names the file") {
  const TemporaryDirectory directory;
  write_text(directory / "file", "");
  CHECK_THROWS_WITH(write_snapshot(directory / "file" / "a.vtkhdf", three_particles(), {}),
                    Catch::Contains("a.vtkhdf") && Catch::Contains("Not a directory"));
  std::filesystem::create_directory(directory / "a.vtkhdf");
  write_text(directory / "a.vtkhdf" / "in the way", "");
  CHECK_THROWS_AS(write_snapshot(directory / "a.vtkhdf", three_particles(), {}), FileError);
  CHECK_FALSE(std::filesystem::exists(directory / "a.vtkhdf.tmp"));
}

TEST_CASE("what was left under the temporary name is not written through") {
  const TemporaryDirectory directory;
  write_text(directory / "other", "mine");
  std::filesystem::create_symlink("other", directory / "a.vtkhdf.tmp");
  write_snapshot(directory / "a.vtkhdf", three_particles(), {});
  CHECK(read_text(directory / "other") == "mine");
  CHECK_FALSE(std::filesystem::is_symlink(directory / "a.vtkhdf"));
}

TEST_CASE("a full disk is an error, not a crash") {
  const TemporaryDirectory directory;
  const SmallFiles limit(1000);
  CHECK_THROWS_WITH(write_snapshot(directory / "a.vtkhdf", three_particles(), {}),
                    Catch::Contains("File too large"));
  CHECK_FALSE(std::filesystem::exists(directory / "a.vtkhdf"));
}

TEST_CASE("the series lists the snapshots with their times") {
  const TemporaryDirectory directory;
  const auto path = directory / "snapshots.hdf.series";
  write_series(path, {{0, 0.0}, {5000, 9.5e-5}});
  const auto series = nlohmann::json::parse(read_text(path));
  CHECK(series["file-series-version"] == "1.0");
  REQUIRE(series["files"].size() == 2);
  CHECK(series["files"][1]["name"] == "step_000005000.vtkhdf");
  CHECK(series["files"][1]["time"] == 9.5e-5);
}
