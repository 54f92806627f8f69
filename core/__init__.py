"""The science of SemRef: labels to landmarks to vectors to positions, without QGIS.

Everything here runs from a copy of this folder on any computer with numpy and OpenCV.
Pixel coordinates are (column, row) floats with (0.5, 0.5) at the center of the first pixel.
"""
