"""From a shape to numbers: profiles across the sheet, the whole surface, laser scans."""
