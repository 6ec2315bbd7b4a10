#!/usr/bin/env bash
# Embree 3.13.5 (Debian 12's libembree3-3 3.13.5+dfsg-2): the valid mask of rtcIntersect16 and rtcIntersect8 does not
# keep rays from the callbacks of user geometry where a packet is wider than the instruction set that the device uses.
#
# Seen: of a packet of 8 rays whose mask has 3 of them valid, a device with isa=avx calls back for 3, but one with
# isa=sse2 for all 8, with `valid` -1 for each; of a packet of 16, isa=avx and isa=sse2 call back for all 16. Rays that
# are kept out by tfar < tnear are never called back. The manual says that only active rays are processed.
#
# Whom it bites: renderers that fill packets partly and let a ray's id point into an array of the rays that there are:
# the callback reads beyond its end, but only on processors without wide registers, or under valgrind.
#
# The script fails if the library comes to behave otherwise. It needs Debian 12, g++ and the network.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

apt-get download -q libembree3-3=3.13.5+dfsg-2 libembree-dev=3.13.5+dfsg-2 libtbb12=2021.8.0-2+deb12u1 libtbbmalloc2=2021.8.0-2+deb12u1 >apt.log 2>&1 ||
  { cat apt.log >&2; exit 1; }
for package in ./*.deb; do dpkg -x "$package" root; done
lib=$work/root/usr/lib/$(gcc -dumpmachine)

cat >masked.cpp <<'CPP'
#include <embree3/rtcore.h>

#include <cstdio>
#include <cstdlib>

static bool called[16];

static void bounds(const RTCBoundsFunctionArguments* args) {
  *args->bounds_o = {-1, -1, -1, 0, 1, 1, 1, 0};
}
static void intersect(const RTCIntersectFunctionNArguments* args) {
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  for (unsigned i = 0; i < args->N; ++i)
    if (args->valid[i] == -1) called[RTCRayN_id(rays, args->N, i)] = true;
}

// masked CONFIG WIDTH VALID mask|interval: how many of WIDTH rays are called back
int main(int, char** argv) {
  RTCDevice device = rtcNewDevice(argv[1]);
  RTCScene scene = rtcNewScene(device);
  RTCGeometry box = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(box, 1);
  rtcSetGeometryBoundsFunction(box, bounds, nullptr);
  rtcSetGeometryIntersectFunction(box, intersect);
  rtcCommitGeometry(box);
  rtcAttachGeometry(scene, box);
  rtcCommitScene(scene);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  const int width = std::atoi(argv[2]), valid_count = std::atoi(argv[3]);
  const bool by_interval = argv[4][0] == 'i';
  alignas(64) int valid[16];
  alignas(64) RTCRayHit16 wide{};
  alignas(64) RTCRayHit8 narrow{};
  const auto fill = [&](auto& packet) {
    for (int i = 0; i < width; ++i) {
      const bool used = i < valid_count;
      valid[i] = used ? -1 : 0;
      packet.ray.org_z[i] = -5;
      packet.ray.dir_z[i] = 1;
      packet.ray.tfar[i] = used || !by_interval ? 100.0f : -1.0f;
      packet.ray.mask[i] = ~0u;
      packet.ray.id[i] = i;
      packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
  };
  if (width == 16) {
    fill(wide);
    rtcIntersect16(valid, scene, &context, &wide);
  } else {
    fill(narrow);
    rtcIntersect8(valid, scene, &context, &narrow);
  }
  int count = 0;
  for (const bool c : called)
    count += c;
  std::printf("%d\n", count);
}
CPP
g++ -std=c++17 -O1 masked.cpp -I root/usr/include -L "$lib" -lembree3 -Wl,-rpath,"$lib" -Wl,-rpath-link,"$lib" -o masked

failed=0
expect() { # WIDTH ISA WAY COUNT
  local seen
  seen=$(LD_LIBRARY_PATH=$lib ./masked "isa=$2" "$1" 3 "$3")
  echo "rtcIntersect$1, isa=$2, kept out by $3: 3 rays are valid, $seen are called back"
  [ "$seen" = "$4" ] || { echo "  expected $4" >&2; failed=1; }
}
expect 16 avx mask 16
expect 16 sse2 mask 16
expect 8 sse2 mask 8
expect 8 avx mask 3
expect 16 avx interval 3
expect 16 sse2 interval 3
exit $failed
