#include "io/states/block_file.h"

#include "io/files/checksum.h"
#include "io/files/regular_file.h"
#include "io/states/value_bytes.h"
#include "io/text/read_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <system_error>

namespace abbe {
namespace {

namespace fs = std::filesystem;

/// As that of PNG: its first byte is no text, and the others show what a transfer as text changes.
constexpr std::string_view kSignature = "\x89"
                                        "ABBE\r\n\x1a";
constexpr std::string_view kLastBlock = "LAST";
constexpr std::size_t kNameLength = 4;

std::uint32_t checksum_of(std::string_view head, std::string_view content) {
  return Checksum().add(head).add(content).value();
}

template <class Number>
std::string bytes_of(Number number) {
  ValueWriter writer;
  writer.put(number);
  return writer.bytes();
}

} // namespace

BlockWriter::BlockWriter(const fs::path& file) : file_(file, std::ios::binary) {
  put(kSignature);
  put(bytes_of(kStateVersion));
}

void BlockWriter::put(std::string_view bytes) {
  errno = 0;
  file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!file_) throw std::runtime_error(std::generic_category().message(errno != 0 ? errno : EIO));
}

void BlockWriter::write(std::string_view name, std::string_view content) {
  assert(name.size() == kNameLength);
  const std::string head = std::string(name) + bytes_of(std::uint64_t{content.size()});
  put(head);
  put(content);
  put(bytes_of(checksum_of(head, content)));
  ++blocks_;
}

void BlockWriter::end() {
  write(kLastBlock, bytes_of(blocks_));
  errno = 0;
  file_.close();
  if (!file_) throw std::runtime_error(std::generic_category().message(errno != 0 ? errno : EIO));
}

BlockReader::BlockReader(const fs::path& file) : path_(file) {
  try {
    require_regular_file(file);
  } catch (const std::runtime_error& error) {
    throw ReadError(file, "this state cannot be read", error.what(), "Name the file of a state");
  }
  errno = 0;
  file_.open(file, std::ios::binary);
  if (!file_)
    throw ReadError(file, "this state cannot be read",
                    std::generic_category().message(errno != 0 ? errno : EIO),
                    "Name a file that can be opened");
  size_ = fs::file_size(file);
  const std::string start = take(std::min<std::uint64_t>(size_, kSignature.size()));
  if (start.empty() || !kSignature.starts_with(start))
    throw ReadError(file, "this is not the state of a rendering", "it begins otherwise",
                    "Name a file that --checkpoint or --part has written");
  if (size_ < kSignature.size() + sizeof kStateVersion)
    refuse(fmt::format("it has {} bytes only: it is incomplete", size_));
  const auto version = ValueReader(take(sizeof kStateVersion)).get<std::uint32_t>();
  if (version != kStateVersion)
    throw ReadError(file, fmt::format("this state has version {}", version),
                    fmt::format("this program reads version {}", kStateVersion),
                    "Go on with the program that has written it");
}

void BlockReader::refuse(const std::string& reason) const {
  throw ReadError(path_, "this state cannot be used", reason,
                  "Take an older one, or render it again");
}

void BlockReader::take(std::uint64_t size, std::string& bytes) {
  if (size > size_ - position_)
    refuse(fmt::format("it ends after {} bytes, within block {}: it is incomplete", size_,
                       blocks_ + 1));
  bytes.resize(size);
  file_.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!file_) refuse("it could not be read to its end");
  position_ += size;
}

std::string BlockReader::take(std::uint64_t size) {
  std::string bytes;
  take(size, bytes);
  return bytes;
}

const std::string& BlockReader::read(std::string_view name) {
  const std::string head = take(kNameLength + sizeof(std::uint64_t));
  const auto size = ValueReader(std::string_view(head).substr(kNameLength)).get<std::uint64_t>();
  take(size, content_);
  const std::string sum = take(sizeof(std::uint32_t));
  if (ValueReader(sum).get<std::uint32_t>() != checksum_of(head, content_))
    refuse(
        fmt::format("the checksum of block {} is wrong: the file has been damaged", blocks_ + 1));
  name_ = head.substr(0, kNameLength);
  if (name_ != name) refuse(fmt::format("block {} is not {}", blocks_ + 1, name));
  ++blocks_;
  return content_;
}

void BlockReader::end() {
  const std::uint64_t before = blocks_;
  if (ValueReader(read(kLastBlock)).get<std::uint64_t>() != before)
    refuse("it has not as many blocks as it should have");
  if (position_ != size_) refuse("something follows its last block");
}

bool is_state_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string start(kSignature.size(), '\0');
  stream.read(start.data(), static_cast<std::streamsize>(start.size()));
  return stream && start == kSignature;
}

} // namespace abbe
