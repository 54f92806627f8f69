"""Photos to labels by an ONNX network."""
