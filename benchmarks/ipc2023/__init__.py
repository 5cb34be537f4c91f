"""The ten domains of the learning track of the International Planning Competition 2023: nppg's policies beside LAMA."""
