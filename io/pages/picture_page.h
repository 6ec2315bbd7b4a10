#pragma once

#include <filesystem>
#include <vector>

namespace abbe {

/// What a page of pictures came to.
struct PageSummary {
  std::size_t pictures = 0;
  std::uintmax_t bytes = 0;
  double band_error = 0.0; ///< the largest error of a band's value, as a part of its pixel's range;
                           ///< 0 where no picture has bands
};

/// Writes one HTML page that shows pictures and tells their colours and spectra. It needs no other
/// file. Throws UserError for a picture that cannot be read, and std::runtime_error where the page
/// cannot be written.
PageSummary write_picture_page(const std::filesystem::path& page,
                               const std::vector<std::filesystem::path>& pictures);

} // namespace abbe
