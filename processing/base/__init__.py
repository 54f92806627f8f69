"""What every algorithm uses: base class, parameters, values, outputs and workers."""
