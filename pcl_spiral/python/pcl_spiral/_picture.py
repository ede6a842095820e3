# SPDX-License-Identifier: BSD-3-Clause
"""A picture of a path for notebooks, which needs no display: from above and from the side, over the part, coloured by turn."""

import numpy as np

WIDTH, MARGIN, TEXT = 640.0, 12.0, 16.0  # of the picture, of its edge, of a line of text; px
SHOWN_POINTS, SHOWN_PASSES = 5000, 1000  # they keep the picture below 200 kB
CELLS = 160  # of the part along the picture, at most
COLORS = np.array([(68, 1, 84), (59, 82, 139), (33, 145, 140), (94, 201, 97), (163, 201, 26)])  # viridis without its bright end
STEPS = 24  # of the colours
AIR = STEPS  # the colour of what runs over a gap


def _color(step):
    if step == AIR:
        return "#b03030"
    at = step / (STEPS - 1) * (len(COLORS) - 1)
    return "#" + "".join(f"{round(np.interp(at, range(len(COLORS)), channel)):02x}" for channel in COLORS.T)


def _steps(path):
    """The colour of each point."""
    turns = np.asarray(path.turn, float)
    share = (turns - turns.min()) / max(np.ptp(turns), 1e-9)
    return np.where(path.over_gap, AIR, np.minimum((share * STEPS).astype(int), STEPS - 1))


def _thinned(path):
    """Rows of each pass that are shown, its ends among them."""
    passes = path.passes[:: -(-len(path.passes) // SHOWN_PASSES)]
    step = -(-sum(one.stop - one.start for one in passes) // SHOWN_POINTS)
    return [np.append(np.arange(one.start, one.stop - 1, step), one.stop - 1) for one in passes if one.stop > one.start]


def _lines(rows, places, steps):
    """One element for each colour."""
    pieces = {}
    for row in rows:
        cuts = np.flatnonzero(np.diff(steps[row])) + 1
        for begin, end in zip([0, *cuts], [*cuts, len(row) - 1]):
            text = " ".join(f"{x:.1f},{y:.1f}" for x, y in places[row[begin : end + 1]])
            pieces.setdefault(int(steps[row[begin]]), []).append("M" + text)
    return "".join(f'<path d="{"".join(pieces[step])}" stroke="{_color(step)}"/>' for step in sorted(pieces))


def _part(places, cell):
    """Where points of the part are: bars along the picture."""
    cells = np.unique(np.floor(places / cell).astype(np.int64)[:, ::-1], axis=0)
    ends = np.flatnonzero((np.diff(cells[:, 0]) != 0) | (np.diff(cells[:, 1]) != 1))
    bars = zip(cells[np.append(0, ends + 1)], cells[np.append(ends, len(cells) - 1)])
    text = "".join(f"M{x0 * cell:.1f},{y * cell:.1f}h{(x1 - x0 + 1) * cell:.1f}v{cell:.1f}H{x0 * cell:.1f}z" for (y, x0), (_, x1) in bars)
    return f'<path d="{text}" fill="#d8dce2" stroke="none"/>'


def _scale_bar(scale, top):
    """A length of 1, 2 or 5 times a power of ten, at most a quarter of the picture."""
    longest = WIDTH / 4 / scale
    power = 10.0 ** np.floor(np.log10(longest))
    length = max(k * power for k in (1, 2, 5) if k * power <= longest)
    end = MARGIN + length * scale
    bar = f'<path d="M{MARGIN},{top - 4}v8M{MARGIN},{top}H{end:.1f}m0,-4v8" stroke="#222"/>'
    return bar + f'<text fill="#222" x="{end + 6:.1f}" y="{top + 4}">{length:g} mm</text>'


def svg(path, part):
    """An <svg> of at most 200 kB. part: points (N, 3) of the part in the coordinates of the path; there may be none."""
    contacts = path.contact
    edge = 0.06 * np.ptp(contacts, axis=0).max() + 1e-6  # of the part around the path
    low, high = contacts.min(axis=0) - edge, contacts.max(axis=0) + edge
    part, size = part[((part >= low) & (part <= high)).all(axis=1)], high - low
    scale = (WIDTH - 2 * MARGIN) / size.max()  # so that neither picture is higher than wide
    rows, steps = _thinned(path), _steps(path)
    cell = (WIDTH - 2 * MARGIN) / np.clip(np.sqrt(len(part)) / 2, 20, CELLS)
    shapes, top = "", MARGIN
    for axis, name in ((1, "from above: x, y"), (2, "from the side: x, z")):

        def shown(places, axis=axis, top=top + TEXT):
            moved = (places - low) * scale
            return np.column_stack([MARGIN + moved[:, 0], top + size[axis] * scale - moved[:, axis]])

        shapes += f'<text fill="#222" x="{MARGIN}" y="{top + 10:.1f}">{name}</text>' + (_part(shown(part), cell) if len(part) else "")
        shapes += _lines(rows, shown(contacts), steps)
        top += TEXT + size[axis] * scale + MARGIN
    turns = f"turns {path.turn.min():.4g} to {path.turn.max():.4g}, from dark to light; red: over gaps"
    shapes += _scale_bar(scale, top + 4) + f'<text fill="#222" x="{WIDTH / 2}" y="{top + 8:.1f}">{turns}</text>'
    frame = f'width="{WIDTH:g}" height="{top + TEXT + MARGIN:.0f}" font-family="sans-serif" font-size="12" fill="none"'
    return f'<svg xmlns="http://www.w3.org/2000/svg" {frame}>{shapes}</svg>'
