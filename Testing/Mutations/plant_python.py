# SPDX-License-Identifier: BSD-3-Clause
"""Where a file of Python can be broken, and how."""

import ast
import re

COMPARISONS = {
    ast.Lt: ("<=", ">="), ast.LtE: ("<", ">"), ast.Gt: (">=", "<="), ast.GtE: (">", "<"),
    ast.Eq: ("!=",), ast.NotEq: ("==",), ast.Is: ("is not",), ast.IsNot: ("is",), ast.In: ("not in",),
    ast.NotIn: ("in",),
}  # fmt: skip
WRITTEN = r"(is\s+not|not\s+in|is|in|<=|>=|==|!=|<|>)"
ARITHMETIC = {
    ast.Add: "-", ast.Sub: "+", ast.Mult: "+", ast.Div: "*", ast.FloorDiv: "*", ast.BitOr: "&", ast.BitAnd: "|",
    ast.LShift: ">>", ast.RShift: "<<",
}  # fmt: skip


def sites(text):
    """(begin, end, replacement, kind, function) of each way to break it; begin and end count characters."""
    finder = Finder(text)
    finder.visit(ast.parse(text))
    return finder.found


def is_docstring(node):
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)


class Finder(ast.NodeVisitor):
    """Walks through executed code: no docstrings, no annotations, no code for type checkers alone."""

    def __init__(self, text):
        self.text = text
        self.found = []
        self.names = []  # of the classes and functions around
        self.starts = [0]
        self.lines = text.splitlines(keepends=True)
        for line in self.lines:
            self.starts.append(self.starts[-1] + len(line))

    def at(self, line, column):
        """ast counts bytes."""
        return self.starts[line - 1] + len(self.lines[line - 1].encode()[:column].decode())

    def span(self, node):
        return self.at(node.lineno, node.col_offset), self.at(node.end_lineno, node.end_col_offset)

    def source(self, node):
        begin, end = self.span(node)
        return self.text[begin:end]

    def add(self, span, replacement, kind):
        self.found.append((*span, replacement, kind, ".".join(self.names)))

    def add_between(self, left, right, pattern, replacement, kind):
        """Replaces the text between two nodes."""
        begin, end = self.span(left)[1], self.span(right)[0]
        if match := re.search(pattern, self.text[begin:end]):
            self.add((begin + match.start(), begin + match.end()), replacement, kind)

    # --- Statements -----------------------------------------------------------------------------

    def visit(self, node):
        if is_docstring(node) or isinstance(node, (ast.Import, ast.ImportFrom, ast.JoinedStr)):
            return
        if isinstance(node, ast.stmt) and len(self.names) > 0:
            self.statement(node)
        super().visit(node)

    def statement(self, node):
        """Faults of a whole statement of a function or a class."""
        if isinstance(node, (ast.Assign, ast.AugAssign, ast.Delete, ast.Raise, ast.Expr)):
            kind = "statement removed"
            targets = getattr(node, "targets", [getattr(node, "target", None)])
            if isinstance(node, ast.Raise):
                kind = "exception swallowed"
            elif any(isinstance(target, ast.Attribute) for target in targets):
                kind = "assignment to a member removed"
            self.add(self.span(node), "pass", kind)
            self.add(self.span(node), "return None", "early return")
        elif isinstance(node, ast.Return) and node.value is not None:
            self.add(self.span(node), "return None", "early return")
        elif isinstance(node, (ast.Break, ast.Continue)):
            self.add(self.span(node), "continue" if isinstance(node, ast.Break) else "break", "loop left")

    def visit_FunctionDef(self, node):
        self.names.append(node.name)
        for default in [*node.args.defaults, *node.args.kw_defaults]:
            if default is not None:
                self.visit(default)
        for statement in node.body:
            self.visit(statement)
        self.names.pop()

    visit_AsyncFunctionDef = visit_FunctionDef

    def visit_ClassDef(self, node):
        self.names.append(node.name)
        for statement in node.body:
            self.visit(statement)
        self.names.pop()

    def visit_AnnAssign(self, node):
        if node.value is not None:
            self.visit(node.value)
            if isinstance(node.target, ast.Attribute):
                self.add(self.span(node), "pass", "assignment to a member removed")

    def visit_Assign(self, node):
        if any(isinstance(target, ast.Name) and target.id == "__all__" for target in node.targets):
            return
        self.generic_visit(node)

    def visit_If(self, node):
        if "TYPE_CHECKING" in self.source(node.test):
            return
        self.negate(node.test)
        self.generic_visit(node)

    def visit_While(self, node):
        self.negate(node.test)
        self.generic_visit(node)

    visit_IfExp = visit_While

    def negate(self, test):
        self.add(self.span(test), "not (%s)" % self.source(test), "condition negated")

    def visit_With(self, node):
        if all(item.optional_vars is None for item in node.items):
            first, last = self.span(node)[0], self.span(node.items[-1].context_expr)[1]
            locks = "lock" in self.text[first:last].lower()
            self.add((first, last), "if True", "lock removed" if locks else "context removed")
        self.generic_visit(node)

    def visit_ExceptHandler(self, node):
        if not isinstance(node.body[0], ast.Pass):
            self.add((self.span(node.body[0])[0], self.span(node.body[-1])[1]), "pass", "exception swallowed")
        for statement in node.body:
            self.visit(statement)

    # --- Expressions ----------------------------------------------------------------------------

    def visit_Compare(self, node):
        for left, operator, right in zip([node.left, *node.comparators], node.ops, node.comparators):
            for k, other in enumerate(COMPARISONS[type(operator)]):
                kind = "off by one" if k == 0 and len(COMPARISONS[type(operator)]) == 2 else "comparison flipped"
                self.add_between(left, right, WRITTEN, other, kind)
        self.generic_visit(node)

    def visit_BoolOp(self, node):
        is_and = isinstance(node.op, ast.And)
        for left, right in zip(node.values, node.values[1:]):
            self.add_between(left, right, r"\band\b" if is_and else r"\bor\b", "or" if is_and else "and", "and or or")
        self.generic_visit(node)

    def visit_UnaryOp(self, node):
        if isinstance(node.op, ast.Not):
            self.add(self.span(node), "bool(%s)" % self.source(node.operand), "condition negated")
        elif isinstance(node.op, ast.USub):
            self.add(self.span(node), self.source(node.operand), "operator changed")
        self.generic_visit(node)

    def visit_BinOp(self, node):
        other = ARITHMETIC.get(type(node.op))
        if other:
            self.add_between(node.left, node.right, r"<<|>>|//|[-+*/|&]", other, "operator changed")
        self.generic_visit(node)

    def visit_AugAssign(self, node):
        other = {ast.Add: "-=", ast.Sub: "+="}.get(type(node.op))
        if other:
            self.add_between(node.target, node.value, r"[-+]=", other, "operator changed")
        self.generic_visit(node)

    def visit_Call(self, node):
        args = node.args
        if len(args) >= 2 and not any(isinstance(arg, ast.Starred) for arg in args[:2]):
            begin, end = self.span(args[0])[0], self.span(args[1])[1]
            between = self.text[self.span(args[0])[1] : self.span(args[1])[0]]
            self.add((begin, end), self.source(args[1]) + between + self.source(args[0]), "arguments swapped")
        self.generic_visit(node)

    def visit_Constant(self, node):
        value = node.value
        if isinstance(value, bool):
            self.add(self.span(node), str(not value), "constant changed")
        elif isinstance(value, int):
            self.add(self.span(node), str(value + 1), "constant changed")
            if value > 0:
                self.add(self.span(node), str(value - 1), "constant changed")
        elif isinstance(value, float):
            self.add(self.span(node), repr(2 * value + 1), "constant changed")
        elif isinstance(value, str) and self.names and self.source(node).endswith(('"', "'")):
            end = self.span(node)[1] - 1
            self.add((end, end), "?", "constant changed")
