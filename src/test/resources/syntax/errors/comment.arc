component A { /* never closed }
