"""From shapes to numbers: profiles across the sheet, the whole surface, scans."""
