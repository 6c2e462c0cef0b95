"""Chapter 6 of Cihala, Poddajne rizeni prumysloveho robota, CVUT 2020, computed by this package's own engines."""
