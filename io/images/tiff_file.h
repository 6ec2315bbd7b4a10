#pragma once

#include <tiffio.h>

#include <array>
#include <filesystem>
#include <memory>

namespace abbe {

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
/// An open TIFF file.
using TiffFile = std::unique_ptr<TIFF, CloseTiff>;

/// The first error of a file; a plain array, since nothing may throw through libtiff.
struct FirstTiffError {
  std::array<char, 256> text{};
};
/// Throws std::runtime_error with that error.
[[noreturn]] void throw_first(const FirstTiffError& error);

/// Opens a file in a mode of libtiff's. `error` gets what goes wrong and lives as long as the file;
/// nothing goes to stderr, and warnings are dropped. Throws std::runtime_error, std::bad_alloc.
[[nodiscard]] TiffFile open_tiff(const std::filesystem::path& path, const char* mode,
                                 FirstTiffError& error);

} // namespace abbe
