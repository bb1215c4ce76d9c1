"""Finds the places of a C++ source file where a mutant can be planted.

A site is an expression or statement inside the body of a function, with the text that is to stand there when the mutant
is switched on. libclang gives the syntax tree, so what belongs to an operator and of which type it is are known, not
guessed. What must be constant for the compiler, what a macro makes and constexpr functions are left alone.
"""

import re
from dataclasses import dataclass

from clang import cindex
from clang.cindex import CursorKind, TypeKind

# The kinds of mutation. They were fixed before the first run; docs/mutants.md says what each does.
KINDS = ("comparison", "equality", "logic", "arithmetic", "constant", "condition", "removal", "default", "boolean",
         "bound")

NEIGHBOR = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
OPPOSITE = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}  # for reals, where equality is a matter of rounding
SWAPPED = {"+": "-", "-": "+", "+=": "-=", "-=": "+="}
FUNCTIONS = {CursorKind.FUNCTION_DECL, CursorKind.CXX_METHOD, CursorKind.CONSTRUCTOR, CursorKind.DESTRUCTOR,
             CursorKind.CONVERSION_FUNCTION, CursorKind.FUNCTION_TEMPLATE}
INTEGERS = {TypeKind.INT, TypeKind.UINT, TypeKind.LONG, TypeKind.ULONG, TypeKind.LONGLONG, TypeKind.ULONGLONG,
            TypeKind.SHORT, TypeKind.USHORT, TypeKind.CHAR_S, TypeKind.SCHAR, TypeKind.UCHAR}
REALS = {TypeKind.FLOAT, TypeKind.DOUBLE}
EMPTY_VALUES = re.compile(r"(std::)?(vector|__cxx11::basic_string|basic_string|basic_string_view|optional|set|map)<")
LITERAL = re.compile(r"-?[\d.]+[fuUlL]*|true|false|\{\}|\"\"|std::nullopt|nullptr|std::string\(\)")
# Only speed depends on these.
NO_EFFECT = {"reserve", "shrink_to_fit"}


@dataclass(frozen=True)
class Site:
    """Bytes [start, end) of a file become `text`, in which {on} stands for "this mutant is switched on"."""
    kind: str
    start: int
    end: int
    line: int
    last_line: int
    original: str
    mutated: str
    text: str


class Finder:
    """Collects the sites of one file."""

    def __init__(self, path, arguments):
        self.unit = cindex.Index.create().parse(
            path, arguments, options=cindex.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD)
        errors = [str(found) for found in self.unit.diagnostics if found.severity >= cindex.Diagnostic.Error]
        if errors:
            raise RuntimeError(f"{path} does not compile: {errors[0]}")
        self.path = path
        with open(path, "rb") as file:
            self.bytes = file.read()
        self.sites = []
        self.macros = []

    def find(self):
        own = [cursor for cursor in self.unit.cursor.get_children()
               if cursor.location.file is not None and cursor.location.file.name == self.path]
        self.macros = [extent(cursor) for cursor in own if cursor.kind == CursorKind.MACRO_INSTANTIATION]
        for cursor in own:
            self.declaration(cursor)
        return sorted(set(self.sites), key=lambda site: (site.start, site.end, site.kind))

    def declaration(self, cursor):
        """Goes through namespaces and classes down to the bodies of functions."""
        if cursor.kind in FUNCTIONS:
            body = next((child for child in cursor.get_children() if child.kind == CursorKind.COMPOUND_STMT), None)
            if body is not None and "constexpr" not in self.between(cursor.extent.start.offset, extent(body)[0]):
                self.node(body, cursor.result_type)
        elif cursor.kind in (CursorKind.NAMESPACE, CursorKind.STRUCT_DECL, CursorKind.CLASS_DECL,
                             CursorKind.LINKAGE_SPEC, CursorKind.UNEXPOSED_DECL):
            for child in cursor.get_children():
                self.declaration(child)

    def node(self, cursor, returned):
        """`returned` is the type that the function returns; None inside a lambda."""
        kind = cursor.kind
        if kind in (CursorKind.CXX_UNARY_EXPR, CursorKind.STATIC_ASSERT, CursorKind.TYPE_ALIAS_DECL,
                    CursorKind.STRUCT_DECL, CursorKind.ENUM_DECL) or self.in_macro(cursor):
            return
        children = list(cursor.get_children())
        if kind == CursorKind.DECL_STMT and re.match(r"(static\s+)?constexpr\b", self.text(cursor)):
            return
        if kind == CursorKind.LAMBDA_EXPR:
            for child in children:
                if child.kind == CursorKind.COMPOUND_STMT:
                    self.node(child, None)
            return
        if kind == CursorKind.CASE_STMT:
            children = children[1:]
        self.expression(cursor, children)
        self.statements(cursor, children, returned)
        for child in children:
            if child.kind == CursorKind.INTEGER_LITERAL:
                self.constant(child, cursor)
            self.node(child, returned)

    def expression(self, cursor, children):
        kind = cursor.kind
        if kind == CursorKind.BINARY_OPERATOR and len(children) == 2:
            self.binary(cursor, *children)
        elif kind == CursorKind.COMPOUND_ASSIGNMENT_OPERATOR and len(children) == 2:
            operator = self.operator(*children)
            if operator in SWAPPED and canonical(children[0]) in INTEGERS | REALS:
                self.add("arithmetic", cursor, self.joined(children, SWAPPED[operator]))
        elif kind == CursorKind.CALL_EXPR and cursor.spelling in ("operator==", "operator!="):
            self.add("equality", cursor, f"!({self.text(cursor)})")
        elif kind == CursorKind.CXX_BOOL_LITERAL_EXPR:
            value = self.text(cursor)
            if value in ("true", "false"):
                other = "false" if value == "true" else "true"
                self.add("boolean", cursor, other)
        elif kind == CursorKind.CONDITIONAL_OPERATOR:
            self.negated(children[0])

    def binary(self, cursor, left, right):
        operator = self.operator(left, right)
        both = {canonical(left), canonical(right)}
        if operator in NEIGHBOR and both <= INTEGERS:
            self.add("comparison", cursor, self.joined((left, right), NEIGHBOR[operator]))
        elif operator in OPPOSITE and both <= REALS:
            self.add("comparison", cursor, self.joined((left, right), OPPOSITE[operator]))
        elif operator in ("==", "!="):
            self.add("equality", cursor, self.joined((left, right), "!=" if operator == "==" else "=="))
        elif operator in ("&&", "||"):
            # Spelled as a condition each, since only conditions convert by an explicit operator bool.
            other = "||" if operator == "&&" else "&&"
            original = self.text(cursor)
            self.add("logic", cursor, self.joined((left, right), other), f"!!({original})")
        elif operator in SWAPPED and both <= INTEGERS | REALS:
            self.add("arithmetic", cursor, self.joined((left, right), SWAPPED[operator]))

    def statements(self, cursor, children, returned):
        kind = cursor.kind
        if kind == CursorKind.COMPOUND_STMT:
            for child in children:
                self.removed(child)
        elif kind in (CursorKind.FOR_STMT, CursorKind.CXX_FOR_RANGE_STMT, CursorKind.WHILE_STMT) and children:
            self.removed(children[-1])
            if kind == CursorKind.FOR_STMT:
                self.loop_bound(children[:-1])
        elif kind == CursorKind.IF_STMT and "constexpr" not in self.text(cursor).split("(")[0]:
            declares = any(child.kind in (CursorKind.VAR_DECL, CursorKind.DECL_STMT) for child in children)
            if not declares:
                self.negated(children[0])
                for child in children[1:]:
                    self.removed(child)
        if kind == CursorKind.WHILE_STMT and children and children[0].kind != CursorKind.VAR_DECL:
            self.negated(children[0])
        if kind == CursorKind.RETURN_STMT and children and returned is not None:
            self.default(cursor, children[0], returned)

    def loop_bound(self, head):
        for child in head:
            parts = list(child.get_children())
            if child.kind == CursorKind.BINARY_OPERATOR and len(parts) == 2 and canonical(parts[1]) in INTEGERS and \
                    self.operator(*parts) in NEIGHBOR:
                self.add("bound", parts[1], f"({self.text(parts[1])}) - 1")

    def negated(self, condition):
        text = self.text(condition)
        self.add("condition", condition, f"!({text})", f"!!({text})")

    def removed(self, statement):
        """A call whose result nobody uses, or an assignment."""
        inner = statement
        while inner.kind == CursorKind.UNEXPOSED_EXPR and len(parts := list(inner.get_children())) == 1:
            inner = parts[0]
        call = inner.kind == CursorKind.CALL_EXPR and inner.spelling not in NO_EFFECT
        assignment = inner.kind == CursorKind.COMPOUND_ASSIGNMENT_OPERATOR or (
            inner.kind == CursorKind.BINARY_OPERATOR and self.operator(*inner.get_children()) == "=")
        if call or assignment:
            self.add("removal", statement, "void()", f"void({self.text(statement)})")

    def default(self, statement, value, returned):
        resolved = returned.get_canonical()
        simple = resolved.kind in INTEGERS | REALS | {TypeKind.BOOL}
        if not simple and not EMPTY_VALUES.match(resolved.spelling):
            return
        text = self.text(value)
        end = self.bytes.find(b";", extent(statement)[1])
        if LITERAL.fullmatch(text) or self.between(extent(statement)[1], end).strip():
            return
        whole = self.between(extent(statement)[0], end + 1)
        self.add_bytes("default", extent(statement)[0], end + 1, statement, whole, "return {};",
                       "{{ if ({on}) return {{}}; " + braces(whole) + " }}")

    def constant(self, literal, parent):
        if parent.kind in (CursorKind.INIT_LIST_EXPR, CursorKind.ARRAY_SUBSCRIPT_EXPR, CursorKind.DECL_REF_EXPR,
                           CursorKind.MEMBER_REF_EXPR, CursorKind.TYPE_REF, CursorKind.TEMPLATE_REF,
                           CursorKind.OVERLOADED_DECL_REF):
            return
        start, end = extent(literal)
        match = re.fullmatch(r"(\d{1,6})([uUlL]*)", self.text(literal))
        before, after = self.bytes[:start].rstrip(), self.bytes[end:end + 1]
        if match is None or after == b">" or self.bytes[start - 1:start] in (b"<", b"[", b"{"):
            return
        if parent.kind == CursorKind.VAR_DECL and not before.endswith(b"="):
            return
        value = int(match[1])
        other = value + 1 if value < 2 or start % 2 else value - 1
        self.add("constant", literal, f"{other}{match[2]}")

    def joined(self, operands, operator):
        return f"{self.text(operands[0])} {operator} {self.text(operands[1])}"

    def operator(self, left=None, right=None):
        if left is None or right is None:
            return ""
        between = self.between(extent(left)[1], extent(right)[0])
        return between.strip()

    def add(self, kind, cursor, mutated, original=None):
        text = self.text(cursor)
        kept = braces(original if original is not None else text)
        self.add_bytes(kind, *extent(cursor), cursor, text, mutated,
                       "({on} ? (" + braces(one_line(mutated)) + ") : (" + kept + "))")

    def add_bytes(self, kind, start, end, cursor, original, mutated, text):
        if "//" in original or "\n#" in original or self.holds_macro(start, end) or len(original) > 600:
            return
        line = cursor.extent.start.line
        self.sites.append(Site(kind, start, end, line, line + original.count("\n"), one_line(original),
                               one_line(mutated), text))

    def in_macro(self, cursor):
        start, end = extent(cursor)
        return any(first <= start and end <= last for first, last in self.macros)

    def holds_macro(self, start, end):
        return any(first < end and start < last for first, last in self.macros)

    def between(self, start, end):
        return self.bytes[start:end].decode("utf-8")

    def text(self, cursor):
        return self.between(*extent(cursor))


def extent(cursor):
    return cursor.extent.start.offset, cursor.extent.end.offset


def canonical(cursor):
    return cursor.type.get_canonical().kind


def one_line(text):
    return re.sub(r"\s*\n\s*", " ", text)


def braces(text):
    """Escaped for str.format."""
    return text.replace("{", "{{").replace("}", "}}")


def sites_of(path, arguments):
    """All sites of the file at `path`, in the order of the file. Raises RuntimeError when it does not compile."""
    return Finder(path, arguments).find()
