#include "python/native/json_to_python.h"

#include <nlohmann/json.hpp>

namespace nb = nanobind;

namespace unietp::python {

nb::object text_to_python(std::string_view text) {
  PyObject* made = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
  if (made == nullptr) nb::raise_python_error();
  return nb::steal(made);
}

nb::object to_python(const nlohmann::ordered_json& json) {
  using Type = nlohmann::ordered_json::value_t;
  switch (json.type()) {
    case Type::boolean:
      return nb::bool_(json.get<bool>());
    case Type::number_integer:
      return nb::int_(json.get<std::int64_t>());
    case Type::number_unsigned:
      return nb::int_(json.get<std::uint64_t>());
    case Type::number_float:
      return nb::float_(json.get<double>());
    case Type::string:
      return text_to_python(json.get_ref<const std::string&>());
    case Type::array: {
      nb::list list;
      for (const auto& value : json) list.append(to_python(value));
      return list;
    }
    case Type::object: {
      nb::dict dict;
      for (const auto& [name, value] : json.items()) dict[text_to_python(name)] = to_python(value);
      return dict;
    }
    default:
      return nb::none();
  }
}

}  // namespace unietp::python
