"""Finds the texts that core may show, in its sources: literals, and what is put together of literals and values by "+".

A text becomes a template with numbered places, "the diameter is {1}", one for each value; where a value is chosen between
literals ("a ? x : y") there is a template for each. packaging/translations collects them, core knows nothing of it.
"""

import itertools
import re

TOKEN = re.compile(
    r"""
    (?P<space>\s+|//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n\\]|\\\n|\\.)*)
  | (?P<raw>(?:u8|u|U|L)?R"(?P<mark>[^(\s]*)\((?P<body>.*?)\)(?P=mark)")
  | (?P<string>(?:u8|u|U|L)?"(?:[^"\\\n]|\\.)*")
  | (?P<char>'(?:[^'\\\n]|\\.)+')
  | (?P<number>\.?\d(?:'?[\w.]|[eEpP][+-])*)
  | (?P<word>[A-Za-z_]\w*)
  | (?P<op>::|->|\+\+|\+=|&&|\|\||<=|>=|==|!=|<<|[-+*/%<>=!?:;,.&|^~(){}\[\]])
  | (?P<other>.)
    """,
    re.X | re.S | re.M,
)

ESCAPE = re.compile(r"\\(u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|x[0-9a-fA-F]+|[0-7]{1,3}|.)", re.S)
SIMPLE = {"n": "\n", "t": "\t", "r": "\r", "0": "\0"}
MAX_VARIANTS = 24
PLACE = None  # a value among the pieces of a text


def unescape(literal):
    def one(match):
        code = match.group(1)
        if code[0] in "uU" and len(code) > 1:
            return chr(int(code[1:], 16))
        if code[0] == "x":
            return chr(int(code[1:], 16))
        return SIMPLE.get(code, code)

    return ESCAPE.sub(one, literal[literal.index('"') + 1 : -1])


def tokens_of(text):
    """(kind, text, line); neighbouring literals are one."""
    found, line = [], 1
    for match in TOKEN.finditer(text):
        kind, value = match.lastgroup, match.group()
        if match.group("raw") is not None:
            kind, shown = "string", match.group("body")
        elif kind == "string":
            shown = unescape(value)
        else:
            shown = value
        if kind != "space":
            if kind == "string" and found and found[-1][0] == "string":
                found[-1] = ("string", found[-1][1] + shown, found[-1][2])
            else:
                found.append((kind, shown, line))
        line += value.count("\n")
    return found


OPEN, CLOSE = {"(": ")", "[": "]", "{": "}"}, {")": "(", "]": "[", "}": "{"}


class Node:
    """A bracket with what stands in it, or one token."""

    def __init__(self, kind, text, line, inside=None):
        self.kind, self.text, self.line, self.inside = kind, text, line, inside


def tree_of(tokens):
    stack = [[]]
    for kind, text, line in tokens:
        if kind == "op" and text in OPEN:
            stack[-1].append(Node("bracket", text, line, []))
            stack.append(stack[-1][-1].inside)
        elif kind == "op" and text in CLOSE:
            if len(stack) > 1:
                stack.pop()
        else:
            stack[-1].append(Node(kind, text, line))
    return stack[0]


# What ends a chain of "+" at the same depth.
ENDS = {",", ";", "?", ":", "=", "+=", "<<", "&&", "||", "==", "!=", "<=", ">=", "return", "throw", "!", "const", "else"}


def split(nodes, ends):
    parts, current = [], []
    for node in nodes:
        if node.kind in ("op", "word") and node.text in ends:
            parts.append(current)
            current = []
        else:
            current.append(node)
    parts.append(current)
    return parts


def chains(nodes):
    """Every stretch of nodes that may be one expression, at this depth."""
    current = []
    for node in nodes:
        ends = node.kind in ("op", "word") and node.text in ENDS
        if ends or (node.kind == "bracket" and node.text == "{" and not (current and current[-1].kind == "word")):
            if current:
                yield current
            current = []
            if not ends:
                yield [node]
        else:
            current.append(node)
    if current:
        yield current


def has_literal(nodes):
    return any(n.kind == "string" or (n.inside and has_literal(n.inside)) for n in nodes)


def ternary(nodes):
    """The alternatives of "condition ? a : b"; none where it is something else."""
    depth, question = 0, None
    for i, node in enumerate(nodes):
        if node.kind != "op":
            continue
        if node.text == "?":
            if depth == 0 and question is None:
                question = i
            depth += 1
        elif node.text == ":" and question is not None:
            depth -= 1
            if depth == 0:
                return nodes[question + 1 : i], nodes[i + 1 :]
    return None


def choice_in(operand):
    """The bracket of an operand that chooses between texts or joins them; none where it is a value."""
    bracket = None
    if len(operand) == 1 and operand[0].kind == "bracket" and operand[0].text == "(":
        bracket = operand[0]
    elif len(operand) == 4 and [n.text for n in operand[:3]] == ["std", "::", "string"]:
        bracket = operand[3]
    if bracket is None or not bracket.inside or any(n.kind == "op" and n.text == "," for n in bracket.inside):
        return None
    return bracket if has_literal(bracket.inside) and alternatives(bracket.inside) != [[PLACE]] else None


def pieces(operand):
    """What an operand of "+" adds: a list of alternatives, each a list of texts and places."""
    if len(operand) == 1 and operand[0].kind == "string":
        return [[operand[0].text]]
    if len(operand) == 1 and operand[0].kind == "char":
        text = operand[0].text[1:-1]
        return [[SIMPLE.get(text[1:], text[1:]) if text[0] == "\\" else text]]
    bracket = choice_in(operand)
    return alternatives(bracket.inside) if bracket else [[PLACE]]


def alternatives(nodes):
    chosen = ternary(nodes)
    if chosen:
        return alternatives(chosen[0]) + alternatives(chosen[1])
    found = [[]]
    for operand in split(nodes, {"+"}):
        if not operand:
            return [[PLACE]]
        found = [a + b for a, b in itertools.product(found, pieces(operand))]
        if len(found) > MAX_VARIANTS:
            return [[PLACE]]
    return found


def template(parts):
    text, places, last = "", 0, ""
    for part in parts:
        if part is PLACE:
            if last is PLACE and places:
                continue  # two values side by side are one
            places += 1
            text += "{%d}" % places
        else:
            text += part
        if part != "":
            last = part
    return text


def texts(nodes, found):
    told = set()  # brackets whose texts are part of a longer one
    for chain in chains(nodes):
        if any(n.kind == "string" for n in chain) or (
            any(n.kind == "op" and n.text == "+" for n in chain) and has_literal(chain)
        ):
            found_here = alternatives(chain)
            if found_here != [[PLACE]]:
                told.update(id(choice_in(operand)) for operand in split(chain, {"+"}) if choice_in(operand))
            for parts in found_here:
                if any(p is not PLACE for p in parts):
                    found.append((template(parts), chain[0].line))
    for before, node in zip([None] + nodes, nodes):
        if node.inside and id(node) not in told and not (before is not None and before.text == "tr"):
            texts(node.inside, found)


def texts_of(source):
    """(template, line) of everything in a source that is put together of literals."""
    found = []
    texts(tree_of(tokens_of(source)), found)
    return found


PIECE = re.compile(r"[A-Za-z]{3,}.* | .*[A-Za-z]{3,}", re.S)


def pieces_added(source):
    """(literal, line) of sentences' pieces that are added to a text by "+=", so that no template can be made of the whole; but
    for what a sheet says (`say`) by itself."""
    found = []

    def literals(nodes):
        for before, node in zip([None] + nodes, nodes):
            if node.kind == "string" and PIECE.search(node.text):
                yield node
            elif node.inside and not (before is not None and before.text == "say"):
                yield from literals(node.inside)

    def look(nodes):
        for i, node in enumerate(nodes):
            if node.kind == "op" and node.text == "+=":
                rest = itertools.takewhile(lambda n: n.kind != "op" or n.text not in (";", ","), nodes[i + 1 :])
                found.extend((n.text, n.line) for n in literals(list(rest)))
            if node.inside:
                look(node.inside)

    look(tree_of(tokens_of(source)))
    return found


def error_texts_of(source):
    """The same of errors and of what work says it does (Progress::part), where a source has other texts as well."""
    found = []

    def look(nodes):
        for before, node in zip([None] + nodes, nodes):
            if not node.inside:
                continue
            if before is not None and before.text in ("Error", "part") and node.text == "(":
                texts(node.inside, found)
            else:
                look(node.inside)

    look(tree_of(tokens_of(source)))
    return found


def without_comments(source):
    """The source with blanks in place of comments."""
    return TOKEN.sub(
        lambda m: " " if m.lastgroup == "space" and not m.group().isspace() and not m.group().lstrip().startswith("#") else m.group(),
        source,
    )
