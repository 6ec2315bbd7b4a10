#include "io/files/atomic_file.h"

#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

using namespace abbe;
namespace fs = std::filesystem;
using test::content;
using test::Folder;

namespace {

void put(const fs::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

template <class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

} // namespace

TEST_CASE("replace_file writes beside the target and renames") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr";
  put(target, "old");
  replace_file(target, [&](const fs::path& temporary) {
    CHECK(temporary.parent_path() == folder.path);
    CHECK(temporary.extension() == ".exr");
    CHECK(temporary != target);
    CHECK(content(target) == "old");
    put(temporary, "new");
    CHECK(content(target) == "old");
  });
  CHECK(content(target) == "new");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("two writers of one target have different temporaries") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr";
  replace_file(target, [&](const fs::path& outer) {
    put(outer, "outer");
    replace_file(target, [&](const fs::path& inner) {
      CHECK(inner != outer);
      put(inner, "inner");
    });
    CHECK(content(target) == "inner");
    CHECK(content(outer) == "outer");
  });
  CHECK(content(target) == "outer");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a failed write keeps the old file, removes the temporary and says why") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr";
  put(target, "old");
  const std::string message = message_of([&] {
    replace_file(target, [](const fs::path& temporary) {
      put(temporary, "half of the new");
      throw std::runtime_error("the disk is full");
    });
  });
  CHECK(message == "cannot write " + target.string() + ": the disk is full");
  CHECK(content(target) == "old");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a target that cannot be written is refused before anything is written") {
  const Folder folder;
  const auto write = [](const fs::path&) { FAIL("must not be called"); };
  const fs::path lost = folder.path / "no_folder" / "picture.exr";
  CHECK(message_of([&] { replace_file(lost, write); }) ==
        "cannot write " + lost.string() + ": No such file or directory");
  CHECK(message_of([&] { replace_file(folder.path, write); }) ==
        "cannot write " + folder.path.string() + ": not a regular file");
  CHECK(message_of([&] { replace_file("/dev/null", write); }) ==
        "cannot write /dev/null: not a regular file");
  CHECK(message_of([&] { replace_file("", write); }) ==
        "cannot write : the name of the file is missing");
  CHECK(folder.file_count() == 0);
}

TEST_CASE("a symbolic link stays a link; what it points to is replaced") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr", link = folder.path / "link.exr";
  put(target, "old");
  fs::create_symlink("picture.exr", link);
  replace_file(link, [](const fs::path& temporary) { put(temporary, "new"); });
  CHECK(fs::is_symlink(link));
  CHECK(content(target) == "new");
}

TEST_CASE("the new file has the permissions that any new file would have") {
  const Folder folder;
  const fs::path target = folder.path / "picture.exr", plain = folder.path / "plain";
  put(plain, "");
  replace_file(target, [](const fs::path&) {});
  CHECK(fs::status(target).permissions() == fs::status(plain).permissions());
}
