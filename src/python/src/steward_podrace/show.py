"""Pages and pictures of Steward in a notebook."""

import html
from pathlib import Path


class Page:
    """What a notebook displays: a frame of its own, so that styles and scripts of page and notebook stay apart."""

    def __init__(self, data: str):
        self.data = data

    def _repr_html_(self) -> str:
        return self.data


def show(path: str | Path, width: int = 1000, height: int = 640) -> Page:
    """Puts a page that ``steward replay --view`` wrote, or a moving picture in SVG, into a notebook."""
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
    return Page(
        f'<iframe srcdoc="{html.escape(text)}" width="{width}" height="{height}" '
        'style="border: 0" sandbox="allow-scripts"></iframe>'
    )
