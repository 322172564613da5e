"""Colours, numbers and text that all pictures share."""

import textwrap

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams.update({"font.size": 10, "axes.titlesize": 11, "legend.frameon": False})

# Told apart by lightness too: blue middle, red dark, orange light.
INTACT = "#5b9bd5"
TENSION = "#c00d1e"
SHEAR = "#ffab00"
FAILED = "#4d4d4d"  # where the colour shows stress
MARK = "#333333"
TITLE_SIZE = 11  # points


def format_length(metres):
    """µm below a millimetre, else mm."""
    return f"{metres * 1e6:.3g} µm" if abs(metres) < 1e-3 else f"{metres * 1e3:.3g} mm"


def format_step(step):
    return f"step {step:,}"


def wrap(text, inches, size):
    """Lines that fit this width (a letter is a good half as wide as high)."""
    letters = max(20, int(inches * 72 / (0.56 * size)))
    return "\n".join(textwrap.fill(line, letters) for line in text.split("\n"))


def add_title(figure, text):
    figure.suptitle(wrap(text, figure.get_figwidth(), TITLE_SIZE), fontsize=TITLE_SIZE, va="top",
                    y=1 - 0.1 / figure.get_figheight(), parse_math=False)


def title_height(text, inches):
    """In inches, with some space."""
    return 0.25 + 0.19 * len(wrap(text, inches, TITLE_SIZE).split("\n"))


def caption(result, *more):
    """The small print under a picture; its lines fit the narrowest one."""
    lines = [line for line in more if line]
    if result.local_damping() > 0:
        lines.append(f"Local damping β = {result.local_damping():g}: an addition of RGIMP, "
                     "not part of the published method.")
    if not result.summary:
        lines.append("The run has not ended: summary.json is missing.")
    return lines


def caption_height(lines):
    """In inches, with some space."""
    return 0.12 + 0.14 * len(lines)


def add_caption(figure, lines):
    figure.text(0.01, 0.06 / figure.get_figheight(), "\n".join(lines), fontsize=7.5,
                color="#444444", va="bottom", ha="left")
