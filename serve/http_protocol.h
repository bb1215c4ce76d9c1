#pragma once

#include <string>

#include "serve/http_server.h"
#include "serve/protocol.h"

namespace unietp {

/// The protocol over HTTP and WebSocket: `POST /v1/METHOD` with the parameters as body, `GET /` for the page, and
/// messages over the WebSocket, each of whose connections has one session. `protocol` must outlive the server.
HttpService http_service(Protocol& protocol, std::string page);

}  // namespace unietp
