#include "io/meshes/read_ply.h"

#include "tests/catch.h"
#include "tests/io/meshes/random_polygons.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>
#include <vector>

using namespace abbe;

namespace {

Polygons read(const std::string& bytes) {
  return read_ply(bytes, "m.ply");
}

std::string error(const std::string& bytes) {
  try {
    (void)read(bytes);
  } catch (const ReadError& fault) {
    return fault.what();
  }
  return "no error";
}

enum class Form { text, little, big };

/// Writes rows in one of the three formats.
struct Writer {
  Form form;
  std::string bytes = {};

  template <class Value>
  void raw(Value value) {
    std::array<char, sizeof(Value)> part{};
    std::memcpy(part.data(), &value, part.size()); // this test runs on little-endian machines
    if (form == Form::big) std::ranges::reverse(part);
    bytes.append(part.data(), part.size());
  }
  /// By the first letters of the type's name.
  void value(const std::string& type, double x) {
    if (form == Form::text) {
      if (type == "double" || type == "float64")
        bytes += fmt::format("{} ", x);
      else if (type == "float" || type == "float32")
        bytes += fmt::format("{} ", static_cast<float>(x));
      else
        bytes += fmt::format("{} ", static_cast<std::int64_t>(x));
    } else if (type == "double" || type == "float64") {
      raw(x);
    } else if (type == "float" || type == "float32") {
      raw(static_cast<float>(x));
    } else if (type == "char" || type == "int8") {
      raw(static_cast<std::int8_t>(x));
    } else if (type == "uchar" || type == "uint8") {
      raw(static_cast<std::uint8_t>(x));
    } else if (type == "short" || type == "int16") {
      raw(static_cast<std::int16_t>(x));
    } else if (type == "ushort" || type == "uint16") {
      raw(static_cast<std::uint16_t>(x));
    } else if (type == "int" || type == "int32") {
      raw(static_cast<std::int32_t>(x));
    } else {
      raw(static_cast<std::uint32_t>(x));
    }
  }
};

const std::vector<std::string> kWhole{"char",   "int8",   "uchar", "uint8", "short", "int16",
                                      "ushort", "uint16", "int",   "int32", "uint",  "uint32"};

/// The mesh in some way of PLY, with properties and elements that nobody asks for.
std::string ply_of(std::mt19937_64& random, const Polygons& mesh, bool single) {
  const auto any = [&](const std::vector<std::string>& list) {
    return list[random() % list.size()];
  };
  const std::string end = any({"\n", "\r\n", "\r"});
  Writer out{static_cast<Form>(random() % 3)};
  const std::string format = std::vector<std::string>{
      "ascii", "binary_little_endian", "binary_big_endian"}[static_cast<std::size_t>(out.form)];
  const std::string real =
      single ? any({"float", "float32", "double", "float64"}) : any({"double", "float64"});
  const std::string index = any(kWhole), length = any(kWhole), odd = any(kWhole);
  const bool before = random() % 2 == 0, list_before = random() % 2 == 0, last = random() % 2 == 0,
             other = random() % 2 == 0, faces_first = random() % 4 == 0;
  std::string header = "ply" + end + "format " + format + " 1.0" + end + "comment \\ # x" + end;
  const std::string face = fmt::format(
      "element face {}{}{}property list {} {} {}{}{}", mesh.ends.size(), end,
      list_before ? "property list " + odd + " float texcoord" + end : "", length, index,
      any({"vertex_indices", "vertex_index"}), end, last ? "property " + odd + " flags" + end : "");
  if (other)
    header +=
        fmt::format("element camera 2{0}property {1} x{0}property list uchar {1} y{0}", end, odd);
  if (faces_first) header += face;
  header += fmt::format("element vertex {}{}", mesh.vertices.size(), end);
  if (before) header += "property " + odd + " red" + end;
  for (const char* axis : {"x", "y", "z"})
    header += fmt::format("property {} {}{}", real, axis, end);
  if (list_before) header += "property list uchar double more" + end;
  if (!faces_first) header += face;
  header += "end_header" + end;
  const auto line = [&] {
    if (out.form == Form::text) out.bytes += end;
  };
  const auto write_faces = [&] {
    std::size_t begin = 0;
    for (const std::size_t stop : mesh.ends) {
      if (list_before) {
        out.value(odd, 2);
        out.value("float", 0.25);
        out.value("float", 10);
      }
      out.value(length, static_cast<double>(stop - begin));
      for (; begin < stop; ++begin)
        out.value(index, mesh.corners[begin]);
      if (last) out.value(odd, 13);
      line();
    }
  };
  if (other)
    for (int i = 0; i < 2; ++i) {
      for (const int x : {10, i, 13})
        if (x != 13 || i == 1) out.value(x == i ? "uchar" : odd, x);
      line();
    }
  if (faces_first) write_faces();
  for (const glm::dvec3& p : mesh.vertices) {
    if (before) out.value(odd, 10);
    for (int axis = 0; axis < 3; ++axis)
      out.value(real, p[axis]);
    if (list_before) {
      out.value("uchar", 1);
      out.value("double", 1e300);
    }
    line();
  }
  if (!faces_first) write_faces();
  return header + out.bytes;
}

std::string with_header(const std::string& header, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

const std::string kVertices = "element vertex 3\nproperty float x\nproperty float y\n"
                              "property float z\n";
const std::string kFaces = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string kRows = "0 0 0\n1 0 0\n0 1 0\n";

} // namespace

TEST_CASE("meshes written in all ways of PLY come back bit by bit") {
  std::mt19937_64 random(7);
  for (int i = 0; i < 3000; ++i) {
    const Polygons mesh = test::random_polygons(random, i % 2 == 0);
    const std::string bytes = ply_of(random, mesh, i % 2 == 0);
    INFO(bytes);
    REQUIRE(test::same(read(bytes), mesh));
  }
}

TEST_CASE("coordinates may be whole numbers") {
  const std::string text = "element vertex 1\nproperty char x\nproperty ushort y\nproperty int z\n";
  const Polygons mesh = read(with_header(text, "-128 65535 -2147483648\n"));
  CHECK(mesh.vertices[0] == glm::dvec3(-128.0, 65535.0, -2147483648.0));
}

TEST_CASE("strips of triangles turn every other one, and begin again after -1") {
  const std::string header = "element vertex 5\nproperty float x\nproperty float y\n"
                             "property float z\nelement tristrips 2\n"
                             "property list int int vertex_indices\n";
  const std::string rows = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 1 0\n";
  const Polygons mesh = read(with_header(header, rows + "8 0 1 2 3 -1 1 4 3\n5 -1 2 -1 0 1\n"));
  CHECK(mesh.corners == std::vector<std::int32_t>{0, 1, 2, 2, 1, 3, 1, 4, 3});
  CHECK(mesh.ends == std::vector<std::size_t>{3, 6, 9});
}

TEST_CASE("counts of PLY must be what the file holds") {
  CHECK(error(with_header(kVertices + kFaces, kRows + "3 0 1 2\n")) == "no error");
  CHECK(error(with_header(kVertices + kFaces, kRows)) ==
        "m.ply:13:1: the file declares 1 rows of element face and holds 0 (it is cut off, or its "
        "header is wrong). Write the mesh again");
  CHECK(error(with_header(kVertices, "0 0 0\n1000000 1000000\n")) ==
        "m.ply:9:16: the line ends where a number should stand (something is missing). Write the "
        "mesh again");
  CHECK(error(with_header(kVertices, "0 0 0\n1000.5 1000.5 1000.5\n")) ==
        "m.ply:10:1: the file declares 3 rows of element vertex and holds 2 (it is cut off, or its "
        "header is wrong). Write the mesh again");
  CHECK(error(with_header(kVertices, kRows + "5 5 5\n")) ==
        "m.ply:11:1: the file goes on after its last element (the header declares no more). Write "
        "the mesh again");
  CHECK(error(with_header(kVertices, "0 0 0\n1 0 0 7\n0 1 0\n")) ==
        "m.ply:9:7: \"7\" is more than belongs here (the line holds more values than its element "
        "has). Write the mesh again");
  // Nothing is allocated for what cannot be there.
  CHECK(error(with_header("element vertex 2000000000\nproperty float x\nproperty float y\n"
                          "property float z\n",
                          kRows))
            .find("declares 2000000000 rows of element vertex and holds fewer") !=
        std::string::npos);
  CHECK(error(with_header("element vertex 9000000000\nproperty float x\nproperty float y\n"
                          "property float z\n",
                          kRows)) ==
        "m.ply: it declares 9000000000 vertices (a mesh can hold no more than 2147483647). Write "
        "the mesh again");
  CHECK(
      error(with_header(kVertices + kFaces, kRows + "200 0 1 2\n")) ==
      "m.ply:13:1: a list declares 200 values and the file holds fewer (it is cut off, or damaged "
      "here). Write the mesh again");
}

TEST_CASE("errors in PLY name the place") {
  const auto fails = [](const std::string& bytes, const std::string& begin) {
    const std::string message = error(bytes);
    INFO(message);
    CHECK(message.starts_with(begin));
  };
  fails("", "m.ply:1:1: this is no PLY file");
  fails("plyx\n", "m.ply:1:1: this is no PLY file");
  fails("ply\n", "m.ply:2:1: the file ends within its header");
  fails("ply\nformat binary 1.0\n", "m.ply:2:8: \"binary\" is no format of PLY (these are: ascii,");
  fails("ply\nformat ascii 2.0\n", "m.ply:2:14: \"2.0\" is no version of PLY");
  fails("ply\nend_header\n", "m.ply:2:1: the header names no format");
  fails(with_header("property float x\n", ""), "m.ply:3:1: a property stands before");
  fails(with_header("element vertex -1\n", ""), "m.ply:3:16: \"-1\" is no number of elements");
  fails(with_header("element vertex many\n", ""), "m.ply:3:16: \"many\" is not how many");
  fails(with_header("element vertex 1\nproperty quad x\n", ""), "m.ply:4:10: \"quad\" is no type");
  fails(with_header("element a 1\nproperty list float int x\n", ""),
        "m.ply:4:15: \"float\" is no type of a length");
  fails(with_header("colour\n", ""), "m.ply:3:1: \"colour\" is no keyword of a header");
  fails(with_header(kFaces, ""), "m.ply: it has no vertices");
  fails(with_header(kVertices + kVertices, ""), "m.ply: its header declares vertices twice");
  fails(with_header("element vertex 1\nproperty float x\nproperty float y\n", ""),
        "m.ply: its vertices have no coordinate z");
  fails(with_header(kVertices + "element face 1\nproperty int vertex_indices\n", ""),
        "m.ply: its element face has no corners");
  fails(
      with_header(kVertices + kFaces, kRows + "3 0 1 3\n"),
      "m.ply:13:7: a face has vertex 3 for a corner (there are 3 vertices, and they count from 0)");
  fails(with_header(kVertices + kFaces, kRows + "3 0 1 -1\n"), "m.ply:13:7: a face has vertex -1");
  fails(with_header(kVertices + kFaces, kRows + "256 0 1 2\n"),
        "m.ply:13:1: \"256\" is out of range (its type goes from 0 to 255)");
  fails(with_header(kVertices, "0 0 inf\n1 0 0\n0 1 0\n"), "m.ply:8:5: \"inf\" is not a number");
  Writer bytes{Form::little};
  for (const double x : {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0})
    bytes.raw(static_cast<float>(x));
  const std::string header =
      "ply\nformat binary_little_endian 1.0\n" + kVertices + kFaces + "end_header\n";
  Writer face{Form::little};
  face.raw(std::uint8_t{3});
  for (const int i : {0, 1, 7})
    face.raw(i);
  const auto at = [&](std::size_t offset) {
    return fmt::format("m.ply: at byte {}, ", header.size() + offset);
  };
  fails(header + bytes.bytes + face.bytes, at(45) + "a face has vertex 7 for a corner");
  fails(header + bytes.bytes + face.bytes.substr(0, 9), at(36) + "a list declares 3 values");
  fails(header + bytes.bytes.substr(0, 30),
        at(0) + "the file declares 3 rows of element vertex and holds fewer");
  Writer nan = bytes;
  const float not_a_number = std::nanf("");
  std::memcpy(nan.bytes.data() + 16, &not_a_number, 4);
  fails(header + nan.bytes, at(16) + "a coordinate is no finite number");
}
