"""Pictures of the community's problems."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def draw_convergence(path, curves):
    figure, axes = plt.subplots(figsize=(6, 4), constrained_layout=True)
    for name, lines in curves.items():
        axes.loglog([line["cells"] for line in lines],
                    [line["displacement_error"] for line in lines], "o-", label=name)
    axes.loglog([10, 80], [0.1, 0.1 / 64], "k--", lw=0.8, label="second order")
    axes.set(xlabel="cells a metre", ylabel="displacement error")
    axes.legend(fontsize=7)
    figure.savefig(path, dpi=100)
    plt.close(figure)


def draw_discs(path, history):
    figure, axes = plt.subplots(figsize=(6, 3.5), constrained_layout=True)
    kinetic, strain = history["kinetic_energy_J"], history["strain_energy_J"]
    for values, label in ((kinetic, "kinetic"), (strain, "strain"), (kinetic + strain, "sum")):
        axes.plot(history["time_s"], values, label=label)
    axes.set(xlabel="time, s", ylabel="energy, J", title="Two discs")
    axes.legend()
    figure.savefig(path, dpi=100)
    plt.close(figure)


def draw_cantilever(path, start, end, expected):
    figure, axes = plt.subplots(figsize=(6, 4), constrained_layout=True)
    axes.scatter(*start["position"][:, :2].T, s=1, color="0.8")
    axes.scatter(*end["position"][:, :2].T, s=1, label="particles")
    axes.plot(*expected, "k--", lw=1, label="elastica, centre line")
    axes.set(xlabel="x, m", ylabel="y, m", aspect="equal", title="Cantilever under its weight")
    axes.legend()
    figure.savefig(path, dpi=100)
    plt.close(figure)
