"""Parts of tools/gpu-check."""
