#include "tests/catch.h"
#include "tests/io/temporary_folder.h"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <string>

using test_folder = abbe::test::Folder;
using abbe::test::content;

namespace {

struct Outcome {
  int exit_code = 0;
  std::string out, error;
};

/// A glass ball on a floor under a lamp, and the folder in which the program runs.
struct Place {
  test_folder folder;

  Place() {
    write("scene.sdl", "imageSize 40 24 bands 5 integrator path eye 0 1.2 5 fieldOfView 40\n"
                       "background 0.1 0.1 0.2\n"
                       "falloff square intensity 4 light E 1 3 2 1\n"
                       "defaultMaterials diffuse 0.7 0.7 0.7\n"
                       "push rotate -90 1 0 0 scale 4 4 1 square pop\n"
                       "glass N-SF11 push translate 0 0.8 0 scale 0.7 0.7 0.7 sphere pop\n");
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder.path / name, std::ios::binary) << text;
  }
  [[nodiscard]] std::string bytes(const std::string& name) const {
    return content(folder.path / name);
  }
  /// Runs the shell's command, in which $abbe is the program.
  [[nodiscard]] Outcome shell(const std::string& command) const {
    const std::string all = "cd '" + folder.path.string() + "' && abbe='" ABBE_EXECUTABLE "'; { " +
                            command + "; } >out 2>error";
    const int status = std::system(all.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes("out"), bytes("error")};
  }
  [[nodiscard]] Outcome abbe(const std::string& arguments) const {
    return shell("$abbe " + arguments);
  }
  /// Runs the program, which must succeed, and returns what it says on standard output.
  std::string run(const std::string& arguments) const {
    const Outcome outcome = abbe(arguments);
    INFO(arguments << "\n" << outcome.error);
    REQUIRE(outcome.exit_code == 0);
    return outcome.out;
  }
  void refuses(const std::string& arguments, const std::string& reason) const {
    const Outcome outcome = abbe(arguments);
    INFO(arguments << "\n" << outcome.error);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.error.find(reason) != std::string::npos);
  }
};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

} // namespace

TEST_CASE("a rendering that is told to end leaves a state, and goes on to the same picture") {
  const Place place;
  for (const std::string settings :
       {"--spp 48", "--spp 48 --adaptive off", "--noise 0.1 --spp 256"}) {
    INFO(settings);
    place.run("render scene.sdl " + settings + " -o whole.exr -o whole.png --spectral whole.s.exr");
    for (const char* const delay : {"0.05", "0.2"}) {
      const Outcome stopped =
          place.shell("rm -f c.state; $abbe render scene.sdl " + settings +
                      " --checkpoint c.state --spectral a.s.exr -o a.exr & p=$!; "
                      "for i in $(seq 300); do grep -q '^SigCgt:.*[367abef]$' /proc/$p/status && "
                      "break; sleep 0.01; done; sleep " +
                      delay + "; kill $p; wait $p");
      const bool interrupted = stopped.exit_code == 130;
      CHECK((interrupted || stopped.exit_code == 0));
      CHECK(contains(stopped.error, "interrupted: --resume c.state goes on") == interrupted);
      place.run("render --resume c.state --spectral a.s.exr -o a.exr -o a.png");
      CHECK(place.bytes("a.exr") == place.bytes("whole.exr"));
      CHECK(place.bytes("a.png") == place.bytes("whole.png"));
      CHECK(place.bytes("a.s.exr") == place.bytes("whole.s.exr"));
    }
  }
}

TEST_CASE("a finished picture gets more samples, and it is told what bytes these give") {
  const Place place;
  place.run("render scene.sdl --adaptive off --spp 48 -o whole.exr");
  place.run("render scene.sdl --adaptive off --spp 16 --checkpoint c.state -o a.exr");
  const std::string same = place.run("render --resume c.state --spp 48 -o a.exr");
  CHECK(contains(same, "c.state has 16 of 16 samples a pixel, which become 48: the same bytes"));
  CHECK(place.bytes("a.exr") == place.bytes("whole.exr"));

  place.run("render scene.sdl --adaptive off --spp 24 --checkpoint c.state -o a.exr");
  const std::string other = place.run("render --resume c.state --spp 48 -o a.exr");
  CHECK(contains(other, "unbiased, but not the bytes of 48 in one go, since a pass of light paths "
                        "was for fewer samples"));
  CHECK(place.bytes("a.exr") != place.bytes("whole.exr"));

  place.run("render scene.sdl --adaptive off --caustics off --spp 48 -o whole.exr");
  place.run("render scene.sdl --adaptive off --caustics off --spp 7 --checkpoint c.state -o a.exr");
  CHECK(contains(place.run("render --resume c.state --spp 48 -o a.exr"), "the same bytes"));
  CHECK(place.bytes("a.exr") == place.bytes("whole.exr"));

  place.run("render scene.sdl --spp 8 --checkpoint c.state -o a.exr");
  CHECK(contains(place.run("render --resume c.state --spp 16 -o a.exr"),
                 "since it was decided with fewer samples"));
}

TEST_CASE("a state that does not fit what is asked for is refused with what differs") {
  const Place place;
  place.run("render scene.sdl --spp 4 --checkpoint c.state -o a.exr");
  place.refuses("render --resume c.state --seed 3 -o a.exr", "--seed 3, not 0");
  place.refuses("render --resume c.state --size 20x20 --depth 2 -o a.exr",
                "--depth 2, not 1000000; --size 20x20, not 40x24");
  place.refuses("render --resume c.state --spp 2 -o a.exr", "no way back to 2");
  place.refuses("render --resume c.state --spectral s.exr -o a.exr", "this state has no bands");
  place.refuses("render --resume c.state --part 1/2 -o a.state", "--part asks for 1/2");
  place.refuses("render --resume scene.sdl -o a.exr", "this is not the state of a rendering");
  place.refuses("render scene.sdl --checkpoint scene.sdl -o a.exr",
                "this state would replace scene.sdl");
  place.refuses("render scene.sdl --checkpoint-every 0.5 -o a.exr", "not a time of 1 second");
  place.refuses("render -o a.exr", "scene is required");
  place.write("scene.sdl", place.bytes("scene.sdl") + "sphere\n");
  place.refuses("render --resume c.state -o a.exr", "scene.sdl is not what it was");
}

TEST_CASE("the parts of a rendering merge into the picture of the whole") {
  const Place place;
  place.run(
      "render scene.sdl --spp 40 --adaptive off --errors -o w.exr -o w.png --spectral w.s.exr");
  for (const int count : {1, 2, 3, 7}) {
    INFO(count);
    std::string parts;
    for (int k = count; k > 0; --k) {
      const std::string name = "p" + std::to_string(k) + ".state";
      place.run("render scene.sdl --spp 40 --adaptive off --errors --spectral s.exr --part " +
                std::to_string(k) + "/" + std::to_string(count) +
                (count == 1 ? " --checkpoint " + name + " -o a.exr" : " -o " + name));
      parts += " " + name;
    }
    place.run("merge" + parts + " -o m.exr -o m.png --spectral m.s.exr");
    CHECK(place.bytes("m.exr") == place.bytes("w.exr"));
    CHECK(place.bytes("m.png") == place.bytes("w.png"));
    CHECK(place.bytes("m.s.exr") == place.bytes("w.s.exr"));
  }
  place.refuses("merge p1.state p7.state p3.state -o m.exr", "these are missing: 2 and 4 to 6");
  const std::string told = place.run("info p3.state");
  CHECK(contains(told, "part: 3 of 7"));
  CHECK(contains(told, "samples a pixel: 6 of 6; complete"));
  CHECK(contains(told, "bands: 5 sums a pixel"));
  CHECK(contains(told, "all checksums are right"));
}

TEST_CASE("what cannot be rendered in parts is refused with a hint") {
  const Place place;
  place.refuses("render scene.sdl --part 1/2 -o a.state", "Add --adaptive off");
  place.refuses("render scene.sdl --part 1/2 --noise 0.1 -o a.state", "--part and --noise");
  place.refuses("render scene.sdl --part 1/2 --time 5 -o a.state", "--part and --time");
  place.refuses("render scene.sdl --part 1/9 --spp 4 -o a.state", "cannot be divided into 9 parts");
  place.refuses("render scene.sdl --part 1/2 -o a.exr", "a part is a state and no picture");
  place.refuses("render scene.sdl --part 1/2", "a part goes into one file");
  for (const std::string part : {"0/2", "3/2", "1", "x/2", "1/0", "-1/2"})
    place.refuses("render scene.sdl --part " + part + " -o a.state", "is not a part such as 3/8");
}

TEST_CASE("a disk that is full keeps the state before") {
  const Place place;
  place.run("render scene.sdl --spp 16 --adaptive off --checkpoint c.state -o a.exr");
  const std::string before = place.bytes("c.state");
  // A file may have as many blocks of 512 bytes as the picture needs, and not as the state needs.
  const Outcome full = place.shell("ulimit -f 40; $abbe render --resume c.state --spp 32 "
                                   "--checkpoint c.state -o a.exr");
  CHECK(full.exit_code == 1);
  CHECK(contains(full.error, "warning: cannot write c.state: File too large; what was kept before "
                             "is still there"));
  CHECK(place.bytes("c.state") == before);
  CHECK(contains(full.out, "wrote a.exr"));
  place.run("render --resume c.state --spp 32 -o b.exr");
  CHECK(place.bytes("a.exr") == place.bytes("b.exr"));
}
