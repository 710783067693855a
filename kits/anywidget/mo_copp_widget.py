"""A playground as a widget of Jupyter, MyST and marimo."""

from pathlib import Path

import anywidget
from traitlets import Bool, Dict, Int, List, Unicode, Union, default

HERE = Path(__file__).parent


def text():
    return Unicode("").tag(sync=True)


def number():
    return Int(None, allow_none=True, min=0).tag(sync=True)


def flag():
    return Bool(False).tag(sync=True)


class Playground(anywidget.AnyWidget):
    """``step``, ``plan``, ``document`` and ``outcome`` are synchronised with what is shown; the others are attributes
    of the element, which follows them."""

    _esm = HERE / "mo_copp_widget.js"
    #: The element as one script; it is sent with the widget.
    _script = Unicode().tag(sync=True)

    document = Dict(allow_none=True, default_value=None).tag(sync=True)
    plan = List(Unicode()).tag(sync=True)
    step = Int(-1).tag(sync=True)
    outcome = Dict(allow_none=True, default_value=None).tag(sync=True)

    problem, src, hide, solver, loading = text(), text(), text(), text(), text()
    theme = Unicode("auto").tag(sync=True)
    #: The attribute ``keys``: every widget has another ``keys``.
    keys_ = text()
    k, j = number(), number()
    horizon = Union([Int(), Unicode()], allow_none=True, default_value=None).tag(sync=True)
    exercise = Union([Dict(), Unicode()], allow_none=True, default_value=None).tag(sync=True)
    seed, student, name = number(), text(), text()
    watch, required, disabled = flag(), flag(), flag()
    worker_url, wasm_url = text(), text()

    def __init__(self, *args, **options):
        unknown = sorted(options.keys() - OPTIONS - OF_ALL_WIDGETS)
        if unknown:
            raise TypeError(f"Playground has no option {', '.join(unknown)}; expected some of {', '.join(sorted(OPTIONS))}")
        super().__init__(*args, **options)

    @default("_script")
    def _read_script(self):
        return (HERE / "mo-copp-playground.single.js").read_text(encoding="utf-8")


OF_ALL_WIDGETS = {"comm", "layout", "model_id", "tabbable", "tooltip"}
#: What may be given and set; the outcome is the solver's.
OPTIONS = {name for name in Playground.class_own_traits() if not name.startswith("_")} - {"outcome"}
