"""Figures of the finite elements: impacts, sections, faces, sweeps."""
