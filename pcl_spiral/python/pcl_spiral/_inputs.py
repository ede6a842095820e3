# SPDX-License-Identifier: BSD-3-Clause
"""What the user gives, as the module takes it: columns of numbers where they stand, names of files, values of settings."""

import operator
import os
from types import SimpleNamespace

import numpy as np

from ._results import Error


def _refuse(name, value, rule):
    text = repr(value)
    raise TypeError(f"{name}={text if len(text) <= 60 else text[:60] + '...'}: {rule}")


def _array(name, value):
    if np.ma.isMaskedArray(value):  # what is masked is not there, as points that are not finite
        if value.dtype.kind not in "fiu" or name == "faces":
            raise TypeError(f"{name}= is a masked array that has no place for missing values: leave the masked rows out")
        return np.ma.filled(value.astype(np.float64), np.nan)
    try:
        return np.asarray(value)
    except ValueError as error:  # rows of several lengths
        raise TypeError(f"{name}= is no array of numbers ({error}): give a numpy array of shape (N, 3), or the name of a file") from error


def _raise(name, text, id, code="invalid-argument"):
    raise Error(text, id, code, settings=(name,))


def _shape(name, array, remedy):
    _raise(name, f"{name}= has the shape {array.shape}: give {remedy}", f"{name}= has the shape {{name}}: give {remedy}", "invalid-input")


def _numbers(name, array):
    """As float32 or float64 in the order of this machine: itself, or a copy of another type."""
    if array.dtype.kind not in "fiu":
        remedy = f"give float32 or float64, such as {name}.astype(float)"
        raise TypeError(f"{name}= has the type {array.dtype}, which is no number: {remedy}")
    fits = array.dtype.kind == "f" and array.itemsize in (4, 8) and array.dtype.isnative
    return array if fits else array.astype(np.float64)


def _file(name, value):
    if not isinstance(value, (str, os.PathLike)):
        return None
    try:
        file = os.fsdecode(value)
        return file if "\0" not in file and file.encode() else _refuse(name, value, "must be the name of a file")
    except UnicodeEncodeError:
        _refuse(name, value, "must be the name of a file in UTF-8")


def file_of(name, value):
    """The name of a file."""
    return _file(name, value) or _refuse(name, value, "must be the name of a file")


def _columns(name, value, fields=("x", "y", "z")):
    """Three columns of (N, 3), or of a structured array."""
    array = _array(name, value)
    names = array.dtype.names
    if names is None:
        if array.dtype.kind == "O":
            _numbers(name, array)
        if array.ndim != 2 or array.shape[1] != 3:
            _shape(name, array, "(N, 3), one row a point, or an array with fields x, y and z")
        return tuple(_numbers(name, column) for column in array.T)
    for field in fields:
        if field not in names:
            raise TypeError(f"{name}= has no field {field}; it has {names}: give fields {', '.join(fields)}")
        if array.dtype[field].shape != ():
            raise TypeError(f"{name}= has several values in the field {field} of one row: give one number a field")
    return tuple(_numbers(name, array[field].reshape(-1)) for field in fields)


def _normals(name, value):
    columns = _columns(name, value, ("nx", "ny", "nz"))
    lengths = sum(np.abs(column) for column in columns)
    if len(lengths) > 0 and not np.any(np.isfinite(lengths) & (lengths > 0)):
        text = f"{name}= holds no direction"
        _raise(name, f"{text}: all normals are zero or not finite; give normals, or leave {name}= out", text)
    return columns


def _rows(name, value):
    return np.ascontiguousarray(np.column_stack(_columns(name, value)), np.float64)


def place(name, value):
    """Three numbers."""
    return _setting({"name": name, "type": "Place"}, value)


def line(name, value):
    """Points in order: a file, or (N, 3)."""
    return _file(name, value) or _rows(name, value)


def _polygon(name, value):
    """A file, corners (N, 2) or (N, 3), or one row: a box or a place."""
    if _file(name, value):
        return _file(name, value)
    array = np.ascontiguousarray(_numbers(name, _array(name, value)), np.float64)
    row = {"crop": (4, 6), "regions": (3,)}.get(name, ())
    if not (array.ndim == 1 and len(array) in row) and not (array.ndim == 2 and array.shape[1] in (2, 3)):
        _shape(name, array, "corners (N, 2) or (N, 3), or a file")
    return array


def _polygons(name, values):
    """A list of them; one alone is a list, too."""
    if _file(name, values):
        return [_polygon(name, values)]
    try:
        array = np.asarray(values, np.float64)
    except (TypeError, ValueError):  # several of several sizes, or files
        array = np.zeros((0, 0, 0))
    is_one = array.ndim == 2 and array.shape[1] in (2, 3) and not (name == "regions" and array.shape[1] == 3)
    if is_one or (name == "regions" and array.shape == (3,)):
        return [_polygon(name, values)]
    try:
        return [_polygon(name, value) for value in values]
    except TypeError as error:
        if "not iterable" not in str(error):
            raise
        _refuse(name, values, "must be a list of polygons, such as [[(0, 0), (5, 0), (5, 5)]]")


def _holder(name, parts):
    rule = "must be parts of (radius, length) or (lower radius, upper radius, length), upwards, such as [(6, 40), (20, 25, 60)]"
    try:
        parts = [tuple(map(float, part)) for part in parts]
        return [{2: lambda r, length: (r, r, length), 3: lambda *all: all}[len(part)](*part) for part in parts]
    except (TypeError, ValueError, KeyError, OverflowError):
        _refuse(name, parts, rule)


def _faces(name, value):
    if isinstance(value, bool):
        return value
    array = _array(name, value)
    if array.ndim != 2 or array.shape[1] != 3 or array.dtype.kind not in "iu":
        remedy = "give (M, 3) integers, the rows of points= that are the corners, or faces=True for those of a file"
        raise TypeError(f"faces= has the shape {array.shape} and the type {array.dtype}: {remedy}")
    return np.ascontiguousarray(array, np.int64)


def _text(name, value):
    return value if isinstance(value, str) else _refuse(name, value, "must be a text, such as 'G55'")


def _pair(name, value):
    try:
        tip, axis = map(float, value)
        return tip, axis
    except (TypeError, ValueError, OverflowError):
        _refuse(name, value, "must be mm for the tip and degrees for the axis, such as (0.005, 0.1)")


def _as_it_is(name, value):
    return value


def _own(name, stage, method):
    """The method of a stage of the user's own."""
    call = getattr(stage, method, None)
    return call if callable(call) else _refuse(name, stage, f"must have a method {method}(), as pcl_spiral.{name.rstrip('s').title()} has")


def _planner(name, planner):
    plan = _own(name, planner, "plan")

    def run(surface, boundaries, settings):
        made = plan(surface, boundaries, SimpleNamespace(**settings))
        passes = [_rows(name, one) for one in ([made] if isinstance(made, np.ndarray) else made)]
        begins = np.cumsum([len(one) for one in passes])
        return np.concatenate(passes or [np.zeros((0, 3))]), begins[:-1].tolist()

    return run


def _modifier(name, modifier):
    modify = _own(name, modifier, "modify")

    def run(surface, settings, arrays):
        kinds = {key: np.float32 if key in ("axis", "turn", "lift") else np.uint8 if key == "over_gap" else np.float64 for key in arrays}
        path = SimpleNamespace(**{key: np.array(value, kinds[key]) for key, value in arrays.items() if key != "passes"})
        path.passes = arrays["passes"]
        modify(surface, SimpleNamespace(**settings), path)
        for key in ("contact", "normal", "axis", "foot"):
            _rows(name, getattr(path, key))
        given = {key: np.ascontiguousarray(getattr(path, key), kind) for key, kind in kinds.items() if key != "passes"}
        return given | {"passes": list(map(operator.index, path.passes))}

    return run


def passes(name, values):
    """Passes of (position, axis, normal), each (N, 3); without a normal the cutter comes down along its axis."""
    rows = []
    for value in values:
        position, axis, *normal = (_rows(name, column) for column in value if column is not None)
        rows.append((position, axis, normal[0] if normal else np.zeros_like(position)))
        if any(column.shape != position.shape for column in rows[-1]):
            _shape(name, axis, "axes and normals as many as positions")
    return rows


INPUTS = dict(normals=_normals, scan_normals=_normals, faces=_faces, crop=_polygon, keep_outs=_polygons, regions=_polygons)
INPUTS |= dict(holder=_holder, curve=line, rail=line, generator=line, through=line, block_tolerance=_pair, thin_blocks=_pair)
INPUTS |= dict(machine=file_of, work_offset=_text, pass_begin=_text, pass_end=_text, progress=_as_it_is)
INPUTS |= dict(planner=_planner, modifiers=lambda name, values: [_modifier(name, value) for value in values])


def _setting(row, value):
    """The value of a setting by its kind."""
    name, kind = row["name"], row["type"].split()[0]
    rule = {"bool": "must be True or False", "Place": "must be three numbers, such as (0, 0, 1)"}.get(kind) or row["rule"]
    rule = f"must be one of {row['words']}" if kind.startswith("Literal") else rule
    try:
        if kind == "bool" and isinstance(value, (bool, np.bool_)):
            return bool(value)
        if kind == "int" and not isinstance(value, bool):
            return operator.index(value)
        if kind == "float" and not isinstance(value, (str, bytes, bool, np.bool_)):
            return float(value)
        if kind == "Place" and not isinstance(value, str):
            x, y, z = map(float, value)
            return x, y, z
    except (TypeError, ValueError, OverflowError):
        pass
    return value if kind.startswith("Literal") and isinstance(value, str) else _refuse(name, value, rule)


def given(table, settings):
    """The keywords as the module takes them; it refuses those that are none."""
    rows = {row["name"]: row for row in table}

    def one(name, value):
        row = rows.get(name)
        if row is None or (value is None and ("text" not in row or "None" in row["type"])):
            return value
        return _setting(row, value) if "text" in row else INPUTS[name](name, value)

    taken = {name: one(name, value) for name, value in settings.items()}
    return {name: value for name, value in taken.items() if value is not None or name not in rows}


def scan(points, settings, normals="normals"):
    """The points: a file, or columns; with what their fields say of normals, if there is a keyword for these."""
    if points is None or _file("points", points):
        if settings.get(normals) is not None:
            text = f"{normals}= goes with an array of points: a file has its own normals; leave {normals}= out, or read the file yourself"
            _raise(normals, text, f"{normals}= goes with an array of points")
        return points and _file("points", points)
    columns = _columns("points", points)
    if len(columns[0]) == 0:
        _raise("points", "points= is empty: give the points of a scan, (N, 3)", "points= is empty", "invalid-input")
    names = np.asarray(points).dtype.names or ()
    for fields in (("nx", "ny", "nz"), ("normal_x", "normal_y", "normal_z")):
        if normals and settings.get(normals) is None and settings.get("faces") is None and set(fields) <= set(names):
            settings[normals] = _columns("points", points, fields)
    faces = settings.get("faces")
    if isinstance(faces, np.ndarray):
        wrong = np.argwhere((faces < 0) | (faces >= len(columns[0])))[:1]
        for row, corner in wrong:
            remedy = f"but there are {len(columns[0])} points: give rows of points=, from 0"
            text = f"faces= names the point {faces[row, corner]} in row {row}, {remedy}"
            _raise("faces", text, "faces= names the point {name}", "invalid-input")
    return columns
