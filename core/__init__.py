"""Mathematics of the cell: pure functions, arrays in, frozen results out; no Qt, no VTK, no devices."""
