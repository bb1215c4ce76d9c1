#include "python/native/readable.h"

#include "environment/observation_tree.h"
#include "python/native/json_to_python.h"

namespace nb = nanobind;

namespace unietp::python {
namespace {

/// By the functions of Python itself: an observation has some hundreds of small dicts.
struct PythonMaker {
  using Value = nb::object;
  static nb::object text(const std::string& words) { return text_to_python(words); }
  static nb::object number(int number) { return taken(PyLong_FromLong(number)); }
  static nb::object real(double number) { return taken(PyFloat_FromDouble(number)); }
  static nb::object flag(bool flag) { return nb::bool_(flag); }
  static nb::object nothing() { return nb::none(); }
  static nb::object object() { return taken(PyDict_New()); }
  static nb::object list() { return taken(PyList_New(0)); }
  static void set(nb::object& object, const char* name, const nb::object& value) {
    const nb::object key = taken(PyUnicode_InternFromString(name));
    if (PyDict_SetItem(object.ptr(), key.ptr(), value.ptr()) != 0) nb::raise_python_error();
  }
  static void append(nb::object& list, const nb::object& value) {
    if (PyList_Append(list.ptr(), value.ptr()) != 0) nb::raise_python_error();
  }

 private:
  static nb::object taken(PyObject* made) {
    if (made == nullptr) nb::raise_python_error();
    return nb::steal(made);
  }
};

}  // namespace

nb::object readable(const Observation& observation, const Settings& settings) {
  return ObservationTree<PythonMaker>(observation, settings).value();
}

}  // namespace unietp::python
