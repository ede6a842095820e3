# SPDX-License-Identifier: BSD-3-Clause
"""Signatures and help of the calls, made from the tables of settings."""

import functools
import inspect

from . import _core
from ._inputs import given


def _default(row):
    """The default as a value of Python; Ellipsis: the keyword must be given."""
    kind, text = row["type"], row.get("text")
    if text is None:
        return () if kind.startswith("Sequence") else None if "None" in kind else ""
    if kind == "bool":
        return text == "yes"
    if kind == "Literal" or text == "":
        return text or None
    if kind.startswith("Place"):
        return tuple(map(float, text.split(",")))
    number = (int if kind == "int" else float)(text)
    inside = row["least"] < number < row["most"]
    at_end = (row["takes_least"] and number == row["least"]) or (row["takes_most"] and number == row["most"])
    return number if inside or at_end else ...


FOLLOW = {"drive": {"corner_radius", "rows", "point_spacing", "tolerance", "chord_error"}, "verify": {"corner_radius"}, "project": {"neighbours"}}
FOLLOW |= dict.fromkeys(("ridge", "sections", "cutter_locations"), FOLLOW["drive"])


def table_of(function):
    """One dict for each keyword, with its type and its default."""
    table = [dict(row) for row in _core.tables[function][0]]
    for row in table:
        row["default"] = _default(row)
        if row["name"] in FOLLOW.get(function, ()):  # found from other settings if it is not given
            row |= {"default": None, "zero": "found from others"} | ({} if row["type"] == "Literal" else {"type": row["type"] + " | None"})
        if row["type"] == "Literal":
            row["type"] += str(row["words"].split("|")) + (" | None" if row["default"] is None else "")
    return table


def _line(row):
    """One keyword: type, unit, default, range and meaning."""
    words = [row["type"], row.get("unit"), "required" if row["default"] is ... else f"default {row['default']!r}"]
    if row.get("zero") and not row["default"]:
        words[-1] += f": {row['zero']}"
    if row["type"].startswith(("int", "float")):
        words.append(row["rule"])
    return f"    {row['name']}: {', '.join(filter(None, words))}\n        {row['help']}"


def document(function):
    """Gives a call its signature and its help."""
    table = table_of(function.__name__)
    signature = inspect.signature(function)
    own = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
    only = inspect.Parameter.KEYWORD_ONLY
    keywords = [inspect.Parameter(row["name"], only, default=row["default"], annotation=row["type"]) for row in table]
    call = functools.wraps(function)(lambda *values, **settings: function(*values, **given(table, settings)))
    call.__signature__ = inspect.Signature(own + keywords, return_annotation=signature.return_annotation)
    call.__doc__ = function.__doc__ + "\n\nKeywords:\n" + "\n".join(map(_line, table)) + "\n"
    return call
