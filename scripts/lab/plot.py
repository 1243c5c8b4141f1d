"""Line plots as SVG: axes linear or logarithmic, lines with marks, a legend at the right."""
import math
from xml.sax.saxutils import escape

# Colours that those who confuse red and green tell apart (Okabe and Ito).
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#555555", "#a6761d")
WIDTH, HEIGHT = 760, 420
LEFT, RIGHT, TOP, BOTTOM = 70, 230, 40, 56


class Axis:
    """One direction: its title, its range and where a value lies."""

    def __init__(self, title, values, log, start, end):
        self.title, self.log, self.start, self.end = title, log, start, end
        low, high = (min(values), max(values)) if values else (1, 10)
        if log:
            self.low, self.high = math.log10(low), math.log10(high)
            margin = max(0.04 * (self.high - self.low), 0.05)
        else:
            self.low, self.high = min(low, 0), high
            margin = 0.05 * (self.high - self.low) or 1
        self.high += margin
        if log or low < 0:
            self.low -= margin

    def at(self, value):
        x = math.log10(value) if self.log else value
        return self.start + (x - self.low) / (self.high - self.low) * (self.end - self.start)

    def ticks(self):
        if not self.log:
            step = nice_step((self.high - self.low) / 6)
            first = math.ceil(self.low / step - 1e-9)
            return [i * step for i in range(first, int(self.high / step + 1e-9) + 1)]
        decades = range(math.floor(self.low), math.ceil(self.high) + 1)
        for mantissas in ((1,), (1, 3), (1, 2, 5), range(1, 10)):
            ticks = [m * 10.0 ** d for d in decades for m in mantissas
                     if self.low <= math.log10(m * 10.0 ** d) <= self.high]
            if len(ticks) >= 4:
                break
        return ticks


def nice_step(rough):
    """The next of 1, 2, 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(rough))
    return next(m * power for m in (1, 2, 5, 10) if m * power >= rough * (1 - 1e-9))


def label(value):
    if value >= 1000:
        return f"{value:,.0f}"
    return f"{value:.6g}"


class Line:
    """A series: points in order, whether they are joined, dashed, marked, and which are ringed by a dot."""

    def __init__(self, name, points, dashed=False, marks=None, dots=(), joined=True):
        self.name, self.points, self.dashed, self.joined = name, points, dashed, joined
        self.marks = points if marks is None else marks
        self.dots = list(dots)


def marker(kind, x, y, colour):
    """Shapes tell lines apart where colours do not."""
    if kind == 0:
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.6" fill="{colour}"/>'
    corners = {1: ((-3.4, -3.4), (3.4, -3.4), (3.4, 3.4), (-3.4, 3.4)),
               2: ((0, -4.6), (4.4, 3.4), (-4.4, 3.4)),
               3: ((0, -4.8), (4.8, 0), (0, 4.8), (-4.8, 0))}[kind]
    points = " ".join(f"{x + dx:.1f},{y + dy:.1f}" for dx, dy in corners)
    return f'<polygon points="{points}" fill="{colour}"/>'


def plot(title, x_title, y_title, lines, log_x=False, log_y=False):
    """The SVG as text. Values that a logarithm does not know are left out."""
    def fits(p):
        return (p[0] > 0 or not log_x) and (p[1] > 0 or not log_y)

    everything = [p for line in lines for p in [*line.points, *line.marks, *line.dots] if fits(p)]
    x_axis = Axis(x_title, [p[0] for p in everything], log_x, LEFT, WIDTH - RIGHT)
    y_axis = Axis(y_title, [p[1] for p in everything], log_y, HEIGHT - BOTTOM, TOP)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
           f'viewBox="0 0 {WIDTH} {HEIGHT}" font-family="Inter, Helvetica, Arial, sans-serif" font-size="12">',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
           f'<text x="{LEFT}" y="22" font-size="14" font-weight="600" fill="#222222">{escape(title)}</text>']
    for tick in x_axis.ticks():
        x = x_axis.at(tick)
        out.append(f'<line x1="{x:.1f}" y1="{TOP}" x2="{x:.1f}" y2="{HEIGHT - BOTTOM}" stroke="#e4e4e4"/>')
        out.append(f'<text x="{x:.1f}" y="{HEIGHT - BOTTOM + 17}" text-anchor="middle" fill="#444444">'
                   f'{label(tick)}</text>')
    for tick in y_axis.ticks():
        y = y_axis.at(tick)
        out.append(f'<line x1="{LEFT}" y1="{y:.1f}" x2="{WIDTH - RIGHT}" y2="{y:.1f}" stroke="#e4e4e4"/>')
        out.append(f'<text x="{LEFT - 7}" y="{y + 4:.1f}" text-anchor="end" fill="#444444">{label(tick)}</text>')
    out.append(f'<path d="M{LEFT},{TOP} V{HEIGHT - BOTTOM} H{WIDTH - RIGHT}" fill="none" stroke="#777777"/>')
    middle = (TOP + HEIGHT - BOTTOM) / 2
    out.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 14}" text-anchor="middle" fill="#222222">'
               f'{escape(x_title)}</text>')
    out.append(f'<text transform="translate(17,{middle}) rotate(-90)" text-anchor="middle" fill="#222222">'
               f'{escape(y_title)}</text>')
    for number, line in enumerate(lines):
        colour, kind = COLOURS[number % len(COLOURS)], number % 4
        places = [(x_axis.at(p[0]), y_axis.at(p[1])) for p in line.points if fits(p)]
        dash = ' stroke-dasharray="6 4"' if line.dashed else ""
        if line.joined and len(places) > 1:
            path = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
            out.append(f'<polyline points="{path}" fill="none" stroke="{colour}" stroke-width="1.8"{dash}/>')
        for p in line.marks:
            if fits(p):
                out.append(marker(kind, x_axis.at(p[0]), y_axis.at(p[1]), colour))
        for p in line.dots:
            if fits(p):
                out.append(f'<circle cx="{x_axis.at(p[0]):.1f}" cy="{y_axis.at(p[1]):.1f}" r="8" fill="none" '
                           f'stroke="#cc0000" stroke-width="1.6"/>')
        y = TOP + 10 + 19 * number
        x = WIDTH - RIGHT + 18
        if line.joined:
            out.append(f'<line x1="{x}" y1="{y}" x2="{x + 24}" y2="{y}" stroke="{colour}" stroke-width="1.8"{dash}/>')
        out.append(marker(kind, x + 12, y, colour))
        out.append(f'<text x="{x + 31}" y="{y + 4}" fill="#222222">{escape(line.name)}</text>')
    if any(line.dots for line in lines):
        y = TOP + 10 + 19 * len(lines)
        x = WIDTH - RIGHT + 18
        out.append(f'<circle cx="{x + 12}" cy="{y}" r="7" fill="none" stroke="#cc0000" stroke-width="1.6"/>')
        out.append(f'<text x="{x + 31}" y="{y + 4}" fill="#222222">intersects itself</text>')
    return "\n".join(out) + "\n</svg>\n"
