"""All experiments by name, in the order of the paper. Each takes the laboratory and the published numbers and gives a
section of the page."""
from lab.experiments import normals, over_delta, over_time, peers, robustness, stages, threads, undulating

EXPERIMENTS = {
    "table1": stages.table1,
    "fig14": stages.fig14,
    "fig18": over_delta.fig18,
    "fig19": over_delta.fig19,
    "fig20": over_delta.fig20,
    "fig21": over_time.fig21,
    "fig22": peers.fig22,
    "fig23": peers.fig23,
    "fig24": peers.fig24,
    "fig25": undulating.fig25,
    "fig26": normals.fig26,
    "fig27": normals.fig27,
    "fig28": robustness.fig28,
    "fig29": threads.fig29,
}
