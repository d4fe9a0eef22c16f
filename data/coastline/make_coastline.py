#!/usr/bin/env python3
"""Natural Earth land as TopoJSON on standard input, coastline as CSV on standard output.

    python3 make_coastline.py < land-110m.json > ne_110m_coastline.csv

Edges along the meridian of 180 degrees are where the source cut its polygons, not coast: they are
left out. Longitudes run on across that meridian (179, 181), so that neighbouring points of a line
never differ by more than 180 degrees.
"""
import json
import sys


def decode_arcs(topology):
    """Quantised, delta-coded arcs to lists of (lon, lat)."""
    (scale_x, scale_y), (origin_x, origin_y) = (
        topology["transform"]["scale"], topology["transform"]["translate"])
    arcs = []
    for steps in topology["arcs"]:
        x = y = 0
        arc = []
        for step_x, step_y in steps:
            x += step_x
            y += step_y
            arc.append((round(x * scale_x + origin_x, 2), round(y * scale_y + origin_y, 2)))
        arcs.append(arc)
    return arcs


def rings(topology):
    """The closed rings of all polygons; a negative arc number ~i is arc i reversed."""
    arcs = decode_arcs(topology)
    for geometry in topology["objects"]["land"]["geometries"]:
        for polygon in geometry["arcs"]:
            for ring in polygon:
                points = []
                for i in ring:
                    arc = arcs[i] if i >= 0 else arcs[~i][::-1]
                    points += arc[1:] if points else arc
                yield points


def is_cut(p, q):
    return abs(p[0]) == 180 and abs(q[0]) == 180


def unwrapped(point, previous):
    return (round(point[0] - 360 * round((point[0] - previous[0]) / 360), 2), point[1])


def coast_lines(ring):
    """The ring without the cut edges: one closed line or some open ones."""
    line = [ring[0]]
    for previous, point in zip(ring, ring[1:]):
        if is_cut(previous, point):
            if len(line) > 1:
                yield line
            line = [point]
        elif point != previous:
            line.append(unwrapped(point, line[-1]))
    if len(line) > 1:
        yield line


def main():
    print("line,lon,lat")
    number = 0
    for ring in rings(json.load(sys.stdin)):
        for line in coast_lines(ring):
            for lon, lat in line:
                print(f"{number},{lon:g},{lat:g}")
            number += 1


main()
