"""The generator of the sample area: a made-up landscape, its class table, and pictures of it with known truth."""

DEFAULT_SEED = 1671
"""The paper's number in Remote Sensing; the model that ships has never seen this area."""
