#include "io/files/file_watch.h"

#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

using namespace abbe;
using test::Folder;
using test::put;

TEST_CASE("a file that is saved is seen, and no other") {
  const Folder folder;
  put(folder.path / "scene.sdl", "a");
  put(folder.path / "other.sdl", "b");
  FileWatch watch;
  watch.follow({folder.path / "scene.sdl"});
  CHECK_FALSE(watch.wait(0.0));
  put(folder.path / "other.sdl", "c");
  CHECK_FALSE(watch.wait(0.05));
  put(folder.path / "scene.sdl", "d");
  CHECK(watch.wait(1.0));
  CHECK_FALSE(watch.wait(0.0)); // told once
}

TEST_CASE("a file that another takes the name of is seen, also a second time") {
  const Folder folder;
  put(folder.path / "scene.sdl", "a");
  FileWatch watch;
  watch.follow({folder.path / "scene.sdl"});
  for (int i = 0; i < 2; ++i) {
    put(folder.path / "new", "b");
    CHECK_FALSE(watch.wait(0.05));
    std::filesystem::rename(folder.path / "new", folder.path / "scene.sdl");
    CHECK(watch.wait(1.0));
  }
}

TEST_CASE("what a link leads to is watched, and a file that is not there yet") {
  const Folder folder;
  std::filesystem::create_directory(folder.path / "far");
  put(folder.path / "far/scene.sdl", "a");
  std::filesystem::create_symlink("far/scene.sdl", folder.path / "link.sdl");
  FileWatch watch;
  watch.follow({folder.path / "link.sdl", folder.path / "later.sdl"});
  put(folder.path / "far/scene.sdl", "b");
  CHECK(watch.wait(1.0));
  put(folder.path / "later.sdl", "b");
  CHECK(watch.wait(1.0));
}

TEST_CASE("files that are followed no more are not seen") {
  const Folder folder;
  std::filesystem::create_directory(folder.path / "far");
  FileWatch watch;
  watch.follow({folder.path / "a", folder.path / "far/b"});
  watch.follow({folder.path / "a"});
  put(folder.path / "far/b", "x");
  CHECK_FALSE(watch.wait(0.05));
  put(folder.path / "a", "x");
  CHECK(watch.wait(1.0));
}
