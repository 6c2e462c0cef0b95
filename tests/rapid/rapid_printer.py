"""A syntax tree as RAPID text again. Reading it back gives the same tree; comments and layout are not kept."""

from __future__ import annotations

from collections.abc import Iterable
from math import inf

from trajopt_cli.rapid.language import syntax
from trajopt_cli.rapid.language.expressions import PRIORITY
from trajopt_cli.rapid.language.syntax import Binary, Block, Expression, Number, Statement, Unary

_INDENT = "    "


def print_file(file: syntax.ModuleFile) -> str:
    """All modules of a file, one after the other."""
    return "".join(f"{line}\n" for module in file.modules for line in _module(module))


def print_statement(statement: Statement) -> str:
    """One statement, its lines joined by line feeds."""
    return "\n".join(_statement(statement))


# ---------------------------------------------------------------------------------------------------- expressions


def print_expression(node: Expression) -> str:
    """An expression with no more parentheses than it needs, but for signs, which always get theirs."""
    match node:
        case Number():
            return _number(node.value)
        case syntax.String():
            return _string(node.value)
        case syntax.Boolean():
            return "TRUE" if node.value else "FALSE"
        case syntax.Name() | syntax.Placeholder():
            return node.name
        case syntax.Component():
            return f"{_base(node.base)}.{node.name}"
        case syntax.Element():
            return f"{_base(node.base)}{{{_list(node.indices)}}}"
        case syntax.Call():
            return f"{node.name}({_arguments(node.args)})"
        case syntax.Aggregate():
            return f"[{_list(node.items)}]"
        case Unary():
            operand = print_expression(node.operand)
            bare = not isinstance(node.operand, (Unary, Binary)) and not isinstance(node.operand, Number)
            space = " " if node.operator == "NOT" else ""
            return f"{node.operator}{space}{operand if bare else f'({operand})'}"
        case Binary():
            priority = PRIORITY[node.operator]
            left = _operand(node.left, priority)
            # All operators are left associative: the same priority on the right needs parentheses.
            right = _operand(node.right, priority + 1)
            return f"{left} {node.operator} {right}"


def _operand(node: Expression, priority: int) -> str:
    text = print_expression(node)
    loose = isinstance(node, Unary) or (isinstance(node, Binary) and PRIORITY[node.operator] < priority)
    return f"({text})" if loose or text.startswith("-") else text


def _base(node: Expression) -> str:
    text = print_expression(node)
    return text if isinstance(node, (syntax.Name, syntax.Call, syntax.Component, syntax.Element)) else f"({text})"


def _number(value: float) -> str:
    if abs(value) == inf:  # inside an aggregate, which is looked into only when it is used
        return "1E999" if value > 0 else "-1E999"
    return f"{value:.0f}" if abs(value) < 1e15 and value == int(value) else repr(value)


def _string(value: str) -> str:
    text = value.replace("\\", "\\\\").replace('"', '""')
    return '"' + "".join(c if c >= " " else f"\\{ord(c):02X}" for c in text) + '"'


def _list(nodes: Iterable[Expression]) -> str:
    return ",".join(print_expression(node) for node in nodes)


def _arguments(args: Iterable[syntax.Argument]) -> str:
    return ",".join(_argument(arg) for arg in args)


def _argument(arg: syntax.Argument) -> str:
    value = "" if arg.value is None else print_expression(arg.value)
    if arg.name is None:
        return value if arg.parameter is None else f"{arg.parameter}:={value}"
    if arg.forward:
        return f"\\{arg.name}?{value}"
    return f"\\{arg.name}:={value}" if arg.value is not None else f"\\{arg.name}"


# ----------------------------------------------------------------------------------------------------- statements


def _block(block: Block) -> list[str]:
    return [_INDENT + line for statement in block for line in _statement(statement)]


def _statement(node: Statement) -> list[str]:
    match node:
        case syntax.Assign():
            return [f"{print_expression(node.target)} := {print_expression(node.value)};"]
        case syntax.ProcedureCall():
            return [f"{node.name}{_call(node.args)};"]
        case syntax.LateCall():
            return [f"%{print_expression(node.name)}%{_call(node.args)};"]
        case syntax.If(compact=True):
            condition, body = node.branches[0]
            first, *rest = _statement(body[0])
            return [f"IF {print_expression(condition)} {first}", *rest]
        case syntax.If():
            return _if(node)
        case syntax.For():
            step = f" STEP {print_expression(node.step)}" if node.step is not None else ""
            bounds = f"FROM {print_expression(node.first)} TO {print_expression(node.last)}"
            return [f"FOR {node.name} {bounds}{step} DO", *_block(node.body), "ENDFOR"]
        case syntax.While():
            return [f"WHILE {print_expression(node.condition)} DO", *_block(node.body), "ENDWHILE"]
        case syntax.Test():
            return _test(node)
        case syntax.Goto():
            return [f"GOTO {node.label};"]
        case syntax.Label():
            return [f"{node.name}:"]
        case syntax.Return() | syntax.Raise():
            word = "RETURN" if isinstance(node, syntax.Return) else "RAISE"
            return [f"{word};" if node.value is None else f"{word} {print_expression(node.value)};"]
        case syntax.Simple():
            return [f"{node.word};"]
        case syntax.Connect():
            return [f"CONNECT {print_expression(node.interrupt)} WITH {node.trap};"]
        case syntax.Placeholder():
            return [node.name]
        case syntax.DataDeclaration():
            return [_data(node)]


def _call(args: tuple[syntax.Argument, ...]) -> str:
    if not args:
        return ""
    return ("" if args[0].name is not None else " ") + _arguments(args)


def _if(node: syntax.If) -> list[str]:
    lines: list[str] = []
    for i, (condition, body) in enumerate(node.branches):
        lines += [f"{'ELSEIF' if i else 'IF'} {print_expression(condition)} THEN", *_block(body)]
    if node.otherwise:
        lines += ["ELSE", *_block(node.otherwise)]
    return [*lines, "ENDIF"]


def _test(node: syntax.Test) -> list[str]:
    lines = [f"TEST {print_expression(node.subject)}"]
    for values, body in node.cases:
        lines += [f"CASE {_list(values)}:", *_block(body)]
    if node.default is not None:
        lines += ["DEFAULT:", *_block(node.default)]
    return [*lines, "ENDTEST"]


# --------------------------------------------------------------------------------------------------- declarations


def _module(node: syntax.Module) -> list[str]:
    body = [line for item in node.items for line in _item(item)]
    if not node.name:
        return body
    attributes = f" ({', '.join(node.attributes)})" if node.attributes else ""
    return [f"MODULE {node.name}{attributes}", *(_INDENT + line for line in body), "ENDMODULE"]


def _item(node: syntax.Item) -> list[str]:
    match node:
        case syntax.DataDeclaration():
            return [_data(node)]
        case syntax.RecordDeclaration():
            components = (f"{_INDENT}{type_} {name};" for type_, name in node.components)
            return [f"{_scope(node.scope)}RECORD {node.name}", *components, "ENDRECORD"]
        case syntax.AliasDeclaration():
            return [f"{_scope(node.scope)}ALIAS {node.type} {node.name};"]
        case syntax.Placeholder():
            return [node.name]
        case syntax.Routine():
            return _routine(node)


def _scope(scope: str | None) -> str:
    return f"{scope} " if scope else ""


def _data(node: syntax.DataDeclaration) -> str:
    sizes = f"{{{_list(node.sizes)}}}" if node.sizes else ""
    value = f":={print_expression(node.value)}" if node.value is not None else ""
    return f"{_scope(node.scope)}{node.storage} {node.type} {node.name}{sizes}{value};"


def _routine(node: syntax.Routine) -> list[str]:
    type_ = f"{node.type} " if node.type else ""
    head = f"{_scope(node.scope)}{node.kind} {type_}{node.name}"
    if node.kind != "TRAP":
        head += f"({_parameters(node.parameters)})"
    handlers = (line for handler in node.handlers for line in _handler(handler))
    return [head, *_block(node.body), *handlers, f"END{node.kind}"]


def _handler(node: syntax.Handler) -> list[str]:
    numbers = f" ({_list(node.numbers)})" if node.numbers else ""
    return [f"{node.kind}{numbers}", *_block(node.body)]


def _parameters(parameters: tuple[syntax.Parameter, ...]) -> str:
    text = ""
    for i, parameter in enumerate(parameters):
        text += (" | " if parameter.alternative else ", ") if i else ""
        text += _parameter(parameter)
    return text


def _parameter(node: syntax.Parameter) -> str:
    if not node.type:
        return node.name  # a placeholder
    dimensions = f"{{{','.join('*' * node.dimensions)}}}" if node.dimensions else ""
    mode = f"{node.mode} " if node.mode else ""
    mark = "\\" if node.optional and not node.alternative else ""
    return f"{mark}{mode}{node.type} {node.name}{dimensions}"
