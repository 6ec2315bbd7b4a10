#include "tests/catch.h"
#include "tests/io/program_place.h"

#include <filesystem>
#include <string>

using abbe::test::Outcome;
using abbe::test::Place;

namespace {

const std::filesystem::path kMpi =
    std::filesystem::path(ABBE_EXECUTABLE).replace_filename("abbe-mpi");

/// True where it was built, which needs MPI.
bool is_built() {
  if (std::filesystem::exists(kMpi)) return true;
  WARN("abbe-mpi is not built, since there is no MPI");
  return false;
}

std::string by_ranks(int count, const std::string& options = "-q") {
  // More ranks than processors, and the administrator's, are refused otherwise.
  return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun " + options +
         " --oversubscribe --bind-to none -n " + std::to_string(count) + " '" + kMpi.string() +
         "' render ";
}

} // namespace

TEST_CASE("MPI ranks give the bytes of one process, whatever their number and their threads") {
  if (!is_built()) return;
  const Place place;
  place.write("scene.sdl", abbe::test::kSoftShadows);
  for (const std::string settings : {"--spp 16 --adaptive off", "--spp 24 --adaptive on"}) {
    place.run("render scene.sdl -q -o w.exr --spectral w.s.exr " + settings);
    for (const int count : {1, 2, 3, 5}) {
      INFO(settings << " by " << count);
      const Outcome done =
          place.shell(by_ranks(count) + "scene.sdl -q -o m.exr --spectral m.s.exr " + settings +
                      (count == 2 ? " --threads 3" : " --threads 1"));
      INFO(done.error);
      REQUIRE(done.exit_code == 0);
      CHECK(place.bytes("m.exr") == place.bytes("w.exr"));
      CHECK(place.bytes("m.s.exr") == place.bytes("w.s.exr"));
    }
  }
}

TEST_CASE("MPI ranks give the layers of one process") {
  if (!is_built()) return;
  const Place place;
  place.write("scene.sdl", abbe::test::kSoftShadows);
  const std::string options =
      "scene.sdl -q --spp 24 --adaptive on --layers depth,depth.nearest,normal,normal.through,"
      "albedo,uv,object,material,samples,variance,light:*,direct,indirect,caustic,class:*,"
      "glassPath,transmittance -o ";
  place.run("render " + options + "w.exr");
  for (const int count : {2, 3}) {
    INFO(count);
    const Outcome done = place.shell(by_ranks(count) + options + "m.exr --threads 1");
    INFO(done.error);
    REQUIRE(done.exit_code == 0);
    CHECK(place.bytes("m.exr") == place.bytes("w.exr"));
  }
}

TEST_CASE("what MPI ranks have kept is gone on from by any number of them, or by one process") {
  if (!is_built()) return;
  const Place place;
  const std::string begin =
      "scene.sdl -q --spp 12 --adaptive off --caustics off --checkpoint m.state -o m.exr";
  REQUIRE(place.shell(by_ranks(3) + begin).exit_code == 0);
  REQUIRE(place.shell(by_ranks(2) + "--resume m.state -q --spp 24 --checkpoint m.state -o m.exr")
              .exit_code == 0);
  place.run("render --resume m.state -q --spp 32 -o m.exr");
  place.run("render scene.sdl -q --spp 32 --adaptive off --caustics off -o w.exr");
  CHECK(place.bytes("m.exr") == place.bytes("w.exr"));
}

TEST_CASE("a mistake is told by one MPI rank, and ends all") {
  if (!is_built()) return;
  const Place place;
  const Outcome missing = place.shell(by_ranks(3) + "none.sdl -o m.exr");
  CHECK(missing.exit_code == 2);
  const std::size_t told = missing.error.find("none.sdl");
  REQUIRE(told != std::string::npos);
  CHECK(missing.error.find("none.sdl", told + 1) == std::string::npos);
  // One that is alone need not abort anybody, which mpirun would tell of at length.
  const Outcome alone = place.shell(by_ranks(1, "") + "none.sdl -o m.exr");
  CHECK(alone.exit_code == 2);
  CHECK(alone.error.find("none.sdl") != std::string::npos);
  CHECK(alone.error.find("MPI_ABORT") == std::string::npos);
  const Outcome part = place.shell(by_ranks(2) + "scene.sdl --part 1/2 -o m.state");
  CHECK(part.exit_code == 2);
  CHECK(part.error.find("--part and MPI exclude each other") != std::string::npos);
}

// The rank is killed when the first state is there; that state must be whole, and the job be over.
TEST_CASE("a lost MPI rank ends the job, and the state before is whole") {
  if (!is_built()) return;
  const Place place;
  const Outcome lost = place.shell(
      by_ranks(2, "") +
      "scene.sdl -q --spp 100000 --adaptive off --checkpoint m.state --checkpoint-every 1 -o m.exr "
      "& job=$!; for i in $(seq 600); do [ -e m.state ] && break; sleep 0.1; done; "
      "rank=$(cut -d' ' -f1 /proc/$job/task/$job/children); kill -KILL $rank; wait $job");
  CHECK(lost.exit_code != 0);
  CHECK(lost.error.find("exited on signal 9 (Killed)") != std::string::npos);
  CHECK(place.abbe("info m.state").exit_code == 0);
}
