#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace abbe {

/// Tells when one of some files is saved, however the program that saves it does that: in its
/// place, or under another name that then becomes the file's.
class FileWatch {
public:
  /// Throws std::runtime_error where the system gives no more watches.
  FileWatch();
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  /// From now on these files are watched, and no others. One that is not there yet may come. Throws
  /// std::runtime_error where the system gives no more watches.
  void follow(const std::vector<std::filesystem::path>& files);

  /// Waits so long, and no longer than until one of them has been saved. True where one has.
  [[nodiscard]] bool wait(double seconds);

private:
  int queue_;
  std::mutex mutex_;                           ///< of the names
  std::map<int, std::set<std::string>> names_; ///< the files of each folder, by its watch
};

} // namespace abbe
