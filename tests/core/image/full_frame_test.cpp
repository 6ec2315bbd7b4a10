#include "core/image/full_frame.h"

#include "tests/catch.h"

using namespace abbe;

namespace {

const PixelWindow kFull{0, 0, 3, 2}, kCrop{1, 1, 3, 2};

} // namespace

TEST_CASE("a crop over the whole frame is black and clear around its pixels") {
  SceneLinearImage image{kFull, kCrop, {1, 2, 3, 4, 5, 6, 7, 8}, {{"a", "b"}}};
  image.channels.push_back({"depth.Z", {9, 10}});
  const SceneLinearImage all = placed_in(kFull, image);
  CHECK(all.data == kFull);
  CHECK(all.metadata == image.metadata);
  CHECK(all.rgba == std::vector<float>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, //
                                       0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8});
  REQUIRE(all.channels.size() == 1);
  CHECK(all.channels[0].values == std::vector<float>{0, 0, 0, 0, 9, 10});
  CHECK(placed_in({0, 0, 3, 1}, image).rgba == std::vector<float>(12, 0.0f));
}

TEST_CASE("each band of a crop is placed for itself") {
  const SpectralImage image{kFull, kCrop, {500, 600}, {1, 2, 3, 4}, std::vector<float>(8, 1.0f),
                            {}};
  CHECK(placed_in(kFull, image).values == std::vector<float>{0, 0, 0, 0, 1, 2, 0, 0, 0, 0, 3, 4});
}

TEST_CASE("a picture for screens is placed with both its values") {
  const DisplayImage image{kFull, kCrop, {1, 2, 3, 4, 5, 6}, {6, 5, 4, 3, 2, 1}, {}};
  const DisplayImage all = in_full_frame(image);
  CHECK(all.data == kFull);
  CHECK(all.encoded == std::vector<float>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6});
  CHECK(all.linear == std::vector<float>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 6, 5, 4, 3, 2, 1});
}

TEST_CASE("two windows have in common what lies in both") {
  CHECK(common_part(kFull, kCrop) == kCrop);
  CHECK_FALSE(common_part({0, 0, 3, 1}, kCrop));
}
