"""One page from all sections, as Markdown and as HTML."""
import csv
import html
import re


class Section:
    """What an experiment has to show, in order."""

    def __init__(self, name, title):
        self.name, self.title = name, title
        self.gist = ""
        self.parts = []
        self.data = None

    def text(self, paragraph):
        self.parts.append(("text", paragraph))

    def table(self, head, rows):
        self.parts.append(("table", head, [[str(cell) for cell in row] for row in rows]))

    def pictures(self, files):
        """`files`: pairs of a file and what it shows."""
        self.parts.append(("pictures", files))

    def csv(self, head, rows):
        self.data = (head, rows)

    def write_csv(self, path):
        with open(path, "w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(self.data[0])
            writer.writerows(["" if cell is None else cell for cell in row] for row in self.data[1])


def markdown(title, preface, sections):
    out = [f"# {title}", ""]
    for paragraph in preface:
        out += [paragraph, ""]
    out += ["| | what comes out |", "| --- | --- |"]
    out += [f"| [{s.name}](#{s.name}) | {s.gist} |" for s in sections] + [""]
    for s in sections:
        out += [f'<a id="{s.name}"></a>', "", f"## {s.title}", ""]
        for part in s.parts:
            if part[0] == "text":
                out += [part[1], ""]
            elif part[0] == "table":
                out.append("| " + " | ".join(part[1]) + " |")
                out.append("| --- |" + " --: |" * (len(part[1]) - 1))
                out += ["| " + " | ".join(row) + " |" for row in part[2]] + [""]
            elif len(part[1]) == 1:
                out += [f"![{part[1][0][1]}]({part[1][0][0]})", ""]
            else:
                out.append("| " + " | ".join(caption for _, caption in part[1]) + " |")
                out.append("|" + " :-: |" * len(part[1]))
                out += ["| " + " | ".join(f"![{caption}]({file})" for file, caption in part[1]) + " |", ""]
        out += [f"Numbers: [{s.name}.csv]({s.name}.csv)", ""]
    return "\n".join(out)


STYLE = """body{font:16px/1.5 Inter,Helvetica,Arial,sans-serif;color:#222;max-width:62rem;margin:2rem auto;padding:0 1rem}
table{border-collapse:collapse;margin:1rem 0}td,th{padding:.25rem .7rem;border-bottom:1px solid #ddd;text-align:right}
td:first-child,th:first-child,.gist td{text-align:left}img{max-width:100%;height:auto}
figure{display:inline-block;margin:.4rem;max-width:23%;text-align:center;font-size:.85rem}figure.wide{max-width:100%}
code{background:#f2f2f2;padding:.1rem .3rem}"""


def inline(text):
    """Code and links of a paragraph; everything else as it is."""
    text = html.escape(text, quote=False)
    text = re.sub(r"`([^`]*)`", r"<code>\1</code>", text)
    return re.sub(r"\[([^\]]*)\]\(([^)]*)\)", r'<a href="\2">\1</a>', text)


def as_html(title, preface, sections):
    def row(kind, cells):
        return "<tr>" + "".join(f"<{kind}>{inline(c)}</{kind}>" for c in cells) + "</tr>"

    def figure(file, caption, wide):
        picture = f'<img src="{html.escape(file)}" alt="{html.escape(caption)}">'
        return f'<figure class="wide">{picture}</figure>' if wide else \
            f"<figure>{picture}<figcaption>{inline(caption)}</figcaption></figure>"

    out = ["<!doctype html>", '<html lang="en"><head><meta charset="utf-8">', f"<title>{html.escape(title)}</title>",
           f"<style>{STYLE}</style></head><body>", f"<h1>{html.escape(title)}</h1>"]
    out += [f"<p>{inline(paragraph)}</p>" for paragraph in preface]
    out.append('<table class="gist">')
    out += [f'<tr><td><a href="#{s.name}">{s.name}</a></td><td>{inline(s.gist)}</td></tr>' for s in sections]
    out.append("</table>")
    for s in sections:
        out.append(f'<h2 id="{s.name}">{html.escape(s.title)}</h2>')
        for part in s.parts:
            if part[0] == "text":
                out.append(f"<p>{inline(part[1])}</p>")
            elif part[0] == "table":
                out.append("<table>" + row("th", part[1]) + "".join(row("td", r) for r in part[2]) + "</table>")
            else:
                out.append("".join(figure(f, c, len(part[1]) == 1) for f, c in part[1]))
        out.append(f'<p>Numbers: <a href="{s.name}.csv">{s.name}.csv</a></p>')
    return "\n".join(out) + "\n</body></html>\n"
