#pragma once

#include "serve/method_call.h"

namespace unietp {

// The methods that concern the episode of a session; docs/protocol.md says what each takes and answers.
MethodResult reset_method(const MethodCall& call);
MethodResult step_method(const MethodCall& call);
MethodResult observe_method(const MethodCall& call);
MethodResult text_method(const MethodCall& call);
MethodResult actions_method(const MethodCall& call);
MethodResult render_method(const MethodCall& call);
MethodResult state_method(const MethodCall& call);

}  // namespace unietp
