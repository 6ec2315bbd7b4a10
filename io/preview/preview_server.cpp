#include "io/preview/preview_server.h"

#include "core/scene/user_error.h"
#include "io/preview/preview_answers.h"
#include "io/text/numbers.h"

#include <fmt/format.h>

#ifdef ABBE_HTTPLIB
#include <httplib.h>

#include <random>
#include <set>
#include <thread>

namespace abbe {
namespace {

/// 128 bits that nobody guesses.
std::string new_token() {
  std::random_device random; // the system's generator for secrets
  std::string token;
  for (int i = 0; i < 4; ++i)
    token += fmt::format("{:08x}", random());
  return token;
}

/// What a page from elsewhere may not have, and what a browser may do with ours.
void guard(httplib::Response& response) {
  response.set_header("Cache-Control", "no-store");
  response.set_header("Cross-Origin-Resource-Policy", "same-origin");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("X-Frame-Options", "DENY");
}

void refuse(httplib::Response& response, int status, const char* reason) {
  response.status = status;
  guard(response);
  response.set_content(reason, "text/plain");
}

} // namespace

struct PreviewServer::Impl {
  explicit Impl(PreviewBoard& shown) : board(shown) {}

  /// True for a request that the page of this server made, or a user who knows its address.
  [[nodiscard]] bool is_ours(const httplib::Request& request) const {
    const std::string host = request.get_header_value("Host");
    if (!hosts.contains(host)) return false;
    const std::string origin = request.get_header_value("Origin");
    return (origin.empty() || origin == "http://" + host) &&
           request.get_header_value_count("Host") == 1 &&
           request.get_header_value_count("Origin") <= 1;
  }
  void answer(const httplib::Request& request, httplib::Response& response);

  PreviewBoard& board;
  std::string token = new_token();
  std::set<std::string> hosts;
  int port = 0;
  httplib::Server server;
  std::jthread thread;
};

void PreviewServer::Impl::answer(const httplib::Request& request, httplib::Response& response) {
  if (!is_ours(request)) return refuse(response, 403, "This preview answers its own page only.\n");
  const std::string root = "/" + token + "/";
  if (!request.path.starts_with(root))
    return refuse(response, 404, "There is nothing under this address.\n");
  const std::string what = request.path.substr(root.size());
  guard(response);
  if (what.empty() && request.method == "GET") {
    response.set_content(preview_page(), "text/html; charset=utf-8");
  } else if (what == "status" && request.method == "GET") {
    const int seen = static_cast<int>(parse_whole(request.get_param_value("seen")).value_or(-1));
    response.set_content(status_json(board.news(seen)), "application/json");
  } else if (what == "picture" && request.method == "GET") {
    const PreviewBoard::News news = board.news(-1);
    if (!news.picture) return refuse(response, 404, "There is no picture yet.\n");
    response.set_content(picture_bytes(*news.picture), "application/octet-stream");
  } else if (what == "wish" && request.method == "POST") {
    try {
      wish_by_names(board, {request.params.begin(), request.params.end()});
      response.set_content("{}", "application/json");
    } catch (const UserError& error) {
      refuse(response, 400, error.what());
    }
  } else {
    refuse(response, 404, "There is nothing under this address.\n");
  }
}

PreviewServer::PreviewServer(PreviewBoard& board, int port) : impl_(std::make_unique<Impl>(board)) {
  httplib::Server& server = impl_->server;
  constexpr std::size_t kThreads = 32, kMostBytes = 4096;
  server.new_task_queue = [] { return new httplib::ThreadPool(kThreads); }; // NOLINT: the server's
  server.set_payload_max_length(kMostBytes);
  server.set_keep_alive_timeout(2);
  server.set_read_timeout(5);
  server.set_write_timeout(5);
  // Before all else, so that no way of asking goes around it.
  server.set_pre_routing_handler(
      [this](const httplib::Request& request, httplib::Response& response) {
        impl_->answer(request, response);
        return httplib::Server::HandlerResponse::Handled;
      });
  const char* const loopback = "127.0.0.1";
  if (port == 0)
    impl_->port = server.bind_to_any_port(loopback);
  else
    impl_->port = server.bind_to_port(loopback, port) ? port : -1;
  if (impl_->port <= 0)
    throw UserError(fmt::format("the port {} of {} cannot be had. Leave out --port, or give a free "
                                "one",
                                port, loopback));
  for (const char* name : {loopback, "localhost"})
    impl_->hosts.insert(fmt::format("{}:{}", name, impl_->port));
  impl_->thread = std::jthread([this] { impl_->server.listen_after_bind(); });
  while (!server.is_running()) // before it runs, it cannot be stopped
    std::this_thread::yield();
}

PreviewServer::~PreviewServer() {
  impl_->server.stop();
}

std::string PreviewServer::address() const {
  return fmt::format("http://127.0.0.1:{}/{}/", impl_->port, impl_->token);
}

} // namespace abbe

#else

namespace abbe {

struct PreviewServer::Impl {};

PreviewServer::PreviewServer(PreviewBoard&, int) {
  throw UserError("this program was built without cpp-httplib, which preview needs. Install "
                  "libcpp-httplib-dev, run cmake in the build folder again, and build");
}
PreviewServer::~PreviewServer() = default;
std::string PreviewServer::address() const {
  return "";
}

} // namespace abbe

#endif
