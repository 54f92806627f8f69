"""What algorithms share: base class, parameters, outputs."""
