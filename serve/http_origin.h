#pragma once

#include <optional>
#include <string>

namespace unietp {

/// Why a request may come from a web page of someone else; nullopt when it does not. `host`: the header Host, "" when
/// it is missing; `origin`: the header Origin, which browsers send with what a page asks for; `own`: the address that
/// the server listens at.
///  - Host must be an IP address, `localhost` or `own`, with or without a port: any other name may have been pointed at
///    this machine by a stranger (DNS rebinding).
///  - Origin, where there is one, must be `http://` and Host.
std::optional<std::string> foreign(const std::string& host, const std::optional<std::string>& origin,
                                   const std::string& own);

/// Whether an IP address is one that only this machine can reach.
bool is_loopback(const std::string& address);

}  // namespace unietp
