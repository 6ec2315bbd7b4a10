#include "io/files/regular_file.h"

#include "io/text/token.h"
#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <sys/stat.h>

#include <fstream>
#include <stdexcept>
#include <string>

using namespace abbe;

namespace {

std::string why(const std::filesystem::path& path) {
  try {
    require_regular_file(path);
  } catch (const std::runtime_error& error) {
    CHECK_THROWS_WITH(read_regular_file(path), error.what());
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("all bytes of a file are read, also where its size is not known beforehand") {
  const test::Folder folder;
  const std::string text("a\0b\r\n", 5);
  std::ofstream(folder.path / "f", std::ios::binary) << text;
  CHECK(read_regular_file(folder.path / "f") == text);
  std::ofstream(folder.path / "empty").close();
  CHECK(read_regular_file(folder.path / "empty").empty());
  CHECK(read_regular_file("/proc/self/status").find("Name:") == 0); // its size is told as 0
}

TEST_CASE("what is no regular file is refused at once") {
  const test::Folder folder;
  REQUIRE(::mkfifo((folder.path / "pipe").c_str(), 0600) == 0); // nobody ever writes into it
  CHECK(why(folder.path / "pipe") == "it is a pipe");
  CHECK(why("/dev/zero") == "it is a device");
  CHECK(why(folder.path) == "it is a folder");
  CHECK(why(folder.path / "none") == "No such file or directory");
  CHECK_THROWS_WITH(read_text_file("/dev/zero"), "/dev/zero: the file cannot be read (it is a "
                                                 "device). Check its name and folder");
}
