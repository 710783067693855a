"""A playground as a widget of Jupyter, MyST and marimo."""

from pathlib import Path

import anywidget
import traitlets

HERE = Path(__file__).parent


class Playground(anywidget.AnyWidget):
    """``step``, ``plan``, ``document`` and ``outcome`` are synchronised with what is shown."""

    _esm = HERE / "mo_copp_widget.js"
    #: The element as one script; it is sent with the widget.
    _script = traitlets.Unicode().tag(sync=True)

    problem = traitlets.Unicode("").tag(sync=True)
    hide = traitlets.Unicode("").tag(sync=True)
    theme = traitlets.Unicode("auto").tag(sync=True)
    solver = traitlets.Unicode("").tag(sync=True)
    document = traitlets.Dict(allow_none=True, default_value=None).tag(sync=True)
    plan = traitlets.List(traitlets.Unicode()).tag(sync=True)
    step = traitlets.Int(-1).tag(sync=True)
    outcome = traitlets.Dict(allow_none=True, default_value=None).tag(sync=True)

    @traitlets.default("_script")
    def _read_script(self):
        return (HERE / "mo-copp-playground.single.js").read_text(encoding="utf-8")
