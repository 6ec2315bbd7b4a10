#pragma once

#include <filesystem>
#include <functional>

namespace abbe {

/// Writes a file so that its old content is kept until the new content is complete.
///
/// `write` gets the name of an empty file in the folder of `target`, with the same extension, that
/// no other process uses. When it returns, that file is flushed to the disk and renamed to `target`
/// in one step. When anything fails the temporary is removed and `target` stays as it was. A target
/// that is a symbolic link stays one; the file it points to is replaced.
///
/// Errors: `std::runtime_error` "cannot write TARGET: REASON", where the reason is the system's or
/// the text of the exception that `write` threw.
void replace_file(const std::filesystem::path& target,
                  const std::function<void(const std::filesystem::path& temporary)>& write);

} // namespace abbe
