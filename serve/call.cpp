#include "serve/call.h"

namespace unietp {

int http_status(CallFailure failure) {
  switch (failure) {
    case CallFailure::NotJson:
    case CallFailure::NotARequest:
    case CallFailure::WrongParameters:
      return 400;
    case CallFailure::NotAllowed:
      return 403;
    case CallFailure::UnknownMethod:
    case CallFailure::UnknownSession:
    case CallFailure::NoTask:
      return 404;
    case CallFailure::NotReset:
      return 409;
    case CallFailure::TooManySessions:
      return 429;
  }
  return 500;
}

}  // namespace unietp
