#pragma once

#include "io/preview/preview_board.h"

#include <memory>
#include <string>

namespace abbe {

/// Serves a preview's page on this machine's loopback address, in threads of its own.
///
/// Whoever asks must know the token in the address, and must have it from this machine: a request
/// whose Host is another name, as one that a foreign page leads here by its own name server would
/// have, and one whose Origin is another page are refused. Nothing but the page, what the board has
/// and what it takes is served: no file.
class PreviewServer {
public:
  /// `port` 0: any that is free. Throws UserError where the port cannot be had, or the program was
  /// built without a library to serve with.
  PreviewServer(PreviewBoard& board, int port);
  ~PreviewServer();
  PreviewServer(const PreviewServer&) = delete;
  PreviewServer& operator=(const PreviewServer&) = delete;

  /// Where the page is, with its token.
  [[nodiscard]] std::string address() const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace abbe
