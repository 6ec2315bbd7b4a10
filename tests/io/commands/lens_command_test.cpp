#include "tests/catch.h"
#include "tests/io/run_program.h"

#include <nlohmann/json.hpp>

using namespace abbe;
using test::Desk;
using test::number_after;

namespace {

const std::string kLenses = std::string(ABBE_SOURCE_DIR) + "/scenes/lenses/";

} // namespace

TEST_CASE("lens tells focal lengths as paraxial matrices outside of this project have them") {
  const Desk desk;
  struct Expected {
    const char* name;
    double f_number, mm;                          ///< mm: the length of the file's unit
    double focal_length[3], back_focal_length[3]; ///< at F, d and C, in the file's unit
  };
  const Expected lenses[] = {
      {"cooke_triplet",
       5.0,
       1.0,
       {49.984083, 50.021597, 50.070087},
       {42.400252, 42.436694, 42.485807}},
      {"double_gauss_f2",
       2.0,
       1.0,
       {99.985795, 100.003721, 100.063418},
       {61.428143, 61.487503, 61.574050}},
      {"tessar_f45", 4.5, 25.4, {4.002247, 3.997778, 3.998792}, {3.423909, 3.418755, 3.419538}}};
  for (const Expected& lens : lenses) {
    INFO(lens.name);
    const auto json =
        nlohmann::json::parse(desk.run("lens " + kLenses + lens.name + ".lens --json"));
    CHECK(json["f_number"].get<double>() == Approx(lens.f_number).epsilon(1e-3));
    CHECK(json["focal_length"].get<double>() ==
          Approx(lens.focal_length[1] * lens.mm).epsilon(2e-6));
    int found = 0;
    for (const auto& line : json["lines"])
      for (int i = 0; i < 3; ++i)
        if (line["line"] == std::vector<std::string>{"F", "d", "C"}[static_cast<std::size_t>(i)]) {
          ++found;
          CHECK(line["focal_length"].get<double>() ==
                Approx(lens.focal_length[i] * lens.mm).epsilon(2e-6));
          CHECK(line["back_focal_length"].get<double>() ==
                Approx(lens.back_focal_length[i] * lens.mm).epsilon(2e-6));
        }
    CHECK(found == 3);
  }
}

TEST_CASE("lens tells principal planes, which lie a focal length before the foci") {
  const Desk desk;
  const std::string text = desk.run("lens " + kLenses + "achromat_ac254_050_a.lens");
  const double f = number_after(text, "focal length");
  CHECK(f == Approx(50.166898).margin(1e-5));
  CHECK(number_after(text, "rear principal plane") ==
        Approx(number_after(text, "back focal length") - f).margin(2e-6));
  CHECK(number_after(text, "front principal plane") ==
        Approx(number_after(text, "front focal length") + f).margin(2e-6));
  // The focus of F less that of d: 43.359675 - 43.444278.
  const auto json =
      nlohmann::json::parse(desk.run("lens " + kLenses + "achromat_ac254_050_a.lens --json"));
  CHECK(json["lines"][1]["line"] == "F");
  CHECK(json["lines"][1]["back_focal_length"].get<double>() -
            json["back_focal_length"].get<double>() ==
        Approx(-0.084603).margin(2e-6));
}

TEST_CASE("spots off the axis are larger") {
  const Desk desk;
  const std::string file = "lens " + kLenses + "singlet_bk7_50.lens --json";
  const auto axis = nlohmann::json::parse(desk.run(file));
  const auto field = nlohmann::json::parse(desk.run(file + " --field 14"));
  CHECK(field["field_deg"] == 14.0);
  CHECK(field["lines"][3]["spot_radius"].get<double>() >
        axis["lines"][3]["spot_radius"].get<double>());
}

TEST_CASE("lens refuses what is wrong") {
  const Desk desk;
  desk.refuses("lens none.lens", "there is no file none.lens");
  desk.refuses("lens", "file is required");
  desk.refuses("lens " + kLenses + "cooke_triplet.lens --field 90", "--field");
  test::put(desk / "bad.lens", "surface 10 nonsense\n");
  desk.refuses("lens bad.lens", "bad.lens:1:");
}
