"""Cut overlapping polygons into faces that do not overlap: visibility and neighbors without comparing all pairs.

All boundaries are cut at their intersections, on a grid much finer than a pixel, and polygonized. Neighboring faces
then have the same vertices, so that areas add up exactly and a second pass changes nothing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely

from ..landmarks.joining import connected_components

GRID_M = 1e-6
"""Vertices are multiples of this (m): a micrometer. Doubles resolve 10⁻⁹ m at the coordinates of a UTM zone."""


@dataclass(frozen=True)
class PlanarPartition:
    """F faces of N polygons. Polygon ``cover_polygons[k]`` covers face ``cover_faces[k]``.

    Attributes:
        faces: (F,) shapely polygons.
        areas: (F,) m².
        perimeters: (F,) m.
        cover_faces: (K,) int64 indices of faces, ascending.
        cover_polygons: (K,) int64 indices of polygons.
        neighbors: (E, 2) int64 faces that share a border, each pair once.
        border_lengths: (E,) m.
    """

    faces: np.ndarray
    areas: np.ndarray
    perimeters: np.ndarray
    cover_faces: np.ndarray
    cover_polygons: np.ndarray
    neighbors: np.ndarray
    border_lengths: np.ndarray

    def __len__(self) -> int:
        return len(self.faces)

    def top_polygons(self, ranks: np.ndarray) -> np.ndarray:
        """Return the visible polygon of each face.

        Args:
            ranks: (N,) of the polygons, higher ones are on top.

        Returns:
            (F,) int64 indices of polygons, or −1.
        """
        top = np.full(len(self.faces), -1, np.int64)
        order = np.argsort(ranks[self.cover_polygons], kind="stable")
        # Of several values for one index numpy stores the last.
        top[self.cover_faces[order]] = self.cover_polygons[order]
        return top


@dataclass(frozen=True)
class Regions:
    """R regions of connected faces of one class; each may become a landmark.

    Attributes:
        of_face: (F,) int64 region of each face.
        classes: (R,) class values; NOTHING for uncovered regions.
        areas: (R,) m².
        perimeters: (R,) m.
        neighbors: (E, 2) int64 regions that share a border, in both orders.
        border_lengths: (E,) m.
    """

    of_face: np.ndarray
    classes: np.ndarray
    areas: np.ndarray
    perimeters: np.ndarray
    neighbors: np.ndarray
    border_lengths: np.ndarray

    @property
    def mean_widths(self) -> np.ndarray:
        """(R,) m, from 2 · area / perimeter, because a strip of length l and width w has a perimeter of about 2·l."""
        return 2 * self.areas / self.perimeters


def partition_polygons(polygons: np.ndarray) -> PlanarPartition:
    """Cut polygons into their common faces. ``polygons``: (N,) valid shapely polygons, meters."""
    faces = shapely.get_parts(shapely.polygonize(shapely.get_parts(_node(shapely.boundary(polygons)))))
    points = shapely.STRtree(shapely.point_on_surface(faces))
    # Query points with polygons, not the reverse: shapely prepares the geometries that it queries with.
    cover_polygons, cover_faces = points.query(polygons, predicate="contains")
    order = np.lexsort((cover_polygons, cover_faces))
    neighbors, lengths = _shared_borders(faces)
    return PlanarPartition(
        faces, shapely.area(faces), shapely.length(faces), cover_faces[order], cover_polygons[order], neighbors, lengths
    )


def find_regions(partition: PlanarPartition, face_classes: np.ndarray) -> Regions:
    """Join neighboring faces of one class.

    Args:
        partition: F faces.
        face_classes: (F,) class values.
    """
    first, second = partition.neighbors.T
    inside = face_classes[first] == face_classes[second]
    of_face = connected_components(len(partition), partition.neighbors[inside])
    count = int(of_face.max()) + 1 if len(of_face) else 0
    classes = np.zeros(count, face_classes.dtype)
    classes[of_face] = face_classes
    perimeters = np.bincount(of_face, partition.perimeters, count)
    perimeters -= 2 * np.bincount(of_face[first[inside]], partition.border_lengths[inside], count)
    pairs = of_face[partition.neighbors[~inside]]
    neighbors, lengths = _summed_pairs(
        np.concatenate([pairs, pairs[:, ::-1]]), np.tile(partition.border_lengths[~inside], 2), count
    )
    return Regions(of_face, classes, np.bincount(of_face, partition.areas, count), perimeters, neighbors, lengths)


def region_owners(regions: Regions, top: np.ndarray, face_areas: np.ndarray) -> np.ndarray:
    """Return the polygon that visibly covers most of each region, the first of equal ones.

    Args:
        top: (F,) polygon visible on each face, −1 where the region has another class than this polygon.
        face_areas: (F,) m².

    Returns:
        (R,) int64 indices of polygons, or −1.
    """
    owners = np.full(len(regions.classes), -1, np.int64)
    owned = top >= 0
    count = int(top.max(initial=0)) + 1
    keys, place = np.unique(regions.of_face[owned] * count + top[owned], return_inverse=True)
    areas = np.bincount(place.reshape(-1), face_areas[owned], len(keys))
    order = np.lexsort((-keys, areas))
    owners[keys[order] // count] = keys[order] % count
    return owners


def corner_neighbors(partition: PlanarPartition, face_classes: np.ndarray) -> np.ndarray:
    """Return faces of one class that meet in a point while their regions share no border.

    Args:
        partition: F faces.
        face_classes: (F,) class values; faces with a negative one are skipped.

    Returns:
        (E, 2) int64 indices of faces, one pair for each pair of regions.
    """
    of_face = find_regions(partition, face_classes).of_face
    covered = np.flatnonzero(face_classes >= 0)
    coordinates, place = shapely.get_coordinates(partition.faces[covered], return_index=True)
    vertices = np.unique(coordinates.view(np.complex128).reshape(-1), return_inverse=True)[1].reshape(-1)
    faces = covered[place]
    order = np.lexsort((of_face[faces], face_classes[faces], vertices))
    vertices, faces = vertices[order], faces[order]
    first, second = faces[:-1], faces[1:]
    meeting = (vertices[:-1] == vertices[1:]) & (face_classes[first] == face_classes[second])
    meeting &= of_face[first] != of_face[second]
    pairs = np.column_stack([first, second])[meeting]
    return pairs[np.unique(np.sort(of_face[pairs], axis=1), axis=0, return_index=True)[1]] if len(pairs) else pairs


def dissolve(faces: np.ndarray, groups: np.ndarray) -> np.ndarray:
    """Join the faces of each group.

    Args:
        faces: (F,) shapely polygons.
        groups: (F,) group of each face, counted from 0 without gaps.

    Returns:
        (G,) shapely geometries, normalized.
    """
    order = np.argsort(groups, kind="stable")
    bounds = np.searchsorted(groups[order], np.arange(groups.max(initial=-1) + 2))
    dissolved = np.empty(len(bounds) - 1, object)
    for n, (first, last) in enumerate(zip(bounds[:-1], bounds[1:])):
        members = faces[order[first:last]]
        dissolved[n] = members[0] if len(members) == 1 else shapely.union_all(members)
    return shapely.normalize(dissolved)


def _node(lines: np.ndarray) -> shapely.Geometry:
    """Cut lines at their intersections, on the grid. Cuts move lines by less than the grid, so repeat until stable."""
    noded = shapely.union_all(lines, grid_size=GRID_M)
    while True:
        # Few long lines are cut faster than many short ones.
        before = shapely.line_merge(noded)
        noded = shapely.union_all(shapely.get_parts(before), grid_size=GRID_M)
        if _count_segments(noded) == _count_segments(before):
            return noded


def _count_segments(lines: shapely.Geometry) -> int:
    return int(shapely.get_num_coordinates(lines)) - int(shapely.get_num_geometries(lines))


def _shared_borders(faces: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return (E, 2) int64 pairs of faces, first < second, and the (E,) m that they share."""
    rings, face_of_ring = shapely.get_rings(faces, return_index=True)
    coordinates, ring = shapely.get_coordinates(rings, return_index=True)
    vertices = np.unique(coordinates.view(np.complex128).reshape(-1), return_inverse=True)[1].reshape(-1)
    inside = ring[1:] == ring[:-1]
    start, end = vertices[:-1][inside], vertices[1:][inside]
    length = np.hypot(*(coordinates[1:] - coordinates[:-1])[inside].T)
    face = face_of_ring[ring[:-1][inside]]
    segment = np.minimum(start, end) * (len(vertices) + 1) + np.maximum(start, end)
    order = np.argsort(segment, kind="stable")
    shared = np.flatnonzero(segment[order[1:]] == segment[order[:-1]])
    pairs = np.column_stack([face[order[shared]], face[order[shared + 1]]])
    return _summed_pairs(np.sort(pairs, axis=1), length[order[shared]], len(faces))


def _summed_pairs(pairs: np.ndarray, weights: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Return each distinct of the (P, 2) pairs of numbers below ``count``, ordered, with the sum of its weights."""
    keys, place = np.unique(pairs[:, 0] * max(count, 1) + pairs[:, 1], return_inverse=True)
    found = np.column_stack(np.divmod(keys, max(count, 1))).reshape(-1, 2)
    return found, np.bincount(place.reshape(-1), weights, len(keys))
