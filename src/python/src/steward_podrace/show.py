"""Pages and pictures of Steward in a notebook."""

import html
from pathlib import Path
from typing import Any


def show(path: str | Path, width: int = 1000, height: int = 640) -> Any:
    """Puts a page that ``steward replay --view`` wrote, or a moving picture in SVG, into a notebook.

    :returns: an object that IPython displays
    """
    for name, value in (("width", width), ("height", height)):
        if not isinstance(value, int) or isinstance(value, bool) or not 1 <= value <= 10_000:
            raise ValueError(f"{name}: found {value!r}, expected a whole number 1..10000")
    try:
        text = Path(path).read_text("utf-8")
    except UnicodeDecodeError:
        raise ValueError(f"{path}: found bytes that are no text, expected a page or an SVG picture") from None
    begin = text.lstrip("\ufeff \r\n\t")[:200].lower()
    if not begin.startswith(("<!doctype html", "<html", "<svg", "<?xml")):
        raise ValueError(f"{path}: found {text[:40]!r}, expected a page or an SVG picture")
    try:
        from IPython.display import HTML
    except ImportError:
        raise ValueError("show: found no IPython, expected to be in a notebook") from None
    # A frame of its own: styles and scripts of page and notebook stay apart.
    return HTML(f'<iframe srcdoc="{html.escape(text)}" width="{width}" height="{height}" '
                'style="border: 0" sandbox="allow-scripts"></iframe>')
