"""A simulated cell with known truth, for demo, training and tests.

Example:
    >>> from devices.interfaces import Mount
    >>> simulated = build_simulated_cell(seed=1)
    >>> simulated.cell.operator.perform(Mount("ball"))
    >>> simulated.cell.scanner.capture().points_mm.shape[2]
    3
"""

from devices.sim.build import SimulatedCell, Truth, build_simulated_cell
from devices.sim.world import World

__all__ = ["SimulatedCell", "Truth", "World", "build_simulated_cell"]
