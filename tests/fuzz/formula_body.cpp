#include "fuzz_formula_body.h"

#include "bodies.h"

namespace unietp::fuzz {

bool sexpr_body(std::string_view text) { return read_sexprs_body(text); }
bool formula_body(std::string_view text) { return parse_formula_body(text); }

}  // namespace unietp::fuzz
