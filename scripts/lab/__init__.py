"""The laboratory behind scripts/experiments: runs, models, plots, pictures, and one file a group of experiments."""
