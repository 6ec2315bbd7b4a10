#pragma once

#include <filesystem>
#include <functional>

namespace abbe {

/// Writes a file so that its old content is kept until the new content is complete.
///
/// `write` gets the name of an empty file that no other process uses, under which it may open and
/// fill it. When it returns, that file is flushed to the disk and takes the name of `target` in one
/// step. When anything fails, or the process ends, nothing is left of it and `target` stays as it
/// was. Only where the file system has no unnamed files, a process that is ended other than by a
/// signal of `interrupted` (io/console/interrupt.h) leaves a file `.abbe-HOST-....tmp`, which the
/// next one that writes into the folder from the same machine removes. A target that is a symbolic
/// link stays one; the file it points to is replaced, and keeps its permissions. One that has
/// several names (hard links) is filled anew in its place, so that it keeps them; that is not one
/// step.
///
/// Errors: `std::runtime_error` "cannot write TARGET: REASON", where the reason is the system's or
/// the text of the exception that `write` threw.
void replace_file(const std::filesystem::path& target,
                  const std::function<void(const std::filesystem::path& temporary)>& write);

/// Finds what would make `replace_file` fail, before the work whose result it is to write: a folder
/// that is missing or cannot be written to, a name that is too long, a file that is read-only, a
/// link that leads nowhere, a pipe, a device. Throws like it; changes nothing.
void require_replaceable(const std::filesystem::path& target);

} // namespace abbe
