"""Writes HTML pages about RGIMP output directories."""
