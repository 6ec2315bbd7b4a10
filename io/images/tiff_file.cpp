#include "io/images/tiff_file.h"

#include <cstdarg>
#include <cstdio>
#include <new>
#include <stdexcept>

namespace abbe {
namespace {

struct FreeOptions {
  void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};
using Options = std::unique_ptr<TIFFOpenOptions, FreeOptions>;

extern "C" {
static int keep_first_error(TIFF*, void* user_data, const char*, const char* format,
                            va_list arguments) {
  auto& text = static_cast<FirstTiffError*>(user_data)->text;
  if (text[0] == '\0') std::vsnprintf(text.data(), text.size(), format, arguments);
  return 1; // handled: nothing goes to stderr
}
static int ignore_warning(TIFF*, void*, const char*, const char*, va_list) {
  return 1;
}
}

} // namespace

void throw_first(const FirstTiffError& error) {
  throw std::runtime_error(error.text[0] != '\0' ? error.text.data() : "libtiff failed");
}

TiffFile open_tiff(const std::filesystem::path& path, const char* mode, FirstTiffError& error) {
  const Options options(TIFFOpenOptionsAlloc());
  if (!options) throw std::bad_alloc();
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_first_error, &error);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_warning, nullptr);
  TiffFile tiff(TIFFOpenExt(path.c_str(), mode, options.get()));
  if (!tiff) throw_first(error);
  return tiff;
}

} // namespace abbe
