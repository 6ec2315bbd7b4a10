#include "tests/catch.h"
#include "tests/io/program_place.h"

#include <string>

using abbe::test::Outcome;
using abbe::test::Place;

namespace {

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

// 64 samples in the mean, of which each pixel gets a number of its own: borders of parts fall
// within passes of light.
TEST_CASE("parts spread their samples by a plan file, and merge into what the whole spreads") {
  const Place place;
  place.write("scene.sdl", abbe::test::kSoftShadows);
  place.run("render scene.sdl --spp 64 --plan-out p.plan -q");
  const std::string told = place.run("render scene.sdl --spp 64 --plan-in p.plan -o w.exr");
  CHECK(contains(told, "samples a pixel: 16 to "));
  for (const int count : {2, 5}) {
    std::string parts;
    for (int k = 1; k <= count; ++k) {
      const std::string number = std::to_string(k), name = "p" + number + ".state";
      place.run("render scene.sdl --spp 64 --plan-in p.plan --part " + number + "/" +
                std::to_string(count) + " -o " + name);
      parts += " " + name;
    }
    place.run("merge" + parts + " -o m.exr");
    CHECK(place.bytes("m.exr") == place.bytes("w.exr"));
  }
  // Another plan, by other pilots, does not fit.
  place.run("render scene.sdl --spp 32 --plan-out q.plan -q");
  place.run("render scene.sdl --spp 64 --plan-in q.plan --part 1/5 -o q1.state");
  place.refuses("merge q1.state p2.state p3.state p4.state p5.state -o m.exr",
                "it was rendered with --plan-in");
  place.refuses("render --resume p1.state --spp 128 -o p1.state", "more cannot be added");
  place.refuses("render scene.sdl --spp 64 --seed 4 --plan-in p.plan -o a.exr", "--seed 4, not 0");
  place.refuses("render scene.sdl --spp 64 --adaptive off --plan-in p.plan -o a.exr",
                "needs adaptive sampling");
  place.refuses("render scene.sdl --noise 0.1 --plan-in p.plan -o a.exr", "exclude each other");
  place.refuses("render scene.sdl --time 5 --plan-out a.plan", "exclude each other");
  place.refuses("render scene.sdl --spp 64 --plan-out a.plan -o a.exr", "Leave out -o");
  place.refuses("render scene.sdl --spp 64 --plan-out a.plan --plan-in p.plan", "made once");
  place.refuses("render scene.sdl --spp 64 --plan-in scene.sdl -o a.exr", "this is not the state");
  place.write("scene.sdl", place.bytes("scene.sdl") + "sphere\n");
  place.refuses("render scene.sdl --spp 64 --plan-in p.plan -o a.exr", "is not what it was");
}

TEST_CASE("the layers of parts merge into those of the whole") {
  const Place place;
  const std::string options =
      "render scene.sdl -q --spp 40 --adaptive off --errors --layers "
      "depth.nearest,normal,object,material,samples,variance,light:*,caustic -o ";
  place.run(options + "w.exr");
  for (const char* const part : {"1", "2", "3"})
    place.run(options + "p" + part + ".state --part " + part + "/3");
  place.run("merge p3.state p1.state p2.state -q -o m.exr");
  CHECK(place.bytes("m.exr") == place.bytes("w.exr"));
}

// loopsubdiv is not understood: the scene is rendered without, where that is asked for.
TEST_CASE("a scene that was read leniently is so again when its states are used") {
  const Place place;
  place.write("scene.pbrt", "Camera \"perspective\"\n"
                            "Film \"rgb\" \"integer xresolution\" [ 20 ] "
                            "\"integer yresolution\" [ 12 ]\n"
                            "WorldBegin\nLightSource \"infinite\"\n"
                            "Shape \"loopsubdiv\" \"integer levels\" 3\n"
                            "Material \"diffuse\"\nTranslate 0 0 4\nShape \"sphere\"\n");
  const std::string options = "render scene.pbrt --lenient -q --spp 4 --adaptive off ";
  place.run(options + "-o w.exr");
  place.run(options + "--part 1/2 -o p1.state");
  place.run(options + "--part 2/2 -o p2.state");
  place.run("merge p1.state p2.state -q -o m.exr");
  CHECK(place.bytes("m.exr") == place.bytes("w.exr"));
  place.run("render --resume p2.state -q -o p2.state");
  place.run("merge p1.state p2.state -q -o m.exr");
  CHECK(place.bytes("m.exr") == place.bytes("w.exr"));
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
