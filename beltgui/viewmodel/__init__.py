"""What a screen shows of a step, as plain picklable data: no Qt, no VTK; English texts, translated when shown."""
