"""The symbols of the course. A symbol has one colour in formulas, tables and figures."""

from toolkit.course.pages import Page

#: Symbol -> (colour, what it is, its name in code).
SYMBOLS = {
    "x": ("#1f6fb5", "input: this frame, its pose and its trajectory", "data.inputs[style]"),
    "p": ("#c9701e", "phases of both hands and both feet", "data.phases[style]"),
    "α": ("#c9701e", "gates: shares of the experts, computed from p by the gating network Ω", "model.gating(p)"),
    "z": ("#2f8f5b", "output: the next frame", "data.outputs[style]"),
    "y": ("#b0408a", "style clip: 240 frames of one style", "data.clips[style]"),
    "γ, β": ("#7b3fb5", "scales and shifts of the hidden layers: the style vector, computed from y by the generator Ψ",
             "bank[style]"),
}


def symbols() -> Page:
    """A table of the symbols."""
    rows = "".join(f'<tr><td style="color: {colour}; font: italic 600 18px serif">{name}</td><td style="text-align: left">'
                   f'{text}</td><td style="text-align: left"><code>{code}</code></td></tr>'
                   for name, (colour, text, code) in SYMBOLS.items())
    return Page(f"<table><tr><th>symbol</th><th>what it is</th><th>in code</th></tr>{rows}</table>")
