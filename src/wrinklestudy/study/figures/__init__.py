"""What figures share: inputs, style, and measured data drawn over the curves."""
