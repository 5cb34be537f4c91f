"""Runs with their files, many runs at a time, and the paper's figures."""
