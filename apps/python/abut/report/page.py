# SPDX-License-Identifier: BSD-3-Clause
"""Pieces of one HTML page that needs nothing beside itself."""
import base64
import html
import numbers

GENERATOR = '<meta name="generator" content="abut report">'
STYLE = """
body{font:15px/1.5 system-ui,sans-serif;color:#222;background:#f4f5f7;margin:0}
main{max-width:1040px;margin:0 auto;padding:24px 20px 60px}
h1{font-size:26px;margin:8px 0 2px}h2{font-size:19px;margin:0 0 10px}h3{font-size:15px;margin:18px 0 6px}
section{background:#fff;border:1px solid #dfe2e6;border-radius:8px;padding:18px 22px;margin:16px 0}
img{max-width:100%;height:auto;display:block;margin:6px auto}
figure{margin:0 0 14px}figcaption,.note{color:#555;font-size:13.5px}
table{border-collapse:collapse;font-size:14px}td,th{padding:4px 14px 4px 0;text-align:left;vertical-align:top}
th{color:#555;font-weight:600;border-bottom:1px solid #dfe2e6}td.number,th.number{text-align:right;font-variant-numeric:tabular-nums}
.badge{display:inline-block;padding:2px 10px;border-radius:10px;color:#fff;font-size:14px;font-weight:600}
.ok{background:#1e8449}.failed{background:#c0392b}.unknown{background:#7f8c8d}
.reason{border-left:4px solid #c0392b;padding:8px 14px;background:#fdf0ef;white-space:pre-wrap;margin:10px 0}
ul.warnings li{margin:4px 0}pre{font-size:13px;overflow-x:auto;margin:4px 0;white-space:pre-wrap}
.scroll{overflow-x:auto;max-height:420px;overflow-y:auto}
"""


def text(value):
    return html.escape(str(value))


def number(value):
    """Six digits; counts in full."""
    if value is None:
        return "not a number"
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        return text(value)
    return f"{value:,}" if isinstance(value, numbers.Integral) else f"{value:.6g}"


def figure(image, caption, alt):
    data = base64.b64encode(image).decode()
    return (f'<figure><img alt="{text(alt)}" src="data:image/png;base64,{data}">'
            f"<figcaption>{text(caption)}</figcaption></figure>")


def badge(word, kind):
    return f'<span class="badge {kind}">{text(word)}</span>'


def table(head, rows):
    """rows of numbers and text; a cell that is HTML already is given as a list of one."""
    def cell(value, tag="td"):
        if isinstance(value, list):
            return f"<{tag}>{value[0]}</{tag}>"
        is_number = isinstance(value, numbers.Real) and not isinstance(value, bool)
        return f'<{tag}{" class=number" if is_number else ""}>{number(value)}</{tag}>'

    lines = [f"<tr>{''.join(cell(h, 'th') for h in head)}</tr>"] if head else []
    lines += [f"<tr>{''.join(cell(value) for value in row)}</tr>" for row in rows]
    return f'<div class="scroll"><table>{"".join(lines)}</table></div>'


def section(name, title, *parts):
    return f'<section id="{name}"><h2>{text(title)}</h2>{"".join(part for part in parts if part)}</section>'


def page(title, *parts):
    return ('<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            f'{GENERATOR}<meta name="viewport" content="width=device-width, initial-scale=1">'
            f"<title>{text(title)}</title><style>{STYLE}</style></head>\n<body><main>\n"
            + "\n".join(part for part in parts if part) + "\n</main></body></html>\n")
