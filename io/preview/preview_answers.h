#pragma once

#include "io/preview/preview_board.h"

#include <map>
#include <string>

namespace abbe {

// What the server of a preview answers, without the protocol by which it is asked.

/// The page.
[[nodiscard]] std::string preview_page();

/// How the preview goes, as JSON.
[[nodiscard]] std::string status_json(const PreviewBoard::News& news);

/// The picture as bytes: eight whole numbers of 32 bits (its number; the width and height of the
/// frame; left, top, right and bottom of the part that it holds; its channels), then its values as
/// floats; all little-endian.
[[nodiscard]] std::string picture_bytes(const PreviewPicture& picture);

/// Changes what is wished as a page asks for, by names and values. Throws UserError for what cannot
/// be wished.
void wish_by_names(PreviewBoard& board, const std::map<std::string, std::string>& values);

} // namespace abbe
