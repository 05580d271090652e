"""What a screen shows of a step, as plain picklable data: no Qt, no VTK; texts are English and translated when shown."""
