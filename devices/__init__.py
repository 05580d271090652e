"""Devices of the cell: what they promise (`interfaces`), simulated ones (`sim`), shared memory and time."""
