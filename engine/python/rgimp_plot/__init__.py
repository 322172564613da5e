"""Reads and draws RGIMP output directories."""
