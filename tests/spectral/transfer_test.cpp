#include "spectral/color.h"
#include "spectral/transfer.h"
#include "tests/catch.h"

#include <cmath>
#include <stdexcept>

using namespace abbe;

TEST_CASE("A power law is the thesis's: 0.556 becomes 0.766 at gamma 2.2") {
  const TransferFunction gamma = power_transfer(2.2);
  CHECK(encode(gamma, 0.556) == Approx(0.765816828).margin(5e-10));
  CHECK(encode(gamma, 5.0 / 9.0) == Approx(0.765538511).margin(5e-10));
  CHECK(encode(gamma, 0.0) == 0.0);
  CHECK(encode(gamma, 1.0) == 1.0);
  CHECK(encode(gamma, {0.556, 0.0, 1.0}).r == encode(gamma, 0.556));
}

TEST_CASE("The curves have the values of their standards") {
  // BT.709: 18 % grey is 1.099 * 0.18^0.45 - 0.099; below 0.018 a line of slope 4.5.
  const TransferFunction rec709 = find_transfer("rec709").value();
  CHECK(encode(rec709, 0.18) == Approx(1.099 * std::pow(0.18, 0.45) - 0.099).epsilon(1e-14));
  CHECK(encode(rec709, 0.01) == Approx(0.045).epsilon(1e-14));
  CHECK(find_transfer("Rec2020") == rec709);
  CHECK(encode(srgb_transfer(), 0.5) == Approx(0.7353569830524495).epsilon(1e-14));
  CHECK(encode(srgb_transfer(), 0.002) == Approx(0.02584).epsilon(1e-14));
  CHECK(encode(linear_transfer(), 0.37) == 0.37);
  // ST 240: 0.5 is 1.1115 * 0.5^0.45 - 0.1115. ROMM: 1/1024 is 1/64.
  CHECK(encode(find_transfer("smpte240m").value(), 0.5) ==
        Approx(1.1115 * std::pow(0.5, 0.45) - 0.1115).epsilon(1e-14));
  CHECK(encode(find_transfer("romm").value(), 1.0 / 1024.0) == Approx(1.0 / 64.0).epsilon(1e-14));
}

TEST_CASE("Every curve goes from 0 to 1, rises, joins at its knee and is undone by decoding") {
  for (const std::string& name : transfer_names()) {
    const TransferFunction transfer = find_transfer(name).value();
    INFO(name);
    CHECK(encode(transfer, 0.0) == 0.0);
    CHECK(encode(transfer, 1.0) == Approx(1.0).epsilon(1e-14));
    const double knee = transfer.knee * transfer.slope;
    // Standards round their constants to four digits.
    CHECK(encode(transfer, knee * (1.0 - 1e-12)) == Approx(encode(transfer, knee)).margin(4e-4));
    double before = -2.0;
    for (double v = -1.5; v < 2.0; v += 0.013) {
      CHECK(decode(transfer, encode(transfer, v)) == Approx(v).epsilon(1e-3).margin(1e-9));
      CHECK(encode(transfer, v) > before);
      before = encode(transfer, v);
    }
  }
}

TEST_CASE("Transfer functions go by name or gamma") {
  CHECK(find_transfer("SRGB") == srgb_transfer());
  CHECK(find_transfer("2.6")->exponent == 2.6);
  for (const char* wrong : {"", "gamma", "0", "0.05", "11", "-2.2", "nan", "2.2x", "1e400"})
    CHECK_FALSE(find_transfer(wrong).has_value());
  CHECK_THROWS_AS(power_transfer(0.0), std::invalid_argument);
  CHECK_THROWS_AS(power_transfer(std::nan("")), std::invalid_argument);
}
