#pragma once

#include "io/text/name_index.h"
#include "io/text/read_arguments.h"
#include "io/text/token.h"
#include "spectral/curve.h"
#include "spectral/data_table.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace abbe {

/// A key of an entry, one row of a library's table.
template <class Entry>
struct LibraryKey {
  std::string_view usage; ///< the key and its arguments
  void (*read)(Entry&, Arguments&, const Warn&);
  bool required = false;
};

/// The words around an entry: `begin NAME { keys }`, then `end` or not.
struct LibraryWords {
  std::string_view begin;
  std::string_view end;
};

/// Reads 81 and the samples that follow, at 380, 385 ... 780 nm; or 41, 201 or 401 and values in
/// steps of 10, 2 or 1 nm, linear between them. Values after them are left out with a warning when
/// they are 0, beyond 780 nm; others are an error.
[[nodiscard]] Curve read_samples(Arguments& arguments, const Warn& warn);

/// Reads "begin NAME {" and returns the name; empty at the end of the file. `end` words before it
/// are passed over.
[[nodiscard]] std::optional<Token> read_entry_head(TokenReader& reader, const LibraryWords& words);

/// The row of the key that comes next; empty, with the brace read, where the entry closes. Usages
/// in `seen` have been read and are refused.
[[nodiscard]] std::optional<std::size_t> read_key(TokenReader& reader, const LibraryWords& words,
                                                  const std::vector<std::string_view>& usages,
                                                  const std::vector<bool>& seen);

/// The entry of this name, in upper or lower case; null when there is none.
template <class Entry>
[[nodiscard]] const Entry* find_entry(const std::vector<Entry>& entries, std::string_view name) {
  for (const Entry& entry : entries)
    if (same_name(entry.name, name)) return &entry;
  return nullptr;
}

[[nodiscard]] ReadError duplicate_entry(const Token& name);
[[nodiscard]] ReadError missing_key(const Token& name, std::string_view usage);

/// All entries of a library. `Entry` has a `name`, and `remarks` that keep what is warned of.
template <class Entry>
[[nodiscard]] std::vector<Entry>
read_library(std::string_view text, const std::string& file, const LibraryWords& words,
             std::span<const LibraryKey<Entry>> keys, const Warn& warn) {
  std::vector<std::string_view> usages;
  for (const auto& key : keys)
    usages.push_back(key.usage);

  TokenReader reader(text, file);
  std::vector<Entry> entries;
  NameIndex names;
  while (const auto name = read_entry_head(reader, words)) {
    Entry entry;
    entry.name = name->text;
    if constexpr (requires { entry.where; }) entry.where = name->where;
    std::vector<bool> seen(keys.size(), false);
    while (const auto row = read_key(reader, words, usages, seen)) {
      Arguments arguments(reader, reader.next(), keys[*row].usage);
      keys[*row].read(entry, arguments, [&](const std::string& message) {
        entry.remarks.push_back(message);
        if (warn) warn(message);
      });
      seen[*row] = true;
    }
    for (std::size_t row = 0; row < keys.size(); ++row)
      if (keys[row].required && !seen[row]) throw missing_key(*name, keys[row].usage);
    if (!names.add(entry.name, entries.size())) throw duplicate_entry(*name);
    entries.push_back(std::move(entry));
  }
  return entries;
}

} // namespace abbe
