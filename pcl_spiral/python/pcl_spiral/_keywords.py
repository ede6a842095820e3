# SPDX-License-Identifier: BSD-3-Clause
"""Signatures and help of the calls, made from the tables of settings."""

import functools
import inspect

from . import _core


def default_of(row):
    """The default as it is typed."""
    if row.get("required"):
        return "..."
    return repr(row.get("default", () if row["type"].startswith("Sequence") else None if "None" in row["type"] else ""))


def line_of(row):
    """One keyword: type, unit, default, range and meaning."""
    words = [row["type"]]
    if row.get("unit"):
        words.append(row["unit"])
    if row.get("required"):
        words.append("required")
    elif "default" in row:
        default = row["default"]
        zero = row["zero"] and (default is None or default == 0)
        words.append(f"default {default_of(row)}" + (f": {row['zero']}" if zero else ""))
    if row.get("rule"):
        words.append(row["rule"])
    return f"    {row['name']}: {', '.join(words)}\n        {row['help']}"


def document(function):
    """Gives a call its signature and its help."""
    table = _core.keywords(function.__name__)
    own = [p for p in inspect.signature(function).parameters.values() if p.kind is not p.VAR_KEYWORD]
    keywords = [
        inspect.Parameter(
            row["name"], inspect.Parameter.KEYWORD_ONLY, default=row.get("default", None), annotation=row["type"]
        )
        for row in table
    ]

    @functools.wraps(function)
    def call(*values, **settings):
        return function(*values, **settings)

    call.__signature__ = inspect.Signature(own + keywords)
    call.__doc__ = function.__doc__ + "\n\nKeywords:\n" + "\n".join(line_of(row) for row in table) + "\n"
    return call
