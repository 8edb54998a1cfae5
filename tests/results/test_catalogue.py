"""The catalogue has a sentence for every note that the package attaches, and none that nobody uses."""

import ast
import re
from functools import cache

from clubface.results.catalogue import SENTENCES
from clubface.results.notes import placeholders
from package_sources import ROOT, trees


@cache
def notes_attached():
    """Every call of ``note`` with a literal code: file, line, code, names of its data, and whether it takes more."""
    result = []
    for path, nodes in trees().items():
        for node in nodes:
            if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "note"):
                continue
            first = node.args[0] if node.args else None
            codes = [first.value] if isinstance(first, ast.Constant) else []
            if isinstance(first, ast.IfExp):
                codes = [each.value for each in (first.body, first.orelse) if isinstance(each, ast.Constant)]
            names = {each.arg for each in node.keywords}
            for code in codes:
                result.append((f"{path}:{node.lineno}", code, names - {None}, None in names))
    return result


def test_every_note_has_its_sentence_and_gives_it_all_it_needs():
    assert len(notes_attached()) > 20
    for place, code, names, takes_more in notes_attached():
        assert code in SENTENCES, f"{place}: the catalogue has no sentence for {code}"
        missing = placeholders(code) - names
        assert takes_more or not missing, f"{place}: the sentence of {code} needs {missing}"


def composed_codes():
    """Patterns of the codes that are put together, such as ``note(f"dispersion-{name}-cause")``.

    A code begins with its subject, so that a text made of variables alone, which would match any code, is none.
    """
    for nodes in trees().values():
        for node in nodes:
            if isinstance(node, ast.JoinedStr) and any(isinstance(each, ast.FormattedValue) for each in node.values):
                parts = [each.value if isinstance(each, ast.Constant) else None for each in node.values]
                if re.match(r"[a-z]+-", parts[0] or "") and re.fullmatch(r"[a-z0-9-]+", "".join(filter(None, parts))):
                    yield "".join("[a-z0-9-]*" if each is None else re.escape(each) for each in parts)


def sentences_left_over(sentences):
    """The codes among them that no file of the package has, whole or put together."""
    text = "\n".join(path.read_text() for path in ROOT.rglob("*.py") if "catalogue" not in path.parts)
    patterns = [re.compile(each) for each in composed_codes()]
    left = [code for code in sentences if code != "text" and f'"{code}"' not in text]
    return [code for code in left if not any(each.fullmatch(code) for each in patterns)]


def test_no_sentence_is_left_over():
    assert sentences_left_over(SENTENCES) == []


def test_a_sentence_that_nobody_uses_is_noticed():
    assert sentences_left_over(["ball-conforms", "no-such-note"]) == ["no-such-note"]


def test_codes_are_names_in_small_letters():
    assert [code for code in SENTENCES if not re.fullmatch("[a-z0-9]+(-[a-z0-9]+)*", code)] == []
