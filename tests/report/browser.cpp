#include "browser.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <stdexcept>

namespace unietp::test {
namespace {

namespace fs = std::filesystem;
constexpr const char* kProgram = "/usr/bin/chromium";
constexpr int kPatience_ms = 60'000;

struct Pipe {
  int ends[2] = {-1, -1};
  Pipe() {
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  }
};

}  // namespace

bool Browser::installed() { return ::access(kProgram, X_OK) == 0; }

Browser::Browser(const fs::path& folder) : folder_(folder) {
  Pipe commands, answers;
  const std::string profile = "--user-data-dir=" + (folder / "profile").string();
  process_ = ::fork();
  if (process_ == 0) {
    // Descriptors 3 and 4 are what Chromium reads and writes; those below are out of the way of both.
    const int in = ::fcntl(commands.ends[0], F_DUPFD, 10), out = ::fcntl(answers.ends[1], F_DUPFD, 10);
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int stream : {0, 1, 2}) ::dup2(nowhere, stream);
    ::dup2(in, 3);
    ::dup2(out, 4);
    ::execl(kProgram, kProgram, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
            "--remote-debugging-pipe", profile.c_str(), "about:blank", nullptr);
    ::_exit(127);
  }
  ::close(commands.ends[0]);
  ::close(answers.ends[1]);
  to_ = commands.ends[1];
  from_ = answers.ends[0];
  const auto target = call("Target.createTarget", {{"url", "about:blank"}}, false);
  session_ = call("Target.attachToTarget", {{"targetId", target["targetId"]}, {"flatten", true}}, false)["sessionId"];
  call("Browser.setDownloadBehavior",
       {{"behavior", "allow"}, {"downloadPath", folder.string()}, {"eventsEnabled", true}}, false);
  for (const char* domain : {"Page.enable", "Runtime.enable", "Network.enable", "Log.enable"})
    call(domain, Json::object());
}

Browser::~Browser() {
  ::close(to_);
  ::close(from_);
  if (process_ <= 0) return;
  ::kill(process_, SIGTERM);
  ::waitpid(process_, nullptr, 0);
}

Browser::Json Browser::read() {
  while (unread_.find('\0') == std::string::npos) {
    pollfd ready{from_, POLLIN, 0};
    if (::poll(&ready, 1, kPatience_ms) <= 0) throw std::runtime_error("Chromium does not answer");
    char buffer[1 << 16];
    const auto size = ::read(from_, buffer, sizeof buffer);
    if (size <= 0) throw std::runtime_error("Chromium has ended");
    unread_.append(buffer, static_cast<std::size_t>(size));
  }
  const auto end = unread_.find('\0');
  const auto message = Json::parse(unread_.substr(0, end));
  unread_.erase(0, end + 1);
  return message;
}

void Browser::note(const Json& event) {
  const auto method = event.value("method", "");
  if (method == "Network.requestWillBeSent") {
    const auto url = event["params"]["request"]["url"].get<std::string>();
    if (url != page_ && !url.starts_with("data:") && !url.starts_with("blob:")) fetched.push_back(url);
  } else if (method == "Runtime.exceptionThrown") {
    complaints.push_back(event["params"]["exceptionDetails"].dump());
  } else if (method == "Log.entryAdded" && event["params"]["entry"]["level"] == "error") {
    complaints.push_back(event["params"]["entry"]["text"]);
  } else if (method == "Browser.downloadWillBegin") {
    saved_ = event["params"]["suggestedFilename"];
  } else if (method == "Browser.downloadProgress" && event["params"]["state"] == "completed") {
    is_saved_ = true;
  }
}

Browser::Json Browser::call(const std::string& method, Json parameters, bool of_page) {
  Json command{{"id", ++last_}, {"method", method}, {"params", std::move(parameters)}};
  if (of_page) command["sessionId"] = session_;
  const std::string text = command.dump() + '\0';
  for (std::size_t sent = 0; sent < text.size();) {
    const auto size = ::write(to_, text.data() + sent, text.size() - sent);
    if (size <= 0) throw std::runtime_error("Chromium does not listen");
    sent += static_cast<std::size_t>(size);
  }
  while (true) {
    auto message = read();
    if (message.value("id", 0) != last_) {
      note(message);
      continue;
    }
    if (message.contains("error")) throw std::runtime_error(method + ": " + message["error"].dump());
    return message["result"];
  }
}

void Browser::open(const fs::path& page) { visit("file://" + fs::absolute(page).string()); }

void Browser::visit(const std::string& url) {
  page_ = url;
  call("Page.navigate", {{"url", page_}});
  until("location.href === " + Json(page_).dump() + " && document.documentElement.dataset.ready === 'yes'");
}

Browser::Json Browser::evaluate(const std::string& expression) {
  const auto result =
      call("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
  if (result.contains("exceptionDetails")) throw std::runtime_error(result["exceptionDetails"].dump());
  return result["result"].value("value", Json());
}

void Browser::until(const std::string& expression) {
  // Asked for in the page itself; a navigation takes the promise with it, so a short one is made again.
  for (int tries = 0; tries < 200; ++tries) {
    try {
      const bool holds = evaluate("new Promise(tell => { let left = 30; const look = () => { if (" + expression +
                                  ") tell(true); else if (--left < 0) tell(false); else setTimeout(look, 10); }; "
                                  "look(); })")
                             .get<bool>();
      if (holds) return;
    } catch (const std::runtime_error&) {
      if (tries == 199) throw;
    }
  }
  throw std::runtime_error("never true in the page: " + expression);
}

void Browser::press(const std::string& key, bool control) {
  static const std::map<std::string, int> kCodes{{"Enter", 13}, {"Escape", 27}, {"ArrowLeft", 37}, {"ArrowRight", 39}};
  const auto named = kCodes.find(key);
  Json event{{"type", "keyDown"}, {"key", key}, {"modifiers", control ? 2 : 0}};
  if (named != kCodes.end()) event["windowsVirtualKeyCode"] = named->second;
  if (named == kCodes.end() && !control) event["text"] = key;
  call("Input.dispatchKeyEvent", event);
  event["type"] = "keyUp";
  event.erase("text");
  call("Input.dispatchKeyEvent", event);
}

void Browser::type(const std::string& text) { call("Input.insertText", {{"text", text}}); }

std::string Browser::saved_file() {
  while (!is_saved_) note(read());
  is_saved_ = false;
  return (folder_ / saved_).string();
}

}  // namespace unietp::test
