"""What is run at each size. The whole is what the paper shows; everything else leaves the smallest tolerances out."""

SIZES = ("tiny", "quick", "short", "whole")

DELTAS = {
    "fig18": {"tiny": ["6"], "quick": ["1.5"], "short": ["1.5"], "whole": ["0.15", "0.35", "0.9", "1.5"]},
    "fig19": {"tiny": ["8"], "quick": ["2", "8"], "short": ["0.8", "2", "4", "8"],
              "whole": ["0.15", "0.25", "0.4", "0.8", "2", "4", "8"]},
    "fig20": {"tiny": ["8"], "quick": ["3"], "short": ["0.9", "3"], "whole": ["0.1", "0.3", "0.9", "3"]},
}
# Of the run that tells of stages; of normals; of threads.
STAGES = {"tiny": "6", "quick": "1.5", "short": "1.5", "whole": "0.6"}
NORMALS = {"tiny": "8", "quick": "4", "short": "4", "whole": "0.2"}
LUCY = {"tiny": "8", "quick": "2", "short": "0.8", "whole": "0.13"}
THREADS = {"tiny": "8", "quick": "8", "short": "8", "whole": "0.4"}
# Of the mode that keeps to the paper: model, δ in percent, σ/δ. Its time grows with the number of samples.
SAMPLED = {"tiny": ("gallery:sphere", "12", "0.3"), "quick": ("gallery:sphere", "8", "0.2"),
           "short": ("gallery:blob", "8", "0.2"), "whole": ("gallery:bracket", "2", "0.125")}
# Numbers of vertices down to which the collapse without a bound goes.
COUNTS = {"tiny": [200, 100, 50]}
COUNTS_ELSE = [1600, 800, 400, 200, 100, 50]
# Peers that alone would take as long as all the rest of a size, by figure.
LEFT_OUT = {"quick": {"fig20": ("envelope",)}}
UNDULATING = {"tiny": (24, "10"), "quick": (48, "10"), "short": (72, "10"), "whole": (144, "10")}
# Figure 28: number of points, and the cases that are run.
ROBUSTNESS = {
    "tiny": (4000, ("points", "soup")),
    "quick": (6000, ("points", "soup")),
    "short": (40000, ("points", "soup", "noisy points", "noisy soup")),
    "whole": (200000, ("points", "soup", "noisy points", "noisy soup")),
}


def views(model):
    """From where a model is looked at, and what is up."""
    known = {"elephant.off": ((1.0, 0.25, 0.75), (0, 1, 0)), "turbine.off": ((1.0, 0.4, 0.6), (0, 1, 0)),
             "armadillo.off": ((0.2, 0.1, -1.0), (0, 1, 0))}
    return known.get(model, ((0.5, -1.0, 0.8), (0, 0, 1)))
