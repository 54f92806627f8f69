"""The sample area: a made-up landscape, its class table, and pictures of it with known truth."""
