"""Training of segmentation networks on exported tiles; needs tools/training/requirements.txt, nothing of the plugin."""
