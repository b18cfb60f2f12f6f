"""The templates of texts in C++: literals with a place, {}, for each value, as fmt::format or + puts it in."""

import re

TOKEN = re.compile(r"""//[^\n]*|/\*.*?\*/|^[ \t]*\#[^\n]*|R"(?P<raw>\w*)\((?P<text>.*?)\)(?P=raw)"
    |(?P<literal>"(?:[^"\\\n]|\\.)*")|(?P<character>'(?:[^'\\]|\\.)')|\w+|::|->|\+=|\+\+|--|[=!<>]=|<<|&&|\|\||\S""",
                   re.DOTALL | re.MULTILINE | re.VERBOSE)
PLACE = re.compile(r"\{\d*(?::[^{}]*)?\}")
ESCAPES = {"n": "\n", "t": "\t"}
CLOSING = {"(": ")", "[": "]", "{": "}"}
SEPARATORS = {",", ";", "?", ":", "=", "+=", "return", "<<", "==", "!=", "&&", "||", "throw", "case", "else"}


class Text(str):
    """What is in a literal, or in several beside each other."""


def unescaped(literal):
    return Text(re.sub(r"\\(.)", lambda found: ESCAPES.get(found[1], found[1]), literal[1:-1]))


def tokens(source):
    """Words and signs as strings, literals as Text."""
    found = []
    for token in TOKEN.finditer(source):
        word = token[0]
        if token["text"] is not None:
            word = Text(token["text"])
        elif token["literal"] or token["character"]:
            word = unescaped(word)
        elif word.startswith(("//", "/*")) or word.lstrip().startswith("#"):
            continue
        if isinstance(word, Text) and token["literal"] and found and isinstance(found[-1], Text):
            word = Text(found.pop() + word)
        found.append(word)
    return found


def tree(words):
    """The tokens with each bracket and what is in it as one list."""
    top = stack = [[]]
    for word in words:
        if not isinstance(word, Text) and word in CLOSING:
            inner = [word]
            stack[-1].append(inner)
            stack = stack + [inner]
        elif not isinstance(word, Text) and word in CLOSING.values():
            if len(stack) > 1:
                stack = stack[:-1]
        else:
            stack[-1].append(word)
    return top[0]


def split(items, separators):
    parts = [[]]
    for item in items:
        if isinstance(item, str) and not isinstance(item, Text) and item in separators:
            parts.append([])
        else:
            parts[-1].append(item)
    return parts


def text_of(term):
    """The text of a term that is a literal, or one as std::string; None of any other."""
    if len(term) == 1 and isinstance(term[0], Text):
        return term[0]
    if [part for part in term if isinstance(part, str)] in (["std", "::", "string"], ["std", "::", "string_view"]):
        inner = term[-1]
        if isinstance(inner, list) and len(inner) == 2 and isinstance(inner[1], Text):
            return inner[1]
    return None


def template_of(items):
    """The template of a sum, its terms that are no literals as places; None where it has no literal."""
    terms = [term for term in split(items, {"+"}) if term]
    texts = [text_of(term) for term in terms]
    if all(text is None for text in texts):
        return None
    return "".join("{}" if text is None else PLACE.sub("{}", text) for text in texts)


def templates_in(items):
    """All templates of a tree, those in brackets too."""
    for part in split(items, SEPARATORS):
        template = template_of(part)
        if template is not None:
            yield template
        for item in part:
            if isinstance(item, list):
                yield from templates_in(item[1:])


def templates(source):
    return set(templates_in(tree(tokens(source))))
