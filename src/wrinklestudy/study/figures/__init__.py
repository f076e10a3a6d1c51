"""What figures share: their inputs, one style, measured data laid over them."""
