"""Settings of shared errors that are tried beside those that are used, by name: what each changes of them."""

from __future__ import annotations

from typing import Any

VARIANTS: dict[str, dict[str, Any]] = {
    "as used": {},
    "own_spread 0.5": {"own_spread": 0.5},
    "own_spread 2": {"own_spread": 2.0},
    "views: level, no lens": {"views": ((1e-4, 1e-4, 1.0),)},
    "views: twice as many bent and tilted": {"views": ((1e-4, 1e-4, 0.4), (0.01, 0.1, 0.3), (0.02, 1.0, 0.3))},
    "views: half as many": {"views": ((1e-4, 1e-4, 0.85), (0.01, 0.1, 0.075), (0.02, 1.0, 0.075))},
    "class_spread_px 0.03": {"class_spread_px": 0.03},
    "class_spread_px 0.3": {"class_spread_px": 0.3},
    "map_kernels: each by itself": {"map_kernels": ()},
    "map_kernels: twice as much shared": {"map_kernels": ((60.0, 0.5), (2000.0, 0.5))},
    "map_factors: as stated": {"map_factors": (1.0,)},
}
